//! A ray prepared for slab tests, which find the boxes that the ray hits.
//!
//! The boxes of a node are tested at once, in single precision. Along each axis, a plane at the coordinate `p` has the
//! distance `p r - o r`, with the reciprocal `r` of the direction and the origin `o`. The distance is a lambda. Boxes
//! of bytes store `p` as `f + n s`, with the origin `f` of their frame, the step `s`, and the plane's number `n`. Then
//! the distance is computed as `n (s r) + (f r - o r)`.
//!
//! Let `u = 2^-24`, and let `P` be the largest magnitude of a plane of the scene along the axis, so that `|f| <= P`
//! and `n s <= 2 P` and a step, a 127th of the node's length. `tests/stability/src/proof/boxes.rs` proves that rounding
//! changes the distance by less than `14 u (P + |o|) |r|`, whether products and sums are fused or not. `s r` is exact
//! unless it is subnormal, because `s` is a power of two. The boxes were built in double precision, which moved their
//! planes by at most `2^-51 P`. The code moves the distance by at least `16 u (P + |o|) |r|`, towards the side on
//! which the box is hit. So the computed distance of a plane where the ray enters is not too large. The computed
//! distance of a plane where it leaves is not too small.
//!
//! A ray that hits a box enters all three slabs before it leaves one of them. This is then also true for the computed
//! distances. So no box is lost that the ray hits before the closest hit so far. Nor is an object left out that can be
//! hit before it, for being entered behind it.
//!
//! The direction must be [in scale](suits_slabs). Then reciprocals have magnitudes between 10^-31 and 10^28, and no
//! product with a coordinate exceeds 10^38, unless the ray starts on a giant ([`is_in_reach`]). If a distance is NaN
//! all the same, the maximum and the minimum return their other operand, which keeps the box. Products may be
//! subnormal, which changes a distance by less than [`LEAST_MARGIN`] times `r`.

use crate::accel::bvh::planes::{PlaneNumber, Planes, WIDTH};
use crate::accel::{bounds::Bounds, extent::is_within, may_hit::conservative::is_too_short};
use crate::{geometry::ray::Ray, math::real::Real, math::vec3::Vec3, simd::SimdF32};

/// A slab test moves each plane of a box outward to cover rounding. Along the x axis it moves a plane by at least
/// `PLANE_MARGIN (|o| + p)`. Here `o` is the x coordinate of the ray's origin, and `p` is the largest `|x|` of all
/// boxes. The same holds for y and z. `PLANE_MARGIN` is `16 u`, where `u = 2^-24` is the unit roundoff of `f32`.
pub const PLANE_MARGIN: f32 = 8.0 * f32::EPSILON;

/// The largest magnitude of a reciprocal. Its product with a coordinate of a
/// [moderate](crate::accel::extent::Extent::moderate) scene cannot overflow.
pub const LARGEST_RECIPROCAL: f32 = 1e28;

/// The smallest distance by which a plane is moved, in scene units. If a component of the direction is so small that
/// its reciprocal is limited to [`LARGEST_RECIPROCAL`], this move is a lambda of 10^18. For a direction that is not
/// [too short](is_too_short), that exceeds the lambda of every plane across the direction's largest component. So a
/// slab that contains such a ray never excludes it.
pub const LEAST_MARGIN: f32 = 1e-10;

/// The square of the largest length of a direction for which boxes are tested. This length is 10^30. A component above
/// the largest `f32`, 3.4 10^38, would round to infinity, and its reciprocal would be zero.
pub const LONGEST_SQUARED: f64 = 1e60;

/// Whether a direction is in scale for slab tests: the square of its length is at least 10^-14 and at most 10^60. The
/// result is false for NaN.
#[inline(always)]
pub(crate) fn suits_slabs(length_squared: f64) -> bool {
    !is_too_short(length_squared) && length_squared <= LONGEST_SQUARED
}

/// The largest coordinate of an origin for a direction of length 1.
pub const FARTHEST: f64 = 1e17;

/// Whether a ray that is [in scale](suits_slabs) starts near enough for slab tests, and for those of sphere leaves:
/// `|o| <= 10^17 min(|d|, 1)`. A ray that starts on a [giant](crate::accel::giants) may start farther away.
///
/// Such a ray is at all planes across its direction's largest component before lambda 10^18; see [`LEAST_MARGIN`]. If
/// `o r` overflows along an axis, `|o|` exceeds all planes, and `|d|` along the axis is below `10^-20`. So the ray does
/// not reach the planes before lambda 10^30, and there it is far from all planes across the largest component. It hits
/// no box, and infinite distances exclude all boxes, or they are NaN and keep them.
pub(crate) fn is_in_reach(origin: Vec3, length_squared: f64) -> bool {
    is_within(origin, FARTHEST * length_squared.sqrt().min(1.0))
}

/// Returns, for each axis, the part of a plane's move that does not depend on the ray: `PLANE_MARGIN |p| +
/// LEAST_MARGIN`, where `p` is the plane of `bounds` with the larger magnitude. It serves all boxes within `bounds`.
pub(crate) fn margins(bounds: &Bounds) -> [f32; 3] {
    let farthest = |axis: usize| bounds.low[axis].abs().max(bounds.high[axis].abs());
    [0, 1, 2].map(|axis| margin(farthest(axis), LEAST_MARGIN))
}

/// Returns the move of a plane, which has the part `least`, for the ray's origin or the farthest plane at `coordinate`.
#[inline(always)]
pub fn margin<T: Real>(coordinate: T, least: T) -> T {
    coordinate.abs() * T::of(f64::from(PLANE_MARGIN)) + least
}

/// Returns the distance of the plane at the coordinate 0, moved down and moved up. `magnitude` is that of `reciprocal`.
#[inline(always)]
pub fn moved<T: Real>(minus_origin: T, reciprocal: T, magnitude: T, least: T) -> [T; 2] {
    let margin = margin(minus_origin, least) * magnitude;
    let distance = minus_origin * reciprocal;
    [distance - margin, distance + margin]
}

/// A ray prepared for slab tests, with the same numbers in all lanes.
pub struct SlabRay<F> {
    /// The reciprocal of each component of the direction.
    reciprocal: [F; 3],
    /// `-o r`, moved down for the planes through which the ray enters, and moved up for those through which it leaves.
    near_origin: [F; 3],
    far_origin: [F; 3],
    /// For each axis, the index in the flat list of a node's planes at which those begin through which the ray enters
    /// (`near`) or leaves (`far`).
    near: [usize; 3],
    far: [usize; 3],
}

impl<F: SimdF32> SlabRay<F> {
    /// Prepares the ray for boxes whose planes are moved by these [margins]. There is no branch on the direction's
    /// signs, because it would be mispredicted half of the time.
    #[inline(always)]
    pub fn new(ray: &Ray, margins: &[f32; 3]) -> Self {
        debug_assert!(suits_slabs(ray.direction.dot(ray.direction)));
        let (origin, direction) = (ray.origin.to_array(), ray.direction.to_array());
        let zero = [F::splat(0.0); 3];
        let mut slab_ray = Self { reciprocal: zero, near_origin: zero, far_origin: zero, near: [0; 3], far: [0; 3] };
        for axis in 0..3 {
            let (minus_origin, narrow) = (-origin[axis] as f32, direction[axis] as f32);
            // With a comparison here, the compiler would make a branch, which is often mispredicted.
            let magnitude = (1.0 / narrow).abs().min(LARGEST_RECIPROCAL);
            let reciprocal = magnitude.copysign(narrow);
            let [near, far] = moved(minus_origin, reciprocal, magnitude, margins[axis]);
            slab_ray.reciprocal[axis] = F::splat(reciprocal);
            slab_ray.near_origin[axis] = F::splat(near);
            slab_ray.far_origin[axis] = F::splat(far);
            // This uses the sign of the direction, which is known earlier than the reciprocal.
            let backwards = (direction[axis].to_bits() as i64 >> 63) as usize & (3 * WIDTH);
            slab_ray.near[axis] = axis * WIDTH + backwards;
            slab_ray.far[axis] = (axis + 3) * WIDTH - backwards;
        }
        slab_ray
    }

    /// Returns the ray in a frame whose planes are at `origin + n step`, for planes that are given as `n`.
    #[inline(always)]
    pub fn in_frame(&self, origin: &[f32; 3], steps: &[f32; 3]) -> Self {
        let mut ray = Self { ..*self };
        for axis in 0..3 {
            let (origin, reciprocal) = (F::splat(origin[axis]), self.reciprocal[axis]);
            ray.reciprocal[axis] = F::splat(steps[axis]) * reciprocal;
            ray.near_origin[axis] = origin.mul_add(reciprocal, self.near_origin[axis]);
            ray.far_origin[axis] = origin.mul_add(reciprocal, self.far_origin[axis]);
        }
        ray
    }

    /// Tests boxes with these planes, as [`Boxes::intersect`](crate::accel::bvh::boxes::Boxes::intersect) describes.
    #[inline(always)]
    pub fn intersect<P: PlaneNumber>(&self, planes: &Planes<P>, farthest: f32, distances: &mut [f32; WIDTH]) -> u32 {
        let planes = planes.as_flattened().as_flattened();
        let mut bits = 0;
        for at in (0..WIDTH).step_by(F::LANES) {
            let (mut near, mut far) = (F::splat(0.0), F::splat(farthest));
            for axis in 0..3 {
                let (enter, leave) = (&planes[self.near[axis] + at..], &planes[self.far[axis] + at..]);
                near = P::load::<F>(enter).mul_add(self.reciprocal[axis], self.near_origin[axis]).max(near);
                far = P::load::<F>(leave).mul_add(self.reciprocal[axis], self.far_origin[axis]).min(far);
            }
            near.store(&mut distances[at..]);
            bits |= near.less_equal(far) << at;
        }
        bits
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accel::bvh::{boxes::Boxes, boxes::FloatBoxes, byte_boxes::ByteBoxes};
    use crate::simd::{Kernel, Simd, instruction_set::InstructionSet, portable::Array};

    /// A kernel that tests boxes up to a largest lambda, in both forms. Returns the bits of the first box.
    struct Intersect<'a>(&'a Ray, &'a [Bounds], Bounds, f32);

    impl Kernel for Intersect<'_> {
        type Output = [u32; 2];

        #[inline(always)]
        fn call<S: Simd>(self, _: S) -> [u32; 2] {
            let Self(ray, boxes, all, farthest) = self;
            let slab_ray = SlabRay::<S::F32>::new(ray, &margins(&all));
            let mut distances = [0.0; WIDTH];
            let wide = FloatBoxes::new(boxes).intersect(&slab_ray, farthest, &mut distances);
            let bytes = ByteBoxes::new(boxes).intersect(&slab_ray, farthest, &mut distances);
            [wide & 1, bytes & 1]
        }
    }

    #[test]
    fn a_ray_in_the_plane_of_a_flat_box_hits_it() {
        let flat = Bounds { low: [0.0; 3], high: [0.0, 1.0, 1.0] };
        let ray = Ray { origin: Vec3::new(0.0, -3.0, 0.5), direction: Vec3::new(0.0, 1.0, 0.0) };
        for set in InstructionSet::available() {
            assert_eq!(set.run(Intersect(&ray, &[flat], flat, f32::INFINITY)), [1; 2], "{}", set.name());
        }
        let [x, ..] = margins(&Bounds { low: [-1e3; 3], high: [1.0; 3] });
        assert!(x >= 1e3 * PLANE_MARGIN, "the farther plane counts");
    }

    #[test]
    fn a_plane_is_moved_by_its_margin_and_a_frame_by_its_origin_and_steps() {
        // The plane 0 has the lambda -1. Its margin is `2 * 2^-20 + 1/4`, times the reciprocal 1/2.
        let margin = 0.125 + 2.0_f64.powi(-20);
        assert_eq!(moved(-2.0, 0.5, 0.5, 0.25), [-1.0 - margin, -1.0 + margin]);
        // In the frame, the planes 0 and 1 are at 3 and 5.
        let ray = Ray { origin: Vec3::ZERO, direction: Vec3::splat(0.5) };
        let ray = SlabRay::<Array<f32>>::new(&ray, &[0.0; 3]).in_frame(&[3.0; 3], &[2.0; 3]);
        let first = |lanes: Array<f32>| {
            let mut numbers = [0.0; 4];
            lanes.store(&mut numbers);
            numbers[0]
        };
        let numbers = [ray.reciprocal, ray.near_origin, ray.far_origin].map(|lanes| lanes.map(first));
        assert_eq!(numbers, [[4.0; 3], [6.0; 3], [6.0; 3]]);
    }
}
