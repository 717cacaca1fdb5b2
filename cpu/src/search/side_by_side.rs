//! A handful of objects for the [filter](super::touch): many rays against one after the other, or one ray against several
//! at once, an object a lane.

use super::touch::{CylinderTarget, SphereTarget, Touch};
use crate::layout::Objects;
use crate::ray::Ray;
use crate::simd::{LaneMask, Lanes};
use crate::vec3::Vec3;

/// Places for objects of a kind; every instruction set's lanes divide it.
const PLACES: usize = super::few::CAPACITY;

/// A number of each object of a kind.
type Row = [f64; PLACES];

/// The objects, a place each; places that are left over repeat the first one.
#[derive(Clone, Debug)]
pub struct SideBySide {
    sphere_count: usize,
    spheres: SphereTarget<Row>,
    cylinder_count: usize,
    cylinders: CylinderTarget<Row>,
}

impl SideBySide {
    /// The objects, of each kind at most [`PLACES`], of a scene of this reach.
    pub fn new(objects: &impl Objects, reach: f64) -> Self {
        let sphere_count = objects.sphere_count();
        let sphere = |index| SphereTarget::new(&objects.sphere(index).record);
        let spheres = SphereTarget {
            center: rows(sphere_count, |index| sphere(index).center),
            radius_squared: row(sphere_count, |index| sphere(index).radius_squared),
        };
        let cylinder_count = objects.cylinder_count();
        let cylinder = |index| CylinderTarget::new(&objects.cylinder(index).record, reach);
        let cylinders = CylinderTarget {
            center: rows(cylinder_count, |index| cylinder(index).center),
            axis: rows(cylinder_count, |index| cylinder(index).axis),
            radius_squared: row(cylinder_count, |index| cylinder(index).radius_squared),
            squares: row(cylinder_count, |index| cylinder(index).squares),
            half_height: row(cylinder_count, |index| cylinder(index).half_height),
        };
        Self { sphere_count, spheres, cylinder_count, cylinders }
    }

    /// The objects that one ray may meet: a bit each by its [id](super::ObjectId).
    #[inline(always)]
    pub fn touched_by_one<V: Lanes>(&self, ray: &Ray) -> u32 {
        let touch = Touch::new(Ray { origin: ray.origin.map(V::of), direction: ray.direction.map(V::of) });
        let (mut spheres, mut cylinders) = (0, 0);
        for at in (0..self.sphere_count).step_by(V::LANES) {
            spheres |= touch.sphere(&self.spheres.lanes::<V>(at)).bits() << at;
        }
        for at in (0..self.cylinder_count).step_by(V::LANES) {
            cylinders |= touch.cylinder(&self.cylinders.lanes::<V>(at)).bits() << at;
        }
        let first = |count: usize| (1_u32 << count) - 1;
        (spheres & first(self.sphere_count)) | (cylinders & first(self.cylinder_count)) << self.sphere_count
    }

    /// The objects that each of several rays may meet: the sum of 2^[id](super::ObjectId).
    #[inline(always)]
    pub fn touched_by_each<V: Lanes>(&self, ray: &Ray<V>) -> V {
        let touch = Touch::new(*ray);
        let mut touched = V::of(0.0);
        let mut weight = 1.0;
        for at in 0..self.sphere_count.min(PLACES) {
            let touches = touch.sphere(&self.spheres.one::<V>(at));
            touched = touched + V::select(touches, V::of(weight), V::of(0.0));
            weight += weight;
        }
        for at in 0..self.cylinder_count.min(PLACES) {
            let touches = touch.cylinder(&self.cylinders.one::<V>(at));
            touched = touched + V::select(touches, V::of(weight), V::of(0.0));
            weight += weight;
        }
        touched
    }
}

// No closures here: they would be compiled without the instruction set.
impl SphereTarget<Row> {
    /// The spheres from `at` on, a lane each.
    #[inline(always)]
    fn lanes<V: Lanes>(&self, at: usize) -> SphereTarget<V> {
        SphereTarget { center: vector_lanes(&self.center, at), radius_squared: V::load(&self.radius_squared[at..]) }
    }

    /// The sphere at `at` in every lane.
    #[inline(always)]
    fn one<V: Lanes>(&self, at: usize) -> SphereTarget<V> {
        SphereTarget { center: one_vector(&self.center, at), radius_squared: V::of(self.radius_squared[at]) }
    }
}

impl CylinderTarget<Row> {
    /// The cylinders from `at` on, a lane each.
    #[inline(always)]
    fn lanes<V: Lanes>(&self, at: usize) -> CylinderTarget<V> {
        CylinderTarget {
            center: vector_lanes(&self.center, at),
            axis: vector_lanes(&self.axis, at),
            radius_squared: V::load(&self.radius_squared[at..]),
            squares: V::load(&self.squares[at..]),
            half_height: V::load(&self.half_height[at..]),
        }
    }

    /// The cylinder at `at` in every lane.
    #[inline(always)]
    fn one<V: Lanes>(&self, at: usize) -> CylinderTarget<V> {
        CylinderTarget {
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
fn vector_lanes<V: Lanes>(Vec3 { x, y, z }: &Vec3<Row>, at: usize) -> Vec3<V> {
    Vec3::new(V::load(&x[at..]), V::load(&y[at..]), V::load(&z[at..]))
}

/// The vector at `at` in every lane.
#[inline(always)]
fn one_vector<V: Lanes>(Vec3 { x, y, z }: &Vec3<Row>, at: usize) -> Vec3<V> {
    Vec3::new(V::of(x[at]), V::of(y[at]), V::of(z[at]))
}
