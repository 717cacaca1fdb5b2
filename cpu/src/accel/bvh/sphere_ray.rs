//! A sphere ray: a ray prepared for tests against the bounding spheres of a sphere leaf.
//!
//! Let `x` be the vector from the ray's origin to the centre of a bounding sphere with the radius `R`. Let `e` be the
//! unit vector along the ray. The distance between the centre and the line is the length of the cross product of `e`
//! and `x`. Along the ray, the centre is at `b = e . x`. So the ray hits the bounding sphere only if that length is at
//! most `R`. It enters at a distance of at least `b - R`, and leaves at a distance of at most `b + R`. The quadratic
//! formula would lose more digits, because it subtracts two squares of distances.
//!
//! Let `u = 2^-24`, and let `o` be the ray's origin. `M` is the sum of `|o|` and `P` over the three axes, where `P` is
//! the largest magnitude of a plane of the scene along the axis. So `|x| <= M` and `R <= M`, apart from the step of up
//! to a 127th of a node by which bytes may move a centre or a radius. The test decides about three things: the
//! distance from the line, the entry and the exit. `tests/stability/src/proof/boxes.rs` proves that they need margins
//! of less than `31 u M`, `22 u M` and `15 u M`, with the steps of bytes. The code enlarges each radius by `32 u M`. So
//! the test never discards a bounding sphere that the ray hits before the closest hit so far.
//!
//! What happens at extreme magnitudes? Coordinates are at most 10^9, or 10^17 if the ray starts on a giant, so no
//! square overflows. The squared length of a direction may overflow to infinity. Then `e` and the reciprocal are 0, and
//! every bounding sphere counts as hit. This is slow but right. The margin is at least 6 10^-10, so no square of a
//! radius underflows.

use crate::accel::bvh::slab_ray::margin;
use crate::accel::bvh::{planes::PlaneNumber, planes::WIDTH, sphere_leaf::SphereLeaf};
use crate::{geometry::ray::Ray, math::real::Real, simd::SimdF32};

/// A ray prepared for tests against the bounding spheres of a [`SphereLeaf`].
#[derive(Clone, Copy, Debug)]
pub struct SphereRay {
    origin: [f32; 3],
    /// The unit vector along the ray.
    along: [f32; 3],
    /// The reciprocal of the direction's length, which makes a lambda of a distance.
    reciprocal: f32,
    /// The margin that covers rounding, in scene units. It is added to each radius.
    margin: f32,
}

impl SphereRay {
    /// A ray that is never tested, for trees without sphere leaves.
    pub const UNUSED: Self = Self { origin: [0.0; 3], along: [0.0; 3], reciprocal: 0.0, margin: 0.0 };

    /// Prepares the ray for a tree with these [margins](crate::accel::bvh::slab_ray::margins). `length_squared` is the
    /// square of the direction's length.
    #[inline(always)]
    pub fn new(ray: &Ray, margins: &[f32; 3], length_squared: f64) -> Self {
        let origin = ray.origin.to_array().map(|coordinate| coordinate as f32);
        let direction = ray.direction.to_array().map(|component| component as f32);
        let (along, reciprocal) = unit(direction, length_squared as f32);
        Self { origin, along, reciprocal, margin: enlargement(origin, *margins) }
    }

    /// Returns 16 bits. Bit `i` is 1 if the ray hits bounding sphere `i` at a lambda of at most `farthest`. It may also
    /// be 1 if the ray just misses it. For each bounding sphere that is hit, stores a lower bound of the lambda at
    /// which the ray enters it. This is at most 0 if the ray starts inside. If there are fewer bounding spheres, the
    /// caller must ignore the other bits.
    #[inline(always)]
    pub fn intersect<P: PlaneNumber, F: SimdF32>(
        &self,
        leaf: &SphereLeaf<'_, P>,
        farthest: f32,
        distances: &mut [f32; WIDTH],
    ) -> u32 {
        let [e_x, e_y, e_z] = self.along;
        let (e_x, e_y, e_z) = (F::splat(e_x), F::splat(e_y), F::splat(e_z));
        let mut bits = 0;
        for at in (0..WIDTH).step_by(F::LANES) {
            let ([x, y, z], radius) = leaf.load::<F>(at, &self.origin);
            let radius = radius + F::splat(self.margin);
            let [cross_x, cross_y, cross_z] = cross([x, y, z], [e_x, e_y, e_z]);
            // The third square is subtracted on the other side, so that the processor computes both sides at once.
            let two_squares = cross_x.mul_add(cross_x, cross_y * cross_y);
            let rest = cross_z.negative_mul_add(cross_z, radius * radius);
            let center_along = x.mul_add(e_x, y.mul_add(e_y, z * e_z));
            let (enters, leaves) = ((center_along - radius) * F::splat(self.reciprocal), center_along + radius);
            enters.store(&mut distances[at..]);
            let in_range = F::splat(0.0).less_equal(leaves) & enters.less_equal(F::splat(farthest));
            bits |= (two_squares.less_equal(rest) & in_range) << at;
        }
        bits
    }
}

/// Returns the unit vector along the ray, and the reciprocal of the direction's length.
#[inline(always)]
pub fn unit<T: Real>(direction: [T; 3], length_squared: T) -> ([T; 3], T) {
    let reciprocal = T::of(1.0) / length_squared.sqrt();
    (direction.map(|component| component * reciprocal), reciprocal)
}

/// Returns the margin of radii. That of slabs is `16 u`, and the head of this module asks for twice as much.
#[inline(always)]
pub fn enlargement<T: Real>(origin: [T; 3], margins: [T; 3]) -> T {
    let [x, y, z] = [0, 1, 2].map(|axis| T::of(2.0) * margin(origin[axis], margins[axis]));
    x + y + z
}

/// Returns the cross product of the unit vector along the ray and the vector to a centre.
#[inline(always)]
pub fn cross<F: SimdF32>([x, y, z]: [F; 3], [e_x, e_y, e_z]: [F; 3]) -> [F; 3] {
    [z.negative_mul_add(e_y, y * e_z), x.negative_mul_add(e_z, z * e_x), y.negative_mul_add(e_x, x * e_y)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn radii_get_twice_the_margins_of_the_slabs() {
        // The sum of the coordinates' magnitudes is 3, and that of the margins 3/2.
        let expected = 2.0 * (3.0 * 2.0_f64.powi(-20) + 1.5);
        assert_eq!(enlargement([1.0, -2.0, 0.0], [0.5; 3]), expected);
    }
}
