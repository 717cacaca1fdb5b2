//! The maximum depth (specification, section 8.1).
//!
//! 1. A sample may send `max_depth` rays, of which the camera ray is the first.
//! 2. A surface that is hit by the last of them contributes black; no ray leaves it.
//! 3. That surface takes its scatter sample all the same (`sampling/draw_order.rs`).
//!
//! All of the renderer counts by [`RaysLeft`], from the camera rays through specular chains to the paths, and ends a
//! path at [`RaysLeft::is_none`] in black (`terminate` in `render/path_ends.rs`). The reference's copy is the loop of
//! `color` in `reference.rs`, and the copy in WGSL is the loop of `trace.wgsl`.

use crate::math::real::Real;

/// How many rays a path may still send.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RaysLeft(u64);

impl RaysLeft {
    /// After the camera ray; `max_depth` is at least 1.
    pub const fn after_camera_ray(max_depth: u64) -> Self {
        Self(max_depth - 1)
    }

    /// Whether the path is at the maximum depth, so that it contributes black.
    #[inline(always)]
    pub const fn is_none(self) -> bool {
        self.0 == 0
    }

    /// Whether the next ray is the last one.
    #[inline(always)]
    pub const fn is_one(self) -> bool {
        self.0 == 1
    }

    /// After one more ray.
    #[inline(always)]
    pub const fn minus_one(self) -> Self {
        Self(self.0 - 1)
    }

    /// The count as the bits of an `f64`, the same in every lane. Queues store only `f64`.
    #[inline(always)]
    pub fn to_bits_of<T: Real>(self) -> T {
        T::of(f64::from_bits(self.0))
    }

    /// The count that a lane of [`RaysLeft::to_bits_of`] holds.
    #[inline(always)]
    pub const fn of_bits(lane: f64) -> Self {
        Self(lane.to_bits())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_camera_ray_is_the_first_of_as_many_rays_as_the_depth_says() {
        let mut rays = RaysLeft::after_camera_ray(3);
        assert!(!rays.is_none() && !rays.is_one());
        rays = RaysLeft::of_bits(rays.minus_one().to_bits_of());
        assert!(rays.is_one() && rays.minus_one().is_none());
        assert!(RaysLeft::after_camera_ray(1).is_none());
    }
}
