//! Which boxes of the tree a ray meets.
//!
//! A node's boxes are tested at once, in single precision: along each axis a plane at `p` is at the distance `p r - o r`,
//! with the reciprocal `r` of the direction and the origin `o`. Of its error, with `u = 2^-24`, `2 u` of the distance come
//! from `r`, and as much and `u |o r|` from the product and the sum, fused or not, since `p r` is `o r` and the distance.
//! The origin is moved by `8 u |o|` towards the side that lets the ray pass, which covers what is relative to it: its own
//! rounding, that of the sum and of `o r`, and that of `p r`. So a ray that meets a box, ahead and not farther than the
//! nearest hit so far, has `near (1 - 5u) <= far (1 + 5u)`, which [`SLACK`] covers.

use super::node::Node;
use crate::ray::Ray;
use crate::simd::FilterLanes;

/// Factor on a far distance that covers all rounding.
pub const SLACK: f32 = 1.0 + 16.0 * f32::EPSILON;

/// Largest magnitude of a reciprocal: no coordinate of a moderate scene overflows with it.
const LARGEST_RECIPROCAL: f32 = 1e28;

/// The least that an origin is moved: with the largest reciprocal it is farther than any plane across another axis, for
/// a direction that is not shorter than [`SHORTEST`].
const LEAST_STEP: f32 = 1e-10;

/// Length squared of the shortest direction that boxes are tested for.
pub const SHORTEST: f64 = 1e-14;

/// A ray as the boxes see it.
pub struct BoxRay<F> {
    /// Of its direction.
    reciprocal: [F; 3],
    /// Minus the origin times the reciprocal: moved so that near planes are not farther, and far planes not nearer, than
    /// they are.
    near_origin: [F; 3],
    far_origin: [F; 3],
    /// Which [corner](Node::corners) is the near one along each axis.
    near: [usize; 3],
}

impl<F: FilterLanes> BoxRay<F> {
    // Without a branch on where the ray goes, which no processor could guess.
    #[inline(always)]
    pub fn new(ray: &Ray) -> Self {
        let (origin, direction) = (ray.origin.to_array(), ray.direction.to_array());
        let mut box_ray = Self {
            reciprocal: [F::splat(0.0); 3],
            near_origin: [F::splat(0.0); 3],
            far_origin: [F::splat(0.0); 3],
            near: [0; 3],
        };
        for axis in 0..3 {
            let (origin, direction) = (origin[axis] as f32, direction[axis] as f32);
            let reciprocal = (1.0 / direction).clamp(-LARGEST_RECIPROCAL, LARGEST_RECIPROCAL);
            let step = (origin.abs() * (4.0 * f32::EPSILON) + LEAST_STEP).copysign(direction);
            box_ray.reciprocal[axis] = F::splat(reciprocal);
            box_ray.near_origin[axis] = F::splat(-((origin + step) * reciprocal));
            box_ray.far_origin[axis] = F::splat(-((origin - step) * reciprocal));
            box_ray.near[axis] = usize::from(direction.is_sign_negative());
        }
        box_ray
    }

    /// Distances to the boxes of a node, and which the ray meets within `farthest`.
    #[inline(always)]
    pub fn meets(&self, node: &Node, at: usize, farthest: F) -> (F, u32) {
        let mut near = F::splat(0.0);
        let mut far = farthest;
        for axis in 0..3 {
            let (enter, leave) = (&node.corners[self.near[axis]][axis], &node.corners[1 - self.near[axis]][axis]);
            near = F::load(&enter[at..]).mul_add(self.reciprocal[axis], self.near_origin[axis]).max(near);
            far = F::load(&leave[at..]).mul_add(self.reciprocal[axis], self.far_origin[axis]).min(far);
        }
        (near, near.less_equal(far * F::splat(SLACK)))
    }
}
