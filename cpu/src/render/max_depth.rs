//! The maximum depth (specification, section 8.1).
//!
//! 1. A sample may send `max_depth` rays. The camera ray is the first of them.
//! 2. If the last of these rays hits a surface, the sample is black, and no further ray follows.
//! 3. That surface still takes its scatter sample (`sampling/draw_order.rs`).
//!
//! The whole renderer counts with [`RaysLeft`], from the camera rays through specular chains to the paths. At a hit
//! with [`RaysLeft::is_none`] the sample becomes black: a path by `terminate` in `render/path_ends.rs`, and a specular
//! chain by `terminate` in `render/samples.rs`. A matte or metal surface takes its scatter sample at the same time
//! (`end_at_max_depth` in `render/path.rs`). A lookahead may skip the hit of a last ray (`render/lookahead.rs`). At a
//! maximum depth of 1 no scatter sample is drawn at all (`needs_samples` in `render/prepared.rs`). The reference has a
//! copy of this rule in the loop of `color` in `reference.rs`. WGSL has it in the loops of `trace.wgsl`,
//! `trace_samples.wgsl` and `kernels/steps.wgsl`.

use crate::math::real::Real;

/// The number of rays that a path may still send.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RaysLeft(u64);

impl RaysLeft {
    /// Number of rays from one pause to the next, a power of two.
    const PAUSE: u64 = 64;

    /// Returns the number of rays that may follow the camera ray. `max_depth` is at least 1.
    pub(crate) const fn after_camera_ray(max_depth: u64) -> Self {
        debug_assert!(max_depth > 0);
        Self(max_depth - 1)
    }

    /// Whether no ray is left. A path that hits a surface then contributes black.
    #[inline(always)]
    pub(crate) const fn is_none(self) -> bool {
        self.0 == 0
    }

    /// Whether the path pauses here, to look whether the picture is to stop: at every 64th ray, and when no ray is
    /// left. This test is as short as [`RaysLeft::is_none`], so a caller that needs both begins with this
    /// one.
    #[inline(always)]
    pub(crate) const fn pauses(self) -> bool {
        self.0.is_multiple_of(Self::PAUSE)
    }

    /// Whether exactly one ray is left, so that the next ray is the last one.
    #[inline(always)]
    pub(crate) const fn is_one(self) -> bool {
        self.0 == 1
    }

    /// Returns the number after one more ray. At least one ray must be left.
    #[inline(always)]
    pub(crate) const fn minus_one(self) -> Self {
        debug_assert!(!self.is_none());
        Self(self.0 - 1)
    }

    /// Returns the number, the same in every lane.
    #[inline(always)]
    pub(crate) fn in_lanes<T: Real>(self) -> RaysLane<T> {
        RaysLane(T::of(f64::from_bits(self.0)))
    }
}

/// A [`RaysLeft`] as the bits of an `f64`, because lanes and queues hold only `f64`.
#[derive(Clone, Copy, Debug)]
pub struct RaysLane<T = f64>(pub T);

impl RaysLane {
    /// Returns the number.
    #[inline(always)]
    pub(crate) const fn get(self) -> RaysLeft {
        RaysLeft(self.0.to_bits())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_camera_ray_is_the_first_of_as_many_rays_as_the_depth_says() {
        let mut rays = RaysLeft::after_camera_ray(3);
        assert!(!rays.is_none() && !rays.is_one());
        rays = rays.minus_one().in_lanes().get();
        assert!(rays.is_one() && rays.minus_one().is_none());
        assert!(RaysLeft::after_camera_ray(1).is_none());
    }

    #[test]
    fn a_path_pauses_at_every_64th_ray_and_when_no_ray_is_left() {
        let pauses: Vec<_> = (0..200).filter(|&rays| RaysLeft(rays).pauses()).collect();
        assert_eq!(pauses, [0, 64, 128, 192]);
    }
}
