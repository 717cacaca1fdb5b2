//! Rays that certainly meet an object, because they are inside of it where they begin to count: somewhere they come
//! out.
//!
//! Where the last ray of a path ends nobody asks, and where all objects scatter not even at which: it takes one random
//! vector more, and nothing comes back along it.
//!
//! A ray is inside only where comparisons hold, which none does with what is not a number, and only if the length of
//! its direction is between 2^-150 and 2^150: with coordinates of up to 10^9 nothing overflows then.

use crate::accel::conservative::{ConservativeRay, MARGIN, Quadratic};
use crate::accel::small_scene::SmallScene;
use crate::accel::target::{ConservativeCylinder, ConservativeSphere, SLACK};
use crate::exact::error_bound::in_scale;
use crate::geometry::cylinder::PARALLEL;
use crate::geometry::ray::{LAMBDA_MIN, Ray};
use crate::layout::Objects;

/// The least product of a direction and an axis with which a ray certainly meets the planes of the bases: twice the
/// limit, and a share of the direction's length, squared, that rounding is nothing against.
const STEEP: f64 = 2.0 * PARALLEL;
const STEEP_SHARE: f64 = 1.0 / (1_u64 << 40) as f64;

impl ConservativeRay<f64> {
    /// Whether the ray is certainly inside the sphere at the smallest lambda that counts.
    #[inline(always)]
    fn starts_in_sphere(&self, target: &ConservativeSphere) -> bool {
        self.starts_within(&self.sphere_quadratic(target))
    }

    /// Whether it is certainly inside the cylinder there, in a scene of this reach, and not parallel to its bases.
    #[inline(always)]
    fn starts_in_cylinder(&self, target: &ConservativeCylinder, reach: f64) -> bool {
        let (across, slope, along) = self.cylinder_quadratic(target);
        let (height, least_half_height) = (slope * LAMBDA_MIN - along, target.half_height - reach * (2.0 * SLACK));
        let is_steep = slope.abs() > STEEP && slope * slope > self.length_squared * STEEP_SHARE;
        self.starts_within(&across) & (height.abs() < least_half_height) & is_steep
    }

    /// Whether the quadratic is certainly negative at the smallest lambda that counts.
    #[inline(always)]
    fn starts_within(&self, &Quadratic { a, h, c, size }: &Quadratic<f64>) -> bool {
        const SQUARED: f64 = LAMBDA_MIN * LAMBDA_MIN;
        let most_c = c + (size + self.length_squared * SQUARED) * MARGIN;
        a * SQUARED - h * (2.0 * LAMBDA_MIN) + most_c < 0.0
    }
}

impl SmallScene {
    /// Whether a ray, which starts within the scene's reach, is certainly inside one of the objects where it begins to
    /// count, and so meets one.
    #[inline(always)]
    pub fn starts_inside<O: Objects>(&self, objects: &O, ray: &Ray) -> bool {
        let touch = ConservativeRay::new(*ray);
        let mut inside = false;
        for index in 0..objects.sphere_count() {
            inside |= touch.starts_in_sphere(&ConservativeSphere::new(&objects.sphere(index).record));
        }
        for index in 0..objects.cylinder_count() {
            let target = ConservativeCylinder::new(&objects.cylinder(index).record, self.reach());
            inside |= touch.starts_in_cylinder(&target, self.reach());
        }
        // A direction that is null meets nothing.
        inside & in_scale(touch.length_squared)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact;
    use crate::geometry::cylinder::CylinderRecord;
    use crate::geometry::sphere::SphereRecord;
    use crate::math::vec3::Vec3;
    use crate::sampling::uniform::Uniform;

    #[test]
    fn what_begins_inside_is_met() {
        let mut draws = Uniform::new(31);
        let (mut inside, mut met) = ([0; 2], [0; 2]);
        for _ in 0..40_000 {
            let size = 10.0_f64.powf(draws.draw(-3.0, 6.0));
            let mut vector = |reach: f64| Vec3::from([(); 3].map(|()| draws.draw(-reach, reach)));
            let (center, axis, outward, mut direction) = (vector(1e3), vector(3.0) * size, vector(1.0), vector(1.0));
            // From near the surface, the base or the rim, and so that the first lambda that counts is near it too.
            let start = 1.0 + draws.draw(-1.0, 1.0) * 10.0_f64.powf(draws.draw(-14.0, 0.0));
            direction = direction * (size * 10.0_f64.powf(draws.draw(-9.0, 6.0)));
            if draws.draw(0.0, 1.0) < 0.2 {
                direction = direction.perpendicular_to(axis.unit()) + axis * 10.0_f64.powf(draws.draw(-17.0, -6.0));
            }
            let sphere = SphereRecord::new(center, size);
            let cylinder = CylinderRecord::new(center, size, axis);
            let side = outward.perpendicular_to(cylinder.axis).unit();
            let along = cylinder.axis * (cylinder.half_height * draws.draw(-1.0, 1.0) * start);
            let reach = center.length() + size + axis.length();
            let on_sphere = Ray { origin: center + outward.unit() * (size * start), direction };
            let on_cylinder = Ray { origin: center + side * (size * start) + along, direction };
            let found = [
                ConservativeRay::new(on_sphere).starts_in_sphere(&ConservativeSphere::new(&sphere)),
                ConservativeRay::new(on_cylinder)
                    .starts_in_cylinder(&ConservativeCylinder::new(&cylinder, reach), reach),
            ];
            let hits = [
                exact::sphere::intersect(&sphere, &on_sphere).is_some(),
                exact::cylinder::intersect(&cylinder, &axis, &on_cylinder).is_some(),
            ];
            for kind in 0..2 {
                assert!(hits[kind] || !found[kind], "{kind}: {sphere:?}, {cylinder:?}, {on_sphere:?}, {on_cylinder:?}");
                inside[kind] += u32::from(found[kind]);
                met[kind] += u32::from(hits[kind]);
            }
        }
        assert!((0..2).all(|kind| inside[kind] > met[kind] / 2 && inside[kind] > 4000), "{inside:?} of {met:?}");
    }

    #[test]
    fn at_the_limits_nothing_is_certain() {
        let sphere = ConservativeSphere::new(&SphereRecord::new(Vec3::ZERO, 1.0));
        let cylinder = ConservativeCylinder::new(&CylinderRecord::new(Vec3::ZERO, 1.0, Vec3::new(0.0, 2.0, 0.0)), 4.0);
        let touch = |origin: [f64; 3], direction: [f64; 3]| {
            ConservativeRay::new(Ray { origin: origin.into(), direction: direction.into() })
        };
        // Inward and outward from the surface; from where the limit is on the surface.
        assert!(touch([1.0, 0.0, 0.0], [-1.0, 0.0, 0.0]).starts_in_sphere(&sphere));
        assert!(!touch([1.0, 0.0, 0.0], [1.0, 0.0, 0.0]).starts_in_sphere(&sphere));
        assert!(!touch([1.0 - LAMBDA_MIN, 0.0, 0.0], [1.0, 0.0, 0.0]).starts_in_sphere(&sphere));
        let begins = |origin, direction| touch(origin, direction).starts_in_cylinder(&cylinder, 4.0);
        assert!(begins([1.0, 0.0, 0.0], [-1.0, 0.1, 0.0]) && begins([0.0, 1.0, 0.0], [0.1, -1.0, 0.0]));
        assert!(!begins([0.0, 1.0, 0.0], [0.1, 1.0, 0.0]) && !begins([0.0, 1.0 - LAMBDA_MIN, 0.0], [0.0, 1.0, 0.0]));
        // Parallel to the bases it might meet nothing but one of them, which then does not count.
        assert!(!begins([0.0, 0.0, 0.0], [1.0, 1e-9, 0.0]) && begins([0.0, 0.0, 0.0], [1.0, 1e-4, 0.0]));
    }
}
