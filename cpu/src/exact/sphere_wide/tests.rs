//! Tests of the intersection in double-double arithmetic.

use super::*;
use crate::exact::sphere::precise;
use crate::math::vec3::Vec3;
use crate::sampling::uniform::Uniform;

/// Returns a sphere of this radius and a ray that starts near the origin. The sphere's surface passes near the
/// origin, or the sphere is far, and the ray is aimed near its rim.
fn case(radius: f64, number: usize, draws: &mut Uniform) -> (SphereRecord, Ray) {
    let mut vector = || Vec3::from([(); 3].map(|()| draws.draw(-1.0, 1.0)));
    let (mut origin, direction, up) = (vector() * 10.0, vector(), vector().unit());
    let center = match number % 5 {
        0 => Vec3::new(radius, 0.0, 0.0),
        1 => Vec3::new(0.0, -radius, 0.0),
        2 => Vec3::new(0.0, 0.0, radius),
        3 => up * radius,
        _ => origin + direction * (radius * 1e9) + direction.cross(up).unit() * (radius * 0.999_999_999),
    };
    if number.is_multiple_of(2) {
        origin = origin * 1e-17;
    }
    (SphereRecord::new(center, radius), Ray { origin, direction })
}

#[test]
fn what_is_certain_is_the_precise_answer_to_the_last_bit() {
    let mut draws = Uniform::new(23);
    let (mut certain, mut hits, mut all) = (0, 0, 0);
    for exponent in [-250, -100, -9, 0, 1, 3, 9, 15, 18, 30, 70, 140, 160, 250, 299, 307] {
        for number in 0..1000 {
            let (record, mut ray) = case(10.0_f64.powi(exponent), number, &mut draws);
            if number % 7 == 0 {
                ray.direction = ray.direction * 10.0_f64.powf(draws.draw(-60.0, 60.0));
            }
            all += 1;
            if let Decision::Certain(hit) = wide(&record, &ray) {
                assert_eq!(hit, precise(&record, &ray), "{record:?}, {ray:?}");
                certain += 1;
                hits += usize::from(hit.is_some());
            }
        }
    }
    assert!(certain * 10 > all * 7 && hits * 10 > certain * 3, "{hits} of {certain} of {all}");
}

#[test]
fn a_root_is_certain_only_if_no_midpoint_is_within_its_error() {
    let power = |exponent: i64| times_power_of_two(1.0, exponent);
    // The midpoints between 1 and its neighbours, less 1. The error comes from the dividend, from the divisor, or only
    // from the division.
    for midpoint in [power(-53), -power(-54)] {
        for (of_dividend, of_divisor) in [(power(-80), 0.0), (0.0, power(-80)), (0.0, 0.0)] {
            for (scale, share) in [1.0, power(-9), power(60)].into_iter().flat_map(|scale| [(scale, 0.5), (scale, 2.0)])
            {
                let error = 2.0 * (of_dividend + of_divisor + WIDE_ERROR);
                let low = midpoint - midpoint.signum() * share * error;
                let dividend = Bounded { value: DoubleDouble { high: 1.0, low }, error_bound: of_dividend };
                let divisor = Bounded { value: DoubleDouble::of(1.0), error_bound: of_divisor };
                let is_certain = matches!(dividend.root(divisor, scale), Root::Hits(lambda) if lambda == scale);
                assert_eq!(is_certain, share > 1.0, "{midpoint:e}, {of_dividend:e}, {of_divisor:e}, {scale:e}");
            }
        }
    }
}

#[test]
fn a_root_fails_only_if_it_certainly_rounds_to_less_than_the_limit() {
    let root = |value: f64, error_bound: f64| {
        Bounded { value: DoubleDouble::of(value), error_bound }.root(Bounded::of_size(DoubleDouble::of(1.0), 0.0), 1.0)
    };
    assert!(matches!(root(LAMBDA_MIN.next_down().next_down(), 0.0), Root::Fails));
    assert!(matches!(root(LAMBDA_MIN.next_down(), 0.0), Root::Uncertain));
    assert!(matches!(root(LAMBDA_MIN, 0.0), Root::Hits(LAMBDA_MIN)));
    assert!(matches!(root(LAMBDA_MIN / 2.0, LAMBDA_MIN / 5.0), Root::Fails));
    assert!(matches!(root(LAMBDA_MIN / 2.0, LAMBDA_MIN / 3.0), Root::Uncertain));
    assert!(matches!(root(-1.0, 0.0), Root::Fails));
    assert!(matches!(root(f64::INFINITY, 0.0), Root::Uncertain));
}

#[test]
fn a_dot_product_of_four_times_its_error_is_uncertain() {
    // `c` is 0, so the discriminant is `h^2`. In the first case the exact `h` is 3/4 to 5/4 of the computed one.
    let hit = |h: f64| {
        let (size_of_h, a) = (1.0, DoubleDouble::of(1.0));
        let h = Bounded { value: DoubleDouble::of(h), error_bound: WIDE_ERROR * size_of_h };
        Equation { a, h, size_of_h, scale: 1.0 }.hit(DoubleDouble::of(0.0), 0.0)
    };
    assert_eq!(hit(4.0 * WIDE_ERROR), Decision::Uncertain);
    assert_eq!(hit(0.5), Decision::Certain(Some(1.0)));
}

#[test]
fn most_rays_above_a_ground_of_any_radius_are_certain() {
    let mut draws = Uniform::new(5);
    for radius in [1e12, 1e18, 1e30, 1e100, 1e200, 1e300] {
        for on_or_off_axis in [1, 3] {
            let cases = (0..1000).map(|_| case(radius, on_or_off_axis, &mut draws));
            let certain = cases.filter(|(record, ray)| wide(record, ray) != Decision::Uncertain).count();
            assert!(certain > 990, "{radius:e}: {certain}");
        }
    }
}

#[test]
fn what_touches_or_has_no_number_is_uncertain() {
    let along = |x: f64, length: f64| Ray { origin: Vec3::ZERO, direction: Vec3::new(x, 0.0, length) };
    let touching = SphereRecord::new(Vec3::new(1.0, 0.0, 5.0), 1.0);
    let limit = SphereRecord::new(Vec3::new(0.0, 0.0, 1.0 + LAMBDA_MIN), 1.0);
    assert_eq!(wide(&touching, &along(0.0, 1.0)), Decision::Uncertain);
    assert_eq!(wide(&limit, &along(0.0, 1.0)), Decision::Certain(precise(&limit, &along(0.0, 1.0))));
    for length in [0.0, 1e-60, 1e60, f64::INFINITY, f64::NAN] {
        assert_eq!(wide(&touching, &along(0.0, length)), Decision::Uncertain, "{length}");
    }
    let endless = SphereRecord::new(Vec3::new(0.0, 0.0, f64::MAX), f64::INFINITY);
    assert_eq!(wide(&endless, &along(0.1, 1.0)), Decision::Uncertain);
    let from_nowhere = Ray { origin: Vec3::new(f64::INFINITY, 0.0, 0.0), direction: Vec3::new(0.0, 1.0, 0.0) };
    assert_eq!(wide(&touching, &from_nowhere), Decision::Uncertain);
}
