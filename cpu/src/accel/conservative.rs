//! Which spheres and cylinders rays may meet, in double precision: the filter in front of the exact formulas.
//!
//! A ray has no hit with a shape whose quadratic `f(lambda) = a lambda^2 - 2 h lambda + c` has no root that counts: the
//! line misses, or the ray has come out before; most rays start on a surface and go outward. The quadratics are those
//! of [`crate::geometry::sphere`] and [`crate::geometry::cylinder`], multiplied out to be short and rounded as it
//! comes. The margin covers that, and what rounding may do to the exact formulas (docs/margins.md); where the
//! filter stops nothing, these decide.

use crate::accel::object::{ObjectId, ObjectRef};
use crate::accel::target::{ConservativeCylinder, ConservativeSphere};
use crate::geometry::ray::{LAMBDA_MIN, Ray};
use crate::layout::Objects;
use crate::math::real::Real;
use crate::math::rounding::MulAdd;
use crate::math::vec3::Vec3;

/// By how much of its terms the constant of a quadratic is lowered: a thousand roundings.
pub(super) const MARGIN: f64 = 512.0 * f64::EPSILON;

/// The smallest squared length of a direction for which the tests are valid. From it on their margins exceed 10^-31, so
/// that underflow is negligible, in single precision too.
const SHORTEST: f64 = 1e-14;

/// Whether directions of this squared length are too short for the tests. The caller must then intersect every object.
#[inline(always)]
pub fn is_too_short<T: Real>(length_squared: T) -> T::Mask {
    length_squared.less(T::of(SHORTEST))
}

/// One ray or a lane of them, which start within the scene's reach.
///
/// Coordinates are at most 10^9 (see [`Extent::LARGEST`](crate::accel::extent::Extent::LARGEST)), but a direction may
/// be of any length that is not [too short](is_too_short). With a long direction a product may overflow, and a test may
/// reject the object. It does so rightly: a direction longer than 10^13 takes the ray past all objects before the
/// smallest lambda in range, 10^-3. A NaN rejects no object, because every comparison with NaN is false.
#[derive(Clone, Copy, Debug)]
pub struct ConservativeRay<T> {
    /// The ray.
    pub ray: Ray<T>,
    /// `direction.direction`.
    pub length_squared: T,
}

/// A quadratic.
#[derive(Clone, Copy)]
pub(super) struct Quadratic<T> {
    pub a: T,
    pub h: T,
    pub c: T,
    /// What the terms of `c` amount to.
    pub size: T,
}

impl ConservativeRay<f64> {
    /// Whether the ray may hit the object, in a scene of this reach.
    #[inline(always)]
    pub fn object_at<O: Objects>(&self, objects: &O, id: ObjectId, reach: f64) -> bool {
        match ObjectRef::of(objects, id) {
            ObjectRef::Sphere(index) => self.sphere_at(objects, index),
            ObjectRef::Cylinder(index) => self.cylinder_at(objects, index, reach),
        }
    }

    /// Whether the ray may meet the sphere at `index`.
    #[inline(always)]
    pub fn sphere_at<O: Objects>(&self, objects: &O, index: usize) -> bool {
        self.sphere(&ConservativeSphere::new(&objects.sphere(index).record))
    }

    /// Whether the ray may meet the cylinder at `index` among the cylinders, in a scene of this reach.
    #[inline(always)]
    pub fn cylinder_at<O: Objects>(&self, objects: &O, index: usize, reach: f64) -> bool {
        self.cylinder(&ConservativeCylinder::new(&objects.cylinder(index).record, reach))
    }
}

impl<T: MulAdd> ConservativeRay<T> {
    /// The ray.
    #[inline(always)]
    pub fn new(ray: Ray<T>) -> Self {
        Self { ray, length_squared: dot(ray.direction, ray.direction) }
    }

    /// Whether it may meet the sphere.
    #[inline(always)]
    pub fn sphere(&self, target: &ConservativeSphere<T>) -> T::Mask {
        let quadratic = self.sphere_quadratic(target);
        let Quadratic { a, c, size, .. } = quadratic;
        !quadratic.is_passed(a * size.mul_add_loosely(T::of(-MARGIN), c))
    }

    /// The sphere's quadratic.
    #[inline(always)]
    pub(super) fn sphere_quadratic(&self, target: &ConservativeSphere<T>) -> Quadratic<T> {
        let to_center = target.center - self.ray.origin;
        let (h, q) = (dot(self.ray.direction, to_center), dot(to_center, to_center));
        let (c, size) = (q - target.radius_squared, q + target.radius_squared);
        Quadratic { a: self.length_squared, h, c, size }
    }

    /// Whether it may meet the cylinder.
    #[inline(always)]
    pub fn cylinder(&self, target: &ConservativeCylinder<T>) -> T::Mask {
        let (across, slope, along) = self.cylinder_quadratic(target);
        let Quadratic { a, c, size, .. } = across;
        // Of the whole direction: what is left of it across the axis may be nothing but rounding.
        let least_product = size.mul_add_loosely(self.length_squared * T::of(-MARGIN), a * c);
        // Seen in the direction in which the ray advances: how far the first point that counts is past the middle.
        let past_middle = slope.abs().mul_add_loosely(T::of(LAMBDA_MIN), -along.flipped_by(slope));
        !(across.is_passed(least_product) | target.half_height.less(past_middle))
    }

    /// The quadratic of the cylinder's side; the direction and the way to the centre, along the axis.
    #[inline(always)]
    pub(super) fn cylinder_quadratic(&self, target: &ConservativeCylinder<T>) -> (Quadratic<T>, T, T) {
        let to_center = target.center - self.ray.origin;
        let (h, q) = (dot(self.ray.direction, to_center), dot(to_center, to_center));
        let (slope, along) = (dot(self.ray.direction, target.axis), dot(to_center, target.axis));
        let across = Quadratic {
            a: (-slope).mul_add_loosely(slope, self.length_squared),
            h: (-slope).mul_add_loosely(along, h),
            c: (-along).mul_add_loosely(along, q - target.radius_squared),
            // With the height: the ray may come in far along the axis, by an angle that rounding is large against.
            size: q + target.squares,
        };
        (across, slope, along)
    }
}

impl<T: MulAdd> Quadratic<T> {
    /// Whether the ray certainly has no root that counts, given `a c`, lowered by the margin.
    #[inline(always)]
    fn is_passed(&self, least_product: T) -> T::Mask {
        let Self { a, h, c, size } = *self;
        let most_discriminant = h.mul_add_loosely(h, -least_product);
        let least_c = size.mul_add_loosely(T::of(-MARGIN), c);
        // f at the smallest lambda that counts; where h is negative it rises from there on.
        let least_at_first = a.mul_add_loosely(T::of(LAMBDA_MIN * LAMBDA_MIN), least_c);
        let least_at_first = h.mul_add_loosely(T::of(-2.0 * LAMBDA_MIN), least_at_first);
        let zero = T::of(0.0);
        most_discriminant.less(zero) | (h.less(zero) & zero.less(least_at_first))
    }
}

#[inline(always)]
fn dot<T: MulAdd>(left: Vec3<T>, right: Vec3<T>) -> T {
    left.z.mul_add_loosely(right.z, left.y.mul_add_loosely(right.y, left.x * right.x))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact;
    use crate::geometry::cylinder::CylinderRecord;
    use crate::geometry::sphere::SphereRecord;
    use crate::sampling::uniform::Uniform;

    fn may_meet_sphere(record: &SphereRecord, ray: &Ray) -> bool {
        ConservativeRay::new(*ray).sphere(&ConservativeSphere::new(record))
    }

    fn may_meet_cylinder(record: &CylinderRecord, ray: &Ray) -> bool {
        ConservativeRay::new(*ray).cylinder(&ConservativeCylinder::new(record, 10.0))
    }

    #[test]
    fn a_ray_that_goes_outward_leaves_and_one_that_goes_inward_does_not() {
        let sphere = SphereRecord::new(Vec3::ZERO, 1.0);
        let may_meet = |direction: [f64; 3]| {
            may_meet_sphere(&sphere, &Ray { origin: Vec3::new(0.0, 1.0, 0.0), direction: direction.into() })
        };
        assert!(!may_meet([0.3, 1.0, 0.0]) && !may_meet([1.0, 1e-9, 0.0]));
        assert!(may_meet([0.3, -1.0, 0.0]) && may_meet([1.0, -1e-9, 0.0]));
    }

    #[test]
    fn a_line_beside_the_shape_is_stopped_and_one_that_touches_it_is_not() {
        let sphere = SphereRecord::new(Vec3::ZERO, 1.0);
        let cylinder = CylinderRecord::new(Vec3::ZERO, 1.0, Vec3::new(0.0, 4.0, 0.0));
        for (x, may_meet) in [(0.5, true), (1.0, true), (1.0 + 1e-15, true), (1.0 + 1e-9, false), (-1.5, false)] {
            let ray = Ray { origin: Vec3::new(x, 0.0, -3.0), direction: Vec3::new(0.0, 0.0, 2.0) };
            assert_eq!(may_meet_sphere(&sphere, &ray), may_meet, "{x}");
            assert_eq!(may_meet_cylinder(&cylinder, &ray), may_meet, "{x}");
        }
    }

    #[test]
    fn a_cylinder_is_left_by_its_side_and_by_its_bases() {
        let cylinder = CylinderRecord::new(Vec3::ZERO, 1.0, Vec3::new(0.0, 4.0, 0.0));
        let leaves = |origin: [f64; 3], direction: [f64; 3]| {
            !may_meet_cylinder(&cylinder, &Ray { origin: origin.into(), direction: direction.into() })
        };
        assert!(leaves([1.0, 0.0, 0.0], [1.0, 0.5, 0.0]));
        assert!(leaves([0.5, 2.0, 0.0], [0.1, 1.0, 0.0]));
        assert!(leaves([0.5, -2.0, 0.0], [0.1, -1.0, 0.0]));
        assert!(!leaves([1.0, 0.0, 0.0], [-1.0, 0.5, 0.0]));
        assert!(!leaves([0.5, 2.0, 0.0], [0.1, -1.0, 0.0]));
        assert!(!leaves([0.5, -2.0, 0.0], [0.1, 1.0, 0.0]));
    }

    #[test]
    fn what_is_stopped_is_never_met() {
        let mut draws = Uniform::new(21);
        let mut stopped = [0; 2];
        let mut met = [0; 2];
        for _ in 0..20_000 {
            let size = 10.0_f64.powf(draws.draw(-3.0, 6.0));
            let mut vector = |reach: f64| Vec3::from([(); 3].map(|()| draws.draw(-reach, reach)));
            let (center, normal, axis, aside) = (vector(1e3), vector(1.0).unit(), vector(3.0), vector(1.0));
            let sphere = SphereRecord::new(center, size);
            let cylinder = CylinderRecord::new(center, size, axis * size);
            // Grazing directions, where the test is hardest.
            let tilt = draws.draw(-1.0, 1.0) * 10.0_f64.powf(draws.draw(-12.0, 0.0));
            let from = |normal: Vec3| Ray {
                origin: center + normal * size,
                direction: aside.perpendicular_to(normal) + normal * tilt,
            };
            let reach = center.length() + 4.0 * size;
            let side = normal.perpendicular_to(cylinder.axis).unit();
            let (on_sphere, on_side) = (from(normal), from(side));
            let maybe = [
                ConservativeRay::new(on_sphere).sphere(&ConservativeSphere::new(&sphere)),
                ConservativeRay::new(on_side).cylinder(&ConservativeCylinder::new(&cylinder, reach)),
            ];
            let hits = [
                sphere.intersect(&on_sphere).is_some() || exact::sphere::intersect(&sphere, &on_sphere).is_some(),
                cylinder.intersect(&on_side).is_some()
                    || exact::cylinder::intersect(&cylinder, &(axis * size), &on_side).is_some(),
            ];
            for kind in 0..2 {
                assert!(maybe[kind] || !hits[kind], "{kind}: {sphere:?}, {cylinder:?}, {on_sphere:?}, {on_side:?}");
                stopped[kind] += u32::from(!maybe[kind]);
                met[kind] += u32::from(hits[kind]);
            }
        }
        assert!(stopped.iter().chain(&met).all(|&count| count > 4000), "{stopped:?} stopped, {met:?} met");
    }

    #[test]
    fn a_ray_along_the_axis_is_not_stopped_inside_the_cylinder() {
        let mut draws = Uniform::new(22);
        for number in 0..20_000 {
            let size = 10.0_f64.powf(draws.draw(-3.0, 4.0));
            let mut vector = |reach: f64| Vec3::from([(); 3].map(|()| draws.draw(-reach, reach)));
            let (center, axis, aside) = (vector(1e4), vector(3.0) * size, vector(1.0));
            let cylinder = CylinderRecord::new(center, size, axis);
            // Exactly along it, and nearly.
            let tilt = if number % 2 == 0 { 0.0 } else { 10.0_f64.powf(draws.draw(-20.0, -6.0)) };
            let across = aside.perpendicular_to(cylinder.axis);
            let direction = (cylinder.axis + across * tilt) * (axis.length() * 10.0_f64.powf(draws.draw(-3.0, 2.0)));
            let origin = cylinder.bottom + across.unit() * (size * draws.draw(0.0, 0.9));
            let touch = ConservativeRay::new(Ray { origin, direction });
            let target = ConservativeCylinder::new(&cylinder, center.length() + 5.0 * size);
            assert!(touch.cylinder(&target), "{cylinder:?}, {:?}", touch.ray);
        }
    }
}
