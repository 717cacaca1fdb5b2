//! A handful of objects for the [filter](crate::accel::conservative): many rays against one after the other, or one ray
//! against several at once, an object a lane.

use crate::accel::conservative::{ConservativeRay, is_too_short};
use crate::accel::object::{ObjectId, ObjectRef, count};
use crate::accel::target::{ConservativeCylinder, ConservativeSphere};
use crate::geometry::ray::Ray;
use crate::layout::Objects;
use crate::math::vec3::Vec3;
use crate::simd::{LaneMask, SimdF64};

/// Places for objects; every instruction set's lanes divide it.
pub const PLACES: usize = 8;

/// A number of each object.
type Row = [f64; PLACES];

/// The objects by their [ids](crate::accel::object::ObjectId), a place each; places that are left over repeat the first
/// one. A sphere stands among them as a cylinder without an axis, and of any height: for the filter it is one.
#[derive(Clone, Debug)]
pub struct ObjectLanes {
    sphere_count: usize,
    count: usize,
    targets: ConservativeCylinder<Row>,
}

impl ObjectLanes {
    /// The objects, of which those beyond [`PLACES`] are left out, of a scene of this reach.
    pub fn new(objects: &impl Objects, reach: f64) -> Self {
        let sphere_count = objects.sphere_count().min(PLACES);
        let count = count(objects).min(PLACES);
        let target = |id| match ObjectRef::of(objects, id as ObjectId) {
            ObjectRef::Sphere(index) => ConservativeSphere::new(&objects.sphere(index).record).as_cylinder(),
            ObjectRef::Cylinder(index) => ConservativeCylinder::new(&objects.cylinder(index).record, reach),
        };
        let targets = ConservativeCylinder {
            center: rows(count, |id| target(id).center),
            axis: rows(count, |id| target(id).axis),
            radius_squared: row(count, |id| target(id).radius_squared),
            squares: row(count, |id| target(id).squares),
            half_height: row(count, |id| target(id).half_height),
        };
        Self { sphere_count, count, targets }
    }

    /// The objects that one ray may meet: a bit each.
    #[inline(always)]
    pub fn objects_may_hit<V: SimdF64>(&self, ray: &Ray) -> u32 {
        let touch = ConservativeRay::new(Ray { origin: ray.origin.map(V::of), direction: ray.direction.map(V::of) });
        let all = (1 << self.count) - 1;
        if is_too_short(touch.length_squared).bits() != 0 {
            return all;
        }
        let mut touched = 0;
        // Lanes that hold spheres only, and then the others.
        let alike = if self.sphere_count == self.count { self.count } else { self.sphere_count & !(V::LANES - 1) };
        for at in (0..alike).step_by(V::LANES) {
            touched |= touch.sphere(&self.targets.spheres::<V>(at)).bits() << at;
        }
        for at in (alike..self.count).step_by(V::LANES) {
            touched |= touch.cylinder(&self.targets.lanes::<V>(at)).bits() << at;
        }
        touched & all
    }

    /// Whether each of several rays may meet the object at this place. Of no meaning for directions that are
    /// [too short](is_too_short).
    #[inline(always)]
    pub fn touches<V: SimdF64>(&self, at: usize, touch: &ConservativeRay<V>) -> V::Mask {
        let target = self.targets.one::<V>(at);
        if at < self.sphere_count {
            touch.sphere(&ConservativeSphere { center: target.center, radius_squared: target.radius_squared })
        } else {
            touch.cylinder(&target)
        }
    }

    /// The objects that each of several rays may meet; all objects for the lanes of `too_short`, which are bits.
    #[inline(always)]
    pub fn objects_may_hit_lanes<V: SimdF64>(&self, ray: &Ray<V>, too_short: u32) -> MayHitLanes {
        let touch = ConservativeRay::new(*ray);
        let mut touched = MayHitLanes::NOTHING;
        for at in 0..self.count.min(PLACES) {
            touched.add(at, self.touches(at, &touch).bits());
        }
        if too_short != 0 {
            (0..self.count.min(PLACES)).for_each(|at| touched.add(at, too_short));
        }
        touched
    }
}

/// Which of a handful of objects each of several rays may meet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MayHitLanes {
    /// Eight bits an object, one for each ray.
    bits: u64,
    /// The rays that may meet any.
    any: u32,
}

impl MayHitLanes {
    /// No ray may meet any.
    pub const NOTHING: Self = Self { bits: 0, any: 0 };

    /// Adds the object at `id`, which the rays whose bits are set may meet.
    #[inline(always)]
    const fn add(&mut self, id: usize, rays: u32) {
        self.bits |= (rays as u64) << (8 * id);
        self.any |= rays;
    }

    /// The rays that may meet anything, as bits.
    #[inline(always)]
    pub const fn any(&self) -> u32 {
        self.any
    }

    /// The objects that the ray in `lane` may meet: a bit each, by [id](crate::accel::object::ObjectId).
    #[inline(always)]
    pub const fn by(&self, lane: usize) -> u32 {
        const FIRST_OF_EACH: u64 = 0x0101_0101_0101_0101;
        // Moves bit 8 i to bit 56 + i; what it makes besides stays below.
        const TOGETHER: u64 = 0x0102_0408_1020_4080;
        ((self.bits >> lane & FIRST_OF_EACH).wrapping_mul(TOGETHER) >> 56) as u32
    }
}

// No closures here: they would be compiled without the instruction set.
impl ConservativeCylinder<Row> {
    /// The spheres from `at` on, a lane each.
    #[inline(always)]
    fn spheres<V: SimdF64>(&self, at: usize) -> ConservativeSphere<V> {
        ConservativeSphere {
            center: vector_lanes(&self.center, at),
            radius_squared: V::load(&self.radius_squared[at..]),
        }
    }

    /// The objects from `at` on, a lane each.
    #[inline(always)]
    fn lanes<V: SimdF64>(&self, at: usize) -> ConservativeCylinder<V> {
        ConservativeCylinder {
            center: vector_lanes(&self.center, at),
            axis: vector_lanes(&self.axis, at),
            radius_squared: V::load(&self.radius_squared[at..]),
            squares: V::load(&self.squares[at..]),
            half_height: V::load(&self.half_height[at..]),
        }
    }

    /// The object at `at` in every lane.
    #[inline(always)]
    fn one<V: SimdF64>(&self, at: usize) -> ConservativeCylinder<V> {
        ConservativeCylinder {
            center: one_vector(&self.center, at),
            axis: one_vector(&self.axis, at),
            radius_squared: V::of(self.radius_squared[at]),
            squares: V::of(self.squares[at]),
            half_height: V::of(self.half_height[at]),
        }
    }
}

/// A number of each of `count` objects.
fn row(count: usize, number: impl Fn(usize) -> f64) -> Row {
    std::array::from_fn(|place| if count == 0 { 0.0 } else { number(if place < count { place } else { 0 }) })
}

/// A vector of each of `count` objects.
fn rows(count: usize, vector: impl Fn(usize) -> Vec3) -> Vec3<Row> {
    Vec3::new(
        row(count, |index| vector(index).x),
        row(count, |index| vector(index).y),
        row(count, |index| vector(index).z),
    )
}

/// The vectors from `at` on, a lane each.
#[inline(always)]
fn vector_lanes<V: SimdF64>(Vec3 { x, y, z }: &Vec3<Row>, at: usize) -> Vec3<V> {
    Vec3::new(V::load(&x[at..]), V::load(&y[at..]), V::load(&z[at..]))
}

/// The vector at `at` in every lane.
#[inline(always)]
fn one_vector<V: SimdF64>(Vec3 { x, y, z }: &Vec3<Row>, at: usize) -> Vec3<V> {
    Vec3::new(V::of(x[at]), V::of(y[at]), V::of(z[at]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ray_may_meet_the_objects_whose_bits_hold_its_lane() {
        let mut draws = crate::sampling::uniform::Uniform::new(8);
        for _ in 0..2000 {
            let rays: [u32; PLACES] =
                std::array::from_fn(|_| draws.draw(0.0, 256.0) as u32 & draws.draw(0.0, 256.0) as u32);
            let mut touched = MayHitLanes::NOTHING;
            (0..PLACES).for_each(|id| touched.add(id, rays[id]));
            for lane in 0..8 {
                let expected = (0..PLACES).map(|id| (rays[id] >> lane & 1) << id).sum::<u32>();
                assert_eq!(touched.by(lane), expected, "lane {lane} of {rays:?}");
                assert_eq!(touched.any() >> lane & 1 == 1, expected != 0);
            }
        }
    }
}
