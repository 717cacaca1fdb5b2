//! Conservative tests in double precision. They find the spheres and cylinders that a ray may hit, and the exact
//! formulas then decide about each of these.
//!
//! If the quadratic `f(lambda) = a lambda^2 - 2 h lambda + c` of a shape has no root in range, a ray does not hit the
//! shape. Either the ray's line misses the shape, or the ray has left it already. The second case is frequent, because
//! most rays start on a surface and go outward. The quadratics are those of [`crate::geometry::sphere`] and
//! [`crate::geometry::cylinder`], multiplied out to take fewer operations. The margin covers their rounding and that of
//! the exact formulas (docs/margins.md).

use crate::accel::{may_hit::target::Target, object::ObjectId, object::ObjectRef};
use crate::geometry::ray::{LAMBDA_MIN, Ray};
use crate::layout::Objects;
use crate::math::{real::Real, rounding::Rounding, vec3::Vec3};

/// The margin of the constant term `c` of a quadratic `a lambda^2 - 2 h lambda + c`, relative to the sum of the
/// magnitudes of the terms of `c` ([`ConservativeQuadratic::size`]). It is `1024 u`: room for about 1,000 roundings,
/// each with a relative error of at most `u = EPSILON / 2`. The tests and the exact formulas together need a quarter of
/// this, so rounding never discards an object that the ray hits (docs/margins.md).
pub const QUADRATIC_MARGIN: f64 = 512.0 * f64::EPSILON;

/// The smallest squared length of a direction for which the tests are valid. With it underflow is negligible, in single
/// precision too (`tests/stability/src/proof/filters.rs`).
pub const LEAST_LENGTH_SQUARED: f64 = 1e-14;

/// Whether a direction with this squared length is too short for the tests: shorter than 10^-7. The caller must then
/// intersect every object.
#[inline(always)]
pub(crate) fn is_too_short<T: Real>(length_squared: T) -> T::Mask {
    length_squared.less(T::of(LEAST_LENGTH_SQUARED))
}

/// A ray for conservative tests, or one ray in each lane. The ray must start inside the scene's extent.
///
/// Coordinates are at most 10^9 (see [`Extent::LARGEST`](crate::accel::extent::Extent::LARGEST)). A direction may have
/// any length that is not [too short](is_too_short). No product overflows if the ray is near an object at the smallest
/// lambda in range, 10^-3, and every other miss is right. NaN discards no object, because every comparison with NaN is
/// false.
///
/// A single `f64` ray may be tested against a sphere of any centre and radius, if its direction is at most 10^30 long.
/// If the square of the distance or of the radius overflows, `size` is infinite, so `c` less the margin is NaN or
/// `-inf`, and the sphere is kept. If only `a c` less the margin overflows and the ray hits, the larger `h^2` overflows
/// too, because the margin exceeds the errors of both. The difference is NaN, and the sphere is kept. A fused product
/// would not overflow, but `f64` [rounds](Rounding::mul_add_loosely) it.
#[derive(Clone, Copy, Debug)]
pub struct ConservativeRay<T> {
    /// The ray.
    pub ray: Ray<T>,
    /// The square of the direction's length.
    pub length_squared: T,
}

/// The coefficients of `a lambda^2 - 2 h lambda + c`.
#[derive(Clone, Copy)]
pub struct ConservativeQuadratic<T> {
    /// The coefficient of the square of lambda.
    pub a: T,
    /// Half of the linear coefficient, negated.
    pub h: T,
    /// The constant term.
    pub c: T,
    /// The sum of the magnitudes of the terms of `c`, or a bound of it.
    pub size: T,
}

impl ConservativeRay<f64> {
    /// Whether the ray may hit the object with the number `id`, in a scene with this largest coordinate.
    #[inline(always)]
    pub(crate) fn may_hit<O: Objects>(&self, objects: &O, id: ObjectId, max_coordinate: f64) -> bool {
        match ObjectRef::of(objects, id) {
            ObjectRef::Sphere(index) => self.sphere(&Target::sphere(&objects.sphere(index).record)),
            ObjectRef::Cylinder(index) => {
                self.cylinder(&Target::cylinder(&objects.cylinder(index).record, max_coordinate))
            }
        }
    }
}

impl<T: Rounding> ConservativeRay<T> {
    /// Prepares a ray for the tests.
    #[inline(always)]
    pub fn new(ray: Ray<T>) -> Self {
        Self { ray, length_squared: dot(ray.direction, ray.direction) }
    }

    /// Whether the ray may hit the sphere.
    #[inline(always)]
    pub fn sphere(&self, target: &Target<T>) -> T::Mask {
        let quadratic = self.sphere_quadratic(target);
        let ConservativeQuadratic { a, c, size, .. } = quadratic;
        !quadratic.has_no_root(a * size.mul_add_loosely(T::of(-QUADRATIC_MARGIN), c))
    }

    /// Returns the quadratic of ray and sphere.
    #[inline(always)]
    pub fn sphere_quadratic(&self, target: &Target<T>) -> ConservativeQuadratic<T> {
        let to_center = target.center - self.ray.origin;
        let (h, q) = (dot(self.ray.direction, to_center), dot(to_center, to_center));
        let (c, size) = (q - target.radius_squared, q + target.radius_squared);
        ConservativeQuadratic { a: self.length_squared, h, c, size }
    }

    /// Whether the ray may hit the cylinder.
    #[inline(always)]
    pub fn cylinder(&self, target: &Target<T>) -> T::Mask {
        let (across, slope, center_along) = self.cylinder_quadratic(target);
        let ConservativeQuadratic { a, c, size, .. } = across;
        // The margin is proportional to the squared length of the whole direction. The part of the direction across the
        // axis may be nothing but rounding error.
        let lowered_product = size.mul_add_loosely(self.length_squared * T::of(-QUADRATIC_MARGIN), a * c);
        // The distance, along the axis and in the ray's direction, of the point at the smallest lambda from the middle.
        let past_middle = slope.abs().mul_add_loosely(T::of(LAMBDA_MIN), -center_along.flipped_by(slope));
        !(across.has_no_root(lowered_product) | target.half_height.less(past_middle))
    }

    /// Returns the quadratic of the ray and the infinite cylinder. Then it returns the components along the axis of two
    /// vectors: the direction, and the vector from the ray's origin to the centre.
    #[inline(always)]
    pub fn cylinder_quadratic(&self, target: &Target<T>) -> (ConservativeQuadratic<T>, T, T) {
        let to_center = target.center - self.ray.origin;
        let (h, q) = (dot(self.ray.direction, to_center), dot(to_center, to_center));
        let (slope, center_along) = (dot(self.ray.direction, target.axis), dot(to_center, target.axis));
        let across = ConservativeQuadratic {
            a: (-slope).mul_add_loosely(slope, self.length_squared),
            h: (-slope).mul_add_loosely(center_along, h),
            c: (-center_along).mul_add_loosely(center_along, q - target.radius_squared),
            // This includes the height, because a ray may come from far along the axis, at an angle as small as the
            // rounding of its direction.
            size: q + target.bounding_radius_squared,
        };
        (across, slope, center_along)
    }
}

impl<T: Rounding> ConservativeQuadratic<T> {
    /// Whether the quadratic certainly has no root in range, at a lambda of at least [`LAMBDA_MIN`]. `lowered_product`
    /// is `a c`, lowered by the margin.
    #[inline(always)]
    fn has_no_root(&self, lowered_product: T) -> T::Mask {
        let Self { a, h, c, size } = *self;
        let raised_discriminant = h.mul_add_loosely(h, -lowered_product);
        let lowered_c = size.mul_add_loosely(T::of(-QUADRATIC_MARGIN), c);
        // This is a lower bound of f at the smallest lambda in range. If h is negative, f only rises after it.
        let lowered_at_first = a.mul_add_loosely(T::of(LAMBDA_MIN * LAMBDA_MIN), lowered_c);
        let lowered_at_first = h.mul_add_loosely(T::of(-2.0 * LAMBDA_MIN), lowered_at_first);
        let zero = T::of(0.0);
        raised_discriminant.less(zero) | (h.less(zero) & zero.less(lowered_at_first))
    }
}

#[inline(always)]
fn dot<T: Rounding>(left: Vec3<T>, right: Vec3<T>) -> T {
    left.z.mul_add_loosely(right.z, left.y.mul_add_loosely(right.y, left.x * right.x))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::cylinder::CylinderRecord;
    use crate::geometry::sphere::SphereRecord;

    fn may_hit_sphere(record: &SphereRecord, ray: &Ray) -> bool {
        ConservativeRay::new(*ray).sphere(&Target::sphere(record))
    }

    fn may_hit_cylinder(record: &CylinderRecord, ray: &Ray) -> bool {
        ConservativeRay::new(*ray).cylinder(&Target::cylinder(record, 10.0))
    }

    #[test]
    fn a_ray_outward_from_a_sphere_is_discarded_and_one_inward_is_not() {
        let sphere = SphereRecord::new(Vec3::ZERO, 1.0);
        let may_hit = |y: f64, direction: [f64; 3]| {
            may_hit_sphere(&sphere, &Ray { origin: Vec3::new(0.0, y, 0.0), direction: direction.into() })
        };
        assert!(!may_hit(1.0, [0.3, 1.0, 0.0]) && !may_hit(1.0, [1.0, 1e-9, 0.0]));
        assert!(may_hit(1.0, [0.3, -1.0, 0.0]) && may_hit(1.0, [1.0, -1e-9, 0.0]));
        // The ray leaves the sphere at the smallest lambda.
        assert!(may_hit(1.0 - LAMBDA_MIN, [0.0, 1.0, 0.0]));
    }

    #[test]
    fn a_sphere_of_any_size_is_kept_if_the_ray_hits_it() {
        for (size, length) in (0..310).flat_map(|size| (0..31).map(move |length| (size, length))) {
            let (radius, length) = (10.0_f64.powi(size), 10.0_f64.powi(length));
            for (distance, aside) in [(3.0, 0.999_999), (1.000_001, 0.5), (0.5, 0.1), (30.0, 1.0)] {
                let center = Vec3::new(aside, 0.0, distance) * radius;
                let ray = Ray { origin: Vec3::ZERO, direction: Vec3::new(0.0, 0.0, length) };
                assert!(may_hit_sphere(&SphereRecord::new(center, radius), &ray), "{radius:e}, {length:e}, {distance}");
            }
        }
    }

    #[test]
    fn a_line_beside_the_shape_is_discarded_and_a_tangent_is_not() {
        let sphere = SphereRecord::new(Vec3::ZERO, 1.0);
        let cylinder = CylinderRecord::new(Vec3::ZERO, 1.0, Vec3::new(0.0, 4.0, 0.0));
        for (x, may_hit) in [(0.5, true), (1.0, true), (1.0 + 1e-15, true), (1.0 + 1e-9, false), (-1.5, false)] {
            let ray = Ray { origin: Vec3::new(x, 0.0, -3.0), direction: Vec3::new(0.0, 0.0, 2.0) };
            assert_eq!(may_hit_sphere(&sphere, &ray), may_hit, "{x}");
            assert_eq!(may_hit_cylinder(&cylinder, &ray), may_hit, "{x}");
        }
    }

    #[test]
    fn a_ray_may_leave_a_cylinder_by_the_side_and_by_the_caps() {
        let cylinder = CylinderRecord::new(Vec3::ZERO, 1.0, Vec3::new(0.0, 4.0, 0.0));
        let leaves = |origin: [f64; 3], direction: [f64; 3]| {
            !may_hit_cylinder(&cylinder, &Ray { origin: origin.into(), direction: direction.into() })
        };
        assert!(leaves([1.0, 0.0, 0.0], [1.0, 0.5, 0.0]));
        assert!(leaves([0.5, 2.0, 0.0], [0.1, 1.0, 0.0]));
        assert!(leaves([0.5, -2.0, 0.0], [0.1, -1.0, 0.0]));
        assert!(!leaves([1.0, 0.0, 0.0], [-1.0, 0.5, 0.0]));
        assert!(!leaves([0.5, 2.0, 0.0], [0.1, -1.0, 0.0]));
        assert!(!leaves([0.5, -2.0, 0.0], [0.1, 1.0, 0.0]));
        assert!(!leaves([0.5, -1.0, 0.0], [0.0, 1.0, 0.0]) && !leaves([1.0 - LAMBDA_MIN, 0.0, 0.0], [1.0, 0.0, 0.0]));
    }

    #[test]
    fn the_quadratic_of_a_cylinder_is_that_of_the_plane_across_its_axis() {
        let target = Target::cylinder(&CylinderRecord::new(Vec3::ZERO, 1.0, Vec3::new(0.0, 4.0, 0.0)), 10.0);
        let ray = Ray { origin: Vec3::new(3.0, 5.0, 0.0), direction: Vec3::new(1.0, 2.0, 0.0) };
        let (ConservativeQuadratic { a, h, c, size }, slope, center_along) =
            ConservativeRay::new(ray).cylinder_quadratic(&target);
        // `(3 + lambda)^2 = 1`. The origin is at the squared distance 34, and the farthest point at 5, from the centre.
        assert_eq!([a, h, c, size, slope, center_along], [1.0, -3.0, 8.0, 39.0, 2.0, -5.0]);
    }
}
