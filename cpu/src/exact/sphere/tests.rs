//! Tests certain and uncertain results, and directions that are not in scale.

use crate::exact::sphere::*;

fn ray(origin: [f64; 3], direction: [f64; 3]) -> Ray {
    Ray { origin: origin.into(), direction: direction.into() }
}

fn sphere(center: [f64; 3], radius: f64) -> SphereRecord {
    SphereRecord::new(center.into(), radius)
}

#[test]
fn a_clear_hit_and_a_clear_miss_are_those_of_the_plain_formula() {
    let unit = sphere([0.0; 3], 1.0);
    for (ray, expected) in [
        (ray([0.0, 0.0, -3.0], [0.0, 0.0, 0.5]), Some(4.0)),
        (ray([0.0, 0.0, 0.0], [0.0, 0.0, 1.0]), Some(1.0)),
        (ray([1.1, 0.0, -3.0], [0.0, 0.0, 1.0]), None),
        (ray([0.0, 0.0, 3.0], [0.0, 0.0, 1.0]), None),
    ] {
        assert_eq!(filtered(&unit, &ray), Decision::Certain(expected));
        assert_eq!(intersect(&unit, &ray), unit.intersect(&ray));
    }
}

#[test]
fn a_tangent_is_in_doubt_and_resolved_to_the_last_bit() {
    let touching = sphere([0.1, 0.0, 1e6], 0.1);
    let ray = ray([0.0; 3], [0.0, 0.0, 3.0]);
    assert_eq!(filtered(&touching, &ray), Decision::Uncertain);
    assert_eq!(intersect(&touching, &ray), Some(1e6 / 3.0));
    assert_eq!(intersect(&sphere([0.1_f64.next_up(), 0.0, 1e6], 0.1), &ray), None);
    assert!(intersect(&sphere([0.1_f64.next_down(), 0.0, 1e6], 0.1), &ray).is_some());
}

#[test]
fn a_near_root_that_rounding_may_have_made_too_small_is_uncertain() {
    let large = sphere([0.5999232797220704, -0.5567519213587497, -0.02379883261257265], 313605.6517245435);
    let ray = ray(
        [-50868.01104692802, 181221.71932926742, -250837.37428897855],
        [-0.27851123377901166, -0.527934471228203, 0.746327422872379],
    );
    assert_eq!(filtered(&large, &ray), Decision::Uncertain);
    // The other root is 588451.4.
    assert!(intersect(&large, &ray).is_some_and(|lambda| lambda < 0.01));
}

#[test]
fn the_limit_itself_counts_and_the_number_below_does_not() {
    // 1.001 is not an f64: its neighbours put the surface on either side of the limit.
    let wall = |center: f64| sphere([center, 0.0, 0.0], 1.0);
    let along = ray([0.0; 3], [1.0, 0.0, 0.0]);
    let (nearer, farther) = (1.001_f64, 1.001_f64.next_up());
    assert!(nearer - 1.0 < 1e-3 && farther - 1.0 > 1e-3);
    assert_eq!(filtered(&wall(nearer), &along), Decision::Uncertain);
    assert_eq!(intersect(&wall(nearer), &along), Some(2.001), "the far root");
    assert_eq!(intersect(&wall(farther), &along), Some(farther - 1.0));
    // This ray starts exactly 1e-3 before the sphere, so the smaller root is the limit itself.
    let limit = ray([-1e-3, 0.0, 0.0], [1.0, 0.0, 0.0]);
    assert_eq!(intersect(&wall(1.0), &limit), Some(1e-3));
    assert_eq!(intersect(&wall(1.0), &ray([-1e-3_f64.next_down(), 0.0, 0.0], [1.0, 0.0, 0.0])), Some(2.001));
}

#[test]
fn a_null_direction_and_nan_give_what_the_plain_formula_gives() {
    let unit = sphere([0.0; 3], 1.0);
    assert_eq!(intersect(&unit, &ray([0.0; 3], [0.0; 3])), None);
    assert_eq!(intersect(&unit, &ray([0.0, 0.0, f64::NAN], [0.0, 0.0, 1.0])), None);
    let infinite = ray([0.0, 0.0, -3.0], [0.0, 0.0, f64::INFINITY]);
    assert_eq!(intersect(&unit, &infinite), unit.intersect(&infinite));
}

#[test]
fn scales_beyond_the_squares_of_f64_are_met_all_the_same() {
    for scale in [1e-300, 1e-170, 1e170, 1e300] {
        let sphere = sphere([0.0; 3], scale);
        let ray = ray([0.0, 0.0, -3.0 * scale], [0.0, 0.0, scale]);
        let lambda = intersect(&sphere, &ray).unwrap_or(f64::NAN);
        assert!((lambda - 2.0).abs() < 1e-15, "{scale:e}: {lambda}");
    }
}

#[test]
fn the_error_of_a_discriminant_is_32_roundings_of_a_size_that_is_given_2_to_the_24_times_as_large() {
    let expected = 32.0 * f64::EPSILON / 2.0 / f64::from(1 << 24);
    assert_eq!(crate::exact::sphere_filter::SPHERE_BOUND.error_of_size(), expected);
}
