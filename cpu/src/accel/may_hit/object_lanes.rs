//! Up to eight objects for the [conservative tests](crate::accel::may_hit::conservative). Either each lane holds a ray
//! and the objects are tested in turn, or each lane holds an object and one ray is tested.

use crate::accel::{
    may_hit::conservative::ConservativeRay, may_hit::conservative::is_too_short, may_hit::target::Target,
    object::ObjectId, object::count,
};
use crate::{geometry::ray::Ray, layout::Objects, simd::SimdF64, simd::columns::Columns};

/// Maximum number of objects in [`ObjectLanes`]. It is a multiple of every instruction set's number of lanes of `f64`.
pub const PLACES: usize = 8;

/// Up to [`PLACES`] objects, in the order of their [numbers](ObjectId), one at each place. If a scene has fewer
/// objects, the remaining places repeat them.
#[derive(Clone, Debug)]
pub struct ObjectLanes {
    sphere_count: usize,
    count: usize,
    targets: Columns<{ Target::NUMBERS }, PLACES>,
}

impl ObjectLanes {
    /// Returns the first [`PLACES`] objects of a scene with this largest coordinate.
    pub(crate) fn new(objects: &impl Objects, max_coordinate: f64) -> Self {
        let (sphere_count, count) = (objects.sphere_count().min(PLACES), count(objects).min(PLACES));
        let mut targets = Columns::ZERO;
        for (place, id) in (0..count as ObjectId).cycle().take(PLACES).enumerate() {
            targets.set(place, Target::of(objects, id, max_coordinate).numbers());
        }
        Self { sphere_count, count, targets }
    }

    /// Returns a bit for each object, which is 1 if the ray may hit the object.
    #[inline(always)]
    pub(crate) fn objects_may_hit<V: SimdF64>(&self, ray: &Ray) -> u32 {
        let conservative = ConservativeRay::new(ray.lanes::<V>());
        let all = (1 << self.count) - 1;
        if V::bits(is_too_short(conservative.length_squared)) != 0 {
            return all;
        }
        let mut may_hit = 0;
        // The groups of lanes that hold only spheres are tested first, then the other groups.
        let spheres = if self.sphere_count == self.count { self.count } else { self.sphere_count & !(V::LANES - 1) };
        for at in (0..spheres).step_by(V::LANES) {
            may_hit |= V::bits(conservative.sphere(&Target::of_numbers(self.targets.load(at)))) << at;
        }
        for at in (spheres..self.count).step_by(V::LANES) {
            may_hit |= V::bits(conservative.cylinder(&Target::of_numbers(self.targets.load(at)))) << at;
        }
        may_hit & all
    }

    /// Returns, for each lane, whether its ray may hit the object with the number `at`. The result has no meaning for
    /// directions that are [too short](is_too_short).
    #[inline(always)]
    pub(crate) fn may_hit<V: SimdF64>(&self, at: usize, conservative: &ConservativeRay<V>) -> V::Mask {
        // Only the numbers that a kind of object needs are broadcast.
        if at < self.sphere_count {
            conservative.sphere(&Target::of_numbers(self.targets.get(at)).lanes())
        } else {
            conservative.cylinder(&Target::of_numbers(self.targets.get(at)).lanes())
        }
    }

    /// Returns the objects that each of several rays may hit. For a lane whose bit is set in `too_short`, these are all
    /// objects. The caller must set the bit of every lane whose direction is [too short](is_too_short).
    #[inline(always)]
    pub(crate) fn objects_may_hit_lanes<V: SimdF64>(&self, ray: &Ray<V>, too_short: u32) -> MayHitLanes {
        let conservative = ConservativeRay::new(*ray);
        debug_assert!(V::bits(is_too_short(conservative.length_squared)) & !too_short == 0);
        let mut may_hit = MayHitLanes::NOTHING;
        for at in 0..self.count.min(PLACES) {
            may_hit.add(at, V::bits(self.may_hit(at, &conservative)) | too_short);
        }
        may_hit
    }
}

/// For each of up to eight rays, which of up to eight objects it may hit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MayHitLanes {
    /// Eight bits for each object, one of them for each ray.
    bits: u64,
    /// A bit for each ray, which is 1 if the ray may hit at least one object.
    pub any: u32,
}

impl MayHitLanes {
    /// The value for rays that can hit no object.
    pub const NOTHING: Self = Self { bits: 0, any: 0 };

    /// Adds the object with the number `id`. The rays whose bits are set in `rays` may hit it.
    #[inline(always)]
    const fn add(&mut self, id: usize, rays: u32) {
        self.bits |= (rays as u64) << (8 * id);
        self.any |= rays;
    }

    /// Returns a bit for each object, by its [number](ObjectId). The bit is 1 if the ray in `lane` may hit the object.
    #[inline(always)]
    pub(crate) const fn of_lane(&self, lane: usize) -> u32 {
        const FIRST_BIT_OF_EACH: u64 = 0x0101_0101_0101_0101;
        // The product moves bit 8 i to bit 56 + i. All other bits of the product stay below bit 56.
        const GATHER: u64 = 0x0102_0408_1020_4080;
        ((self.bits >> lane & FIRST_BIT_OF_EACH).wrapping_mul(GATHER) >> 56) as u32
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ray_may_hit_the_objects_whose_bits_hold_its_lane() {
        let mut draws = crate::sampling::uniform::Uniform::new(8);
        for _ in 0..2000 {
            let rays: [u32; PLACES] =
                std::array::from_fn(|_| draws.draw(0.0, 256.0) as u32 & draws.draw(0.0, 256.0) as u32);
            let mut may_hit = MayHitLanes::NOTHING;
            (0..PLACES).for_each(|id| may_hit.add(id, rays[id]));
            for lane in 0..8 {
                let expected = (0..PLACES).map(|id| (rays[id] >> lane & 1) << id).sum::<u32>();
                assert_eq!(may_hit.of_lane(lane), expected, "lane {lane} of {rays:?}");
                assert_eq!(may_hit.any >> lane & 1 == 1, expected != 0);
            }
        }
    }
}
