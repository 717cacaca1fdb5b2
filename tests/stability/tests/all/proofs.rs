//! Proves the margins of `cpu`, and holds the proofs against numbers.

use cpu::internals::exact::sphere_filter;
use cpu::internals::geometry::{cylinder::CylinderRecord, sphere::SphereRecord};
use cpu::internals::math::{double_double::DoubleDouble, real::Real};
use cpu::{Ray, Vec3};
use stability::proof::bounded::{Bounded, begin, compared};
use stability::proof::bounds::Arithmetic;
use stability::proof::{self, row::Row, row::U, row::added, row::family, row::is, row::squared};
use stability::random::Random;
use stability::run::PROVEN_ERRORS;

#[test]
fn every_margin_is_as_large_as_proved() {
    for row in proof::rows() {
        assert!(row.need > 1.0 && row.holds(), "{row:?}");
        let of_sphere = ["lambda of a sphere", "lambda of a sphere, compensated"].contains(&row.what);
        if row.what.starts_with("lambda of") {
            assert!(row.need * U <= PROVEN_ERRORS[usize::from(!of_sphere)], "{row:?}");
        }
    }
}

#[test]
fn the_page_has_the_table_of_the_margins() {
    let page = include_str!("../../../../docs/margins.md");
    let table = page.lines().skip_while(|line| !line.starts_with("| Margin |")).take_while(|line| !line.is_empty());
    let lines = proof::rows().into_iter().map(|Row { what, file, constant, need, unit }| {
        // The bounds are rounded up, by far less than 10^-6.
        let need = (need * 10.0 - 1e-5).ceil() / 10.0;
        format!("| {what} | `{file}` | {constant:.0} | {need:.1} | `{unit}` |")
    });
    let lines: Vec<_> = lines.collect();
    assert!(table.skip(2).eq(&lines), "docs/margins.md needs this table:\n{}", lines.join("\n"));
}

#[test]
fn a_margin_that_the_formulas_do_not_use_is_zero() {
    let constant = |margin: f64| {
        begin(Arithmetic::F64, margin);
        let (origin, direction) = (Bounded::vector(family::ORIGIN, 0.0), Bounded::vector(family::DIRECTION, 0.0));
        let record = SphereRecord::new(Bounded::vector(family::CENTER, 0.0), Bounded::number(family::RADIUS, 0.0));
        is(record.center - origin, family::TO_CENTER);
        _ = sphere_filter::filtered_from(&record.seen_from(origin), direction, direction.dot(direction));
        let size = squared(family::DIRECTION).times(&squared(family::RADIUS));
        compared().iter().map(|pair| added(pair[0], &size, margin, f64::EPSILON / 2.0)).fold(0.0, f64::max)
    };
    let margin = sphere_filter::SPHERE_BOUND.error_of_size();
    assert_eq!(constant(margin).round(), sphere_filter::SPHERE_BOUND.error_constant);
    assert_eq!(constant(margin * 2.0), 0.0, "the code does not use this constant");
}

/// Returns the largest errors of the discriminants of a sphere and of a cylinder in random cases, in units of `u M`.
fn largest_errors() -> [f64; 2] {
    fn discriminants<T: Real>([center, axis, origin, direction]: [Vec3; 4], radius: f64) -> [T; 3] {
        let of = |vector: Vec3| vector.map(T::of);
        let (ray, radius) = (Ray { origin: of(origin), direction: of(direction) }, T::of(radius));
        let a = ray.direction.dot(ray.direction);
        let view = SphereRecord::new(of(center), radius).seen_from(ray.origin);
        let cylinder = CylinderRecord::new(of(center), radius, of(axis));
        let (.., side) = cylinder.quadratic(&cylinder.seen_from(ray.origin), ray.direction);
        [view.quadratic(ray.direction, a).1, side, a * view.squares]
    }
    let mut random = Random::new(47);
    let mut largest = [0.0_f64; 2];
    for _ in 0..100_000 {
        let mut vector = || random.cube(1.0);
        let vectors = [vector(), vector(), vector(), vector()];
        let radius = random.decades(-3.0, 1.0);
        let (computed, exact) = (discriminants::<f64>(vectors, radius), discriminants::<DoubleDouble>(vectors, radius));
        for (largest, index) in largest.iter_mut().zip(0..) {
            let error = (DoubleDouble::of(computed[index]) - exact[index]).high.abs();
            *largest = largest.max(error / (f64::EPSILON / 2.0 * exact[2].high));
        }
    }
    largest
}

#[test]
fn no_discriminant_in_f64_is_more_wrong_than_proved() {
    let rows = proof::rows();
    let need = |what: &str| rows.iter().find(|row| row.what == what).expect("there is such a row").need;
    let proved = [need("discriminant of a sphere"), need("discriminant of a cylinder")];
    for (largest, proved) in largest_errors().into_iter().zip(proved) {
        assert!(largest <= proved && largest > 1.0, "{largest} of {proved}");
    }
}

#[test]
fn a_smaller_remainder_is_refused_where_the_second_derivative_is_largest() {
    // The largest half of a second derivative is 1 / sqrt(3), for `d = (sqrt(2), 1)`.
    let place = proof::background::remainder_is_at_most(0.577).expect_err("it is too small");
    let x = f64::midpoint(place[0].low, place[0].high).abs();
    assert!((x - 0.5_f64.sqrt()).abs() < 0.02, "{place:?}");
}
