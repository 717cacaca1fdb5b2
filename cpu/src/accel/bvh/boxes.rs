//! The boxes of a node's children, in two forms: [`FloatBoxes`] with coordinates, for small trees, and
//! [`ByteBoxes`](crate::accel::bvh::byte_boxes::ByteBoxes), for trees that do not fit into the processor's caches.
//!
//! Both forms can hold [bounding spheres](crate::accel::bvh::sphere_leaf) instead of boxes. These use the same memory,
//! and the node knows which of the two it has.

use std::array;

use crate::accel::bvh::sphere_leaf::{BoundingSphere, Frame, SphereLeaf};
use crate::accel::bvh::{planes::PlaneNumber, planes::Planes, planes::WIDTH, slab_ray::SlabRay};
use crate::{accel::bounds::Bounds, simd::SimdF32};

/// Up to 16 boxes, which are tested together.
pub trait Boxes: Clone + std::fmt::Debug {
    /// The numbers that stand for the coordinates.
    type Number: PlaneNumber;

    /// No boxes.
    const EMPTY: Self;

    /// Returns `boxes`, which are at most 16, in their order.
    fn new(boxes: &[Bounds]) -> Self;

    /// Returns the box in a lane. It contains the box that was given to [`Boxes::new`].
    fn bounds(&self, lane: usize) -> Bounds;

    /// Returns 16 bits. Bit `i` is 1 if the ray hits box `i` at a lambda of at most `farthest`. It may also be 1 if the
    /// ray just misses the box. For each box that is hit, stores a lower bound of the lambda at which the ray enters
    /// it, or 0 if the ray starts inside. If there are fewer boxes, the caller must ignore the other bits.
    fn intersect<F: SimdF32>(&self, slab_ray: &SlabRay<F>, farthest: f32, distances: &mut [f32; WIDTH]) -> u32;

    /// Returns 16 bits. Bit `i` is 1 if box `i` overlaps or touches `bounds`. If there are fewer boxes, the caller must
    /// ignore the other bits. All bits of byte boxes are 1, which is allowed and slow: their trees are too large for
    /// the search of isolated objects, which alone needs this.
    #[inline(always)]
    fn overlaps<F: SimdF32>(&self, _: &Bounds) -> u32 {
        u32::MAX
    }

    /// Returns bounding spheres of spheres whose boxes are `boxes`, at most 16, in their order.
    fn of_spheres(boxes: &[Bounds]) -> Self;

    /// Returns the bounding spheres. They have no meaning unless this comes from [`Boxes::of_spheres`].
    fn bounding_spheres(&self) -> SphereLeaf<'_, Self::Number>;
}

/// Up to 16 boxes in 384 bytes. Each plane is stored as its coordinate, in scene units. Bounding spheres have the
/// centres in place of the lower planes, and the radii in place of the first upper planes.
#[derive(Clone, Copy, Debug)]
pub struct FloatBoxes(Planes<f32>);

impl Boxes for FloatBoxes {
    type Number = f32;

    const EMPTY: Self = Self([[[0.0; WIDTH]; 3]; 2]);

    fn new(boxes: &[Bounds]) -> Self {
        let plane = |lane: usize, side: fn(&Bounds) -> [f32; 3], axis: usize| {
            boxes.get(lane).map_or(0.0, |bounds| side(bounds)[axis])
        };
        let planes = |side| array::from_fn(|axis| array::from_fn(|lane| plane(lane, side, axis)));
        Self([planes(|bounds| bounds.low), planes(|bounds| bounds.high)])
    }

    fn bounds(&self, lane: usize) -> Bounds {
        let [low, high] = self.0.map(|planes| planes.map(|planes| planes[lane]));
        Bounds { low, high }
    }

    #[inline(always)]
    fn intersect<F: SimdF32>(&self, slab_ray: &SlabRay<F>, farthest: f32, distances: &mut [f32; WIDTH]) -> u32 {
        slab_ray.intersect(&self.0, farthest, distances)
    }

    #[inline(always)]
    fn overlaps<F: SimdF32>(&self, bounds: &Bounds) -> u32 {
        let [low, high] = &self.0;
        let mut bits = 0;
        for at in (0..WIDTH).step_by(F::LANES) {
            let mut overlaps = u32::MAX;
            for axis in 0..3 {
                overlaps &= F::load(&low[axis][at..]).less_equal(F::splat(bounds.high[axis]));
                overlaps &= F::splat(bounds.low[axis]).less_equal(F::load(&high[axis][at..]));
            }
            bits |= overlaps << at;
        }
        bits
    }

    fn of_spheres(boxes: &[Bounds]) -> Self {
        let mut leaf = Self::EMPTY;
        let rows = leaf.0.as_flattened_mut();
        for (lane, bounds) in boxes.iter().enumerate() {
            let sphere = BoundingSphere::of(bounds);
            let center = sphere.center.map(|coordinate| coordinate as f32);
            for axis in 0..3 {
                rows[axis][lane] = center[axis];
            }
            rows[3][lane] = (sphere.radius_around(center.map(f64::from)) as f32).next_up();
        }
        leaf
    }

    #[inline(always)]
    fn bounding_spheres(&self) -> SphereLeaf<'_, f32> {
        SphereLeaf { rows: self.0.as_flattened(), frame: Frame::IDENTITY }
    }
}
