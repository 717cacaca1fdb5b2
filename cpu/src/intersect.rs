//! Functions that intersect a ray with one sphere or cylinder.
//!
//! [`sphere`] and [`cylinder`] are exact: they decide between hit and miss as infinitely precise arithmetic would. If
//! the filter is certain, lambda has the bits of the plain formula. The methods `intersect` of [`SphereRecord`] and
//! [`CylinderRecord`] are the plain formulas (specification, section 9) in `f64`.

pub use crate::exact::cylinder::intersect as cylinder;
pub use crate::exact::sphere::intersect as sphere;
pub use crate::geometry::cylinder::{CylinderPart, CylinderRecord};
pub use crate::geometry::sphere::SphereRecord;

#[cfg(test)]
mod tests {
    //! Tests each step of the exact intersections alone.

    use super::{CylinderPart, CylinderRecord, SphereRecord};
    use crate::exact::cylinder_lanes::SideLanes;
    use crate::exact::cylinder_plain::is_long;
    use crate::exact::cylinder_plain::{PlainCaps, PlainSide};
    use crate::exact::error_bound::{Decision, in_scale};
    use crate::exact::{cylinder, sphere};
    use crate::{geometry::ray::Ray, math::vec3::Vec3};

    fn ray(origin: [f64; 3], direction: [f64; 3]) -> Ray {
        Ray { origin: origin.into(), direction: direction.into() }
    }

    #[test]
    fn limits_of_scale_and_of_length_count_themselves() {
        let (least, most) = (2.0_f64.powi(-300), 2.0_f64.powi(300));
        let lengths = [least.next_down(), least, most, most.next_up(), f64::NAN];
        assert_eq!(lengths.map(in_scale), [false, true, true, false, false]);
        // A long cylinder is more than 16 radii high.
        let with_height = |height| CylinderRecord::new(Vec3::ZERO, 1.0, Vec3::new(0.0, height, 0.0));
        assert_eq!([16.0, 16.5].map(|height| is_long(&with_height(height))), [false, true]);
    }

    #[test]
    fn each_step_for_spheres_gives_the_hit_or_is_uncertain() {
        let unit = SphereRecord::new(Vec3::ZERO, 1.0);
        for (ray, hit, is_clear) in [
            (ray([0.0, 0.0, -3.0], [0.0, 0.0, 0.5]), Some(4.0), true),
            (ray([0.0, 0.0, 0.0], [0.0, 0.0, 1.0]), Some(1.0), true),
            (ray([1.1, 0.0, -3.0], [0.0, 0.0, 1.0]), None, true),
            (ray([1.0, 0.0, -3.0], [0.0, 0.0, 1.0]), Some(3.0), false),
        ] {
            let direction = ray.direction;
            let lanes = sphere::filtered_from(&unit.seen_from(ray.origin), direction, direction.dot(direction));
            assert_eq!(lanes.certain, is_clear, "{ray:?}");
            assert!(!is_clear || lanes.lambda == hit.unwrap_or(f64::INFINITY), "{ray:?}");
            let expected = if is_clear { Decision::Certain(hit) } else { Decision::Uncertain };
            assert_eq!(sphere::filtered_or_compensated(&unit, &ray), expected);
            assert_eq!(sphere::compensated_or_precise(&unit, &ray), hit);
        }
    }

    #[test]
    fn each_step_for_cylinders_gives_the_hit_or_is_uncertain() {
        let axis = Vec3::new(0.0, 4.0, 0.0);
        let upright = CylinderRecord::new(Vec3::ZERO, 1.0, axis);
        for (ray, hit, is_clear) in [
            (ray([0.0, 0.0, -3.0], [0.0, 0.0, 0.5]), Some((4.0, CylinderPart::Side)), true),
            (ray([0.0, 0.0, 0.0], [0.0, 0.5, 0.125]), Some((4.0, CylinderPart::Top)), true),
            (ray([0.0, -4.0, 0.0], [0.125, 1.0, 0.0]), Some((2.0, CylinderPart::Bottom)), true),
            (ray([0.0, 3.0, -3.0], [0.0, 0.0, 1.0]), None, true),
            (ray([0.0, 4.0, -3.0], [0.0, -1.0, 1.0]), Some((2.0, CylinderPart::Side)), false),
        ] {
            let side = SideLanes::new(&PlainSide::new(&upright, &upright.seen_from(ray.origin), &ray, false));
            let lanes = side.with_caps(&upright, &ray, &PlainCaps);
            assert_eq!(lanes.certain, is_clear, "{ray:?}");
            if is_clear {
                let part = |(_, part)| (part == CylinderPart::Top, part == CylinderPart::Bottom);
                assert_eq!((lanes.top, lanes.bottom), hit.map_or((false, false), part));
                assert_eq!(lanes.lambda, hit.map_or(f64::INFINITY, |(lambda, _)| lambda));
            }
            assert_eq!(cylinder::compensated_or_precise(&upright, &axis, &ray), hit);
        }
    }
}
