//! Finds rays that certainly hit an object, because they start inside it.
//!
//! The objects are convex and bounded. So a ray that is inside an object at the smallest lambda in range leaves it
//! later, and this is a hit. The lookahead uses this for the last ray that a path may send. If that ray hits any
//! object, the path contributes black and takes one more scatter sample. So it does not matter which object is hit, and
//! no object is intersected.
//!
//! The tests are those of [`conservative`](crate::accel::may_hit::conservative), but with the margin on the opposite
//! side (docs/margins.md): they accept a ray only if it is certainly inside. NaN is inside no object, because every
//! comparison with NaN is false. The direction must be [in scale](crate::exact::error_bound::in_scale), so that nothing
//! overflows with coordinates of up to 10^9.

use crate::accel::{
    extent::is_within, may_hit::conservative::ConservativeQuadratic, may_hit::conservative::ConservativeRay,
    may_hit::conservative::QUADRATIC_MARGIN, may_hit::target::SLACK, may_hit::target::Target, object::ObjectId,
    object::ObjectRef, object::count, small_scene::SmallScene,
};
use crate::exact::error_bound::in_scale;
use crate::geometry::{cap::PARALLEL, ray::LAMBDA_MIN, ray::Ray};
use crate::layout::Objects;
use crate::math::{real::Real, rounding::Rounding};

/// If the dot product `p` of a ray's direction `d` and a cylinder's axis exceeds this in magnitude, and `p^2` exceeds
/// `STEEP_SHARE |d|^2`, the ray is certainly not parallel to the caps: `|p|` is not below [`PARALLEL`], whatever its
/// rounding errors are. By the specification a parallel ray hits no cap, so it may hit nothing although it starts
/// inside.
const STEEP: f64 = 2.0 * PARALLEL;
/// The second threshold, 2^-40; see [`STEEP`]. If `p^2` exceeds it, `p` is far above its rounding error
/// (docs/margins.md). So rounding cannot move `|p|` from `STEEP` to `PARALLEL`.
pub const STEEP_SHARE: f64 = 1.0 / (1_u64 << 40) as f64;

/// Whether a ray certainly is not parallel to the caps. `slope` is the dot product of its direction and the axis.
#[inline(always)]
pub fn is_steep<T: Real>(slope: T, length_squared: T) -> T::Mask {
    T::of(STEEP).less(slope.abs()) & (length_squared * T::of(STEEP_SHARE)).less(slope * slope)
}

impl SmallScene {
    /// Whether the ray is certainly inside one of the objects at the smallest lambda in range, so that it hits. The ray
    /// must start inside the scene's extent.
    #[inline(always)]
    pub(crate) fn starts_inside<O: Objects>(&self, objects: &O, ray: &Ray) -> bool {
        debug_assert!(is_within(ray.origin, self.max_coordinate));
        let (conservative, mut inside) = (ConservativeRay::new(*ray), false);
        for id in 0..count(objects) as ObjectId {
            let target = Target::of(objects, id, self.max_coordinate);
            inside |= match ObjectRef::of(objects, id) {
                ObjectRef::Sphere(_) => conservative.starts_within(&conservative.sphere_quadratic(&target)),
                ObjectRef::Cylinder(_) => conservative.starts_in_cylinder(&target, self.max_coordinate),
            };
        }
        // A null direction is not in scale, and it hits nothing.
        inside & in_scale(conservative.length_squared)
    }
}

impl ConservativeRay<f64> {
    /// Whether the ray is certainly inside the cylinder at the smallest lambda in range, and not parallel to its caps.
    #[inline(always)]
    fn starts_in_cylinder(&self, target: &Target, max_coordinate: f64) -> bool {
        let (across, slope, along) = self.cylinder_quadratic(target);
        let lowered_half_height = target.half_height - max_coordinate * (2.0 * SLACK);
        let is_between_caps = (slope * LAMBDA_MIN - along).abs() < lowered_half_height;
        self.starts_within(&across) & is_between_caps & is_steep(slope, self.length_squared)
    }
}

impl<T: Rounding> ConservativeRay<T> {
    /// Whether the quadratic is certainly negative at the smallest lambda in range.
    #[inline(always)]
    pub fn starts_within(&self, &ConservativeQuadratic { a, h, c, size }: &ConservativeQuadratic<T>) -> T::Mask {
        const SQUARED: f64 = LAMBDA_MIN * LAMBDA_MIN;
        let raised_c = c + (size + self.length_squared * T::of(SQUARED)) * T::of(QUADRATIC_MARGIN);
        (a * T::of(SQUARED) - h * T::of(2.0 * LAMBDA_MIN) + raised_c).less(T::of(0.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::cylinder::CylinderRecord;
    use crate::geometry::sphere::SphereRecord;
    use crate::math::vec3::Vec3;

    fn starts_in_sphere(ray: Ray, sphere: &SphereRecord) -> bool {
        let conservative = ConservativeRay::new(ray);
        conservative.starts_within(&conservative.sphere_quadratic(&Target::sphere(sphere)))
    }

    #[test]
    fn at_the_limits_nothing_is_certain() {
        let sphere = SphereRecord::new(Vec3::ZERO, 1.0);
        let cylinder = Target::cylinder(&CylinderRecord::new(Vec3::ZERO, 1.0, Vec3::new(0.0, 2.0, 0.0)), 4.0);
        let ray = |origin: [f64; 3], direction: [f64; 3]| Ray { origin: origin.into(), direction: direction.into() };
        // The rays go inward and outward from the surface. The third one is on the surface at the smallest lambda.
        assert!(starts_in_sphere(ray([1.0, 0.0, 0.0], [-1.0, 0.0, 0.0]), &sphere));
        assert!(!starts_in_sphere(ray([1.0, 0.0, 0.0], [1.0, 0.0, 0.0]), &sphere));
        assert!(!starts_in_sphere(ray([1.0 - LAMBDA_MIN, 0.0, 0.0], [1.0, 0.0, 0.0]), &sphere));
        let begins =
            |origin, direction| ConservativeRay::new(ray(origin, direction)).starts_in_cylinder(&cylinder, 4.0);
        assert!(begins([1.0, 0.0, 0.0], [-1.0, 0.1, 0.0]) && begins([0.0, 1.0, 0.0], [0.1, -1.0, 0.0]));
        assert!(!begins([0.0, 1.0, 0.0], [0.1, 1.0, 0.0]) && !begins([0.0, 1.0 - LAMBDA_MIN, 0.0], [0.0, 1.0, 0.0]));
        // A ray that is parallel to the caps might hit only a cap, and such a hit does not count.
        let from_middle = |direction| begins([0.0, 0.0, 0.0], direction);
        assert!(!from_middle([1.0, 1e-9, 0.0]) && from_middle([1.0, 1e-4, 0.0]));
        assert!(!from_middle([1e-9, 1e-9, 0.0]) && !from_middle([100.0, 3e-8, 0.0]), "short, and rounded by too much");
    }

    #[test]
    fn a_steep_ray_exceeds_both_thresholds() {
        // The thresholds are 2e-8 and `2^-20 |d|`, which is about 9.5e-7 for a direction of length one.
        for (slope, length_squared, is_expected) in [
            (1e-6, 1.0, true),
            (-1e-6, 1.0, true),
            (9e-7, 1.0, false),
            (3e-8, 1e-16, true),
            (1e-8, 1e-16, false),
            (f64::NAN, 1.0, false),
        ] {
            assert_eq!(is_steep(slope, length_squared), is_expected, "{slope:e}");
        }
    }
}
