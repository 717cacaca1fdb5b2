//! The margins of the exact intersections: quadratics of spheres and cylinders, and the planes of caps.

use cpu::internals::exact::compensated_roots::{ACCURACY_OF_C, CONDITION_LIMIT, ERROR_OF_C, ERROR_OF_ROOT};
use cpu::internals::exact::cylinder_compensated::ROUNDINGS_OF_CAP;
use cpu::internals::exact::cylinder_decision::CYLINDER_BOUND;
use cpu::internals::exact::cylinder_lanes::SideLanes;
use cpu::internals::exact::cylinder_plain::{PlainSide, SHARE_ACROSS_AXIS, SHARE_OF_WHOLE};
use cpu::internals::exact::error_bound::{BoundConstants, HEADROOM, NUMERATOR_WEIGHT, UNDERFLOW};
use cpu::internals::exact::sphere_filter;
use cpu::internals::geometry::{ray::LAMBDA_MIN, sphere::SphereRecord};
use cpu::internals::math::real::Real;
use cpu::internals::render::hit_lanes::DISCRIMINANT_ERROR;

use super::bounded::{Bounded, Operation, begin, compared, forget_later};
use super::bounds::Arithmetic;
use super::compensated;
use super::parts::{self, record};
use super::polynomial::Polynomial;
use super::quadratic::QuadraticErrors;
use super::row::{
    IN_SCALE, Row, U, added, enlarged, family::*, is, length, ray, relative_to_sizes, squared, uses_of_margin,
};

/// Returns the rows of all margins.
#[must_use]
pub fn rows() -> Vec<Row> {
    let sphere = quadratic(sphere_filter::SPHERE_BOUND, "exact/sphere_filter.rs", sphere);
    let cylinder = side_errors();
    let [sphere_lambda, side_lambda] = [sphere.lambda(0.0), cylinder.lambda(cylinder.a / 2.0 * 2.0_f64.sqrt())];
    let mut rows = Vec::new();
    for (quadratic, lambda, names) in [
        (&sphere, sphere_lambda, ["discriminant of a sphere", "numerator of a sphere's root", "lambda of a sphere"]),
        (&cylinder, side_lambda, ["discriminant of a cylinder", "numerator of a side's root", "lambda of a side"]),
    ] {
        let QuadraticErrors { constants, constant, file, discriminant, .. } = *quadratic;
        // A third of the margin of lambda is for lambda's own error.
        let of_lambda = constants.lambda_error() / 3.0 / U;
        let margins = [
            ([constant, discriminant], "u M"),
            ([constant, quadratic.numerator()], "u M / sqrt(D)"),
            ([of_lambda, lambda], "u lambda"),
        ];
        let named = names.into_iter().zip(margins);
        rows.extend(named.map(|(what, (margins, unit))| Row::new(what, file, margins, unit)));
    }
    rows.push(inside());
    rows.extend(long_cylinder(cylinder.a));
    let (of_sphere, sphere_range, sphere_h) = compensated::sphere_rows();
    let (of_side, side_range, [side_a, side_h]) = compensated::side_rows();
    let constant = sphere.constants.lambda_error() / 3.0 / U;
    let names = ["lambda of a sphere, compensated", "lambda of a side, compensated"];
    for ((what, rows_of), [a, h]) in
        names.into_iter().zip([&of_sphere, &of_side]).zip([[3.0, sphere_h], [side_a, side_h]])
    {
        let need = of_w(rows_of, h) * CONDITION_LIMIT + rows_of[0].need / ERROR_OF_C * ACCURACY_OF_C + a + 5.0;
        rows.push(Row::new(what, compensated::ROOTS, [constant, need], "u lambda"));
    }
    let crossing = of_w(&of_side, side_h) + side_a + 5.0;
    rows.extend(of_sphere);
    rows.push(compensated::leaves(sphere_h));
    rows.extend(of_side);
    rows.push(sphere_range);
    rows.extend(side_range);
    rows.push(compensated::plane());
    // A ray is steep enough if `|d|^2 <= 4 k^2 |d'|^2`, with 4 for the constant of the code.
    let steep = SHARE_ACROSS_AXIS.sqrt() * cylinder.constants.condition_limit;
    let of_a =
        |what, of: &QuadraticErrors, need| Row::new(what, of.file, [of.constants.lambda_error() / U, need], "u a");
    let in_lanes = [DISCRIMINANT_ERROR / U, cylinder.discriminant];
    rows.extend([
        of_a("a of a sphere", &sphere, sphere.a),
        of_a("a of a steep ray and a side", &cylinder, cylinder.a * steep),
        Row::new("all rays miss, in lanes", "render/hit_lanes.rs", in_lanes, "u M"),
    ]);
    let of_parts = parts::rows(side_lambda);
    // What the heights and the distances need beside the error of lambda.
    let beside =
        |what: &str, of: f64| of_parts.iter().find(|row| row.what == what).map_or(f64::NAN, |row| row.need - of);
    let height = beside("height of a hit, due to lambda", side_lambda);
    let of_cap = of_parts.iter().find(|row| row.what == "lambda of a cap").map_or(f64::NAN, |row| row.need);
    let distance = beside("distance from a cap's centre, due to lambda", of_cap);
    let (height, distance) = ([ERROR_OF_ROOT, crossing + height], [ROUNDINGS_OF_CAP, distance + 1.0]);
    rows.push(Row::new("height of a crossing, compensated", compensated::ROOTS, height, "u k lambda abs(d)"));
    rows.push(Row::new("distance from a cap's centre, compensated", compensated::FILE, distance, "u lambda abs(d)"));
    rows.extend(of_parts);
    rows
}

/// Returns the errors of the side of a cylinder.
pub fn side_errors() -> QuadraticErrors {
    quadratic(CYLINDER_BOUND, "exact/cylinder_decision.rs", || cylinder(false))
}

/// Returns the row of `c`, which shows that a ray starts inside an infinite cylinder.
fn inside() -> Row {
    let margin = CYLINDER_BOUND.error_of_size();
    begin(Arithmetic::F64, margin);
    let [_, _, c, _] = cylinder(false);
    let pairs = compared();
    let [error, _] = pairs.iter().find(|pair| pair[1] == -c).expect("the code compares it");
    let size = squared(TO_CENTER).plus(&squared(RADIUS));
    let (constant, need) = (added(*error, &size, margin, U), IN_SCALE.relative(&c.bounds().error, &size, margin));
    Row::new("c of a cylinder", "exact/cylinder_decision.rs", [constant, need], "u (q + R^2)")
}

/// The family of `S`; see [`long_cylinder`].
const S: u8 = DERIVED + 9;
/// The family of `m`; see [`long_cylinder`].
const LONG: u8 = DERIVED + 10;

/// Returns the rows of the side of a long cylinder. `of_a` is the error of `a`, relative to `|d| |d'|`.
///
/// The size is `m = |d'| S (|d| S + |d'| |O - C|)`, and a share of `M` covers the terms of second order. As `sqrt(D) <=
/// |d'| S` and `n^2 <= 2 |d'|^2 S^2`, the argument is that of [`QuadraticErrors`] with `m` in place of `M`. For lambda,
/// `n^2 Ea / a` is at most `2 Ea S^2`. All terms are at most a multiple of `m`.
fn long_cylinder(of_a: f64) -> [Row; 3] {
    let constants = CYLINDER_BOUND;
    let margin = constants.error_of_size();
    begin(Arithmetic::F64, margin);
    let run = || {
        let [a, h, c, discriminant] = cylinder(true);
        ([h, c, discriminant], error_of(constants, [a, h, discriminant]))
    };
    // `m^2` is at most `2 |d'|^2 S^2 (|d|^2 S^2 + |d'|^2 |O - C|^2)`.
    let [_, twice] = root_of_long(run().1);
    let Operation::Sum(product, _) = twice.operation() else { unreachable!() };
    let [_, [across, _]] = [product, factors_of(product)[1]].map(factors_of);
    across.assume_relative(squared(S), 0.0);
    _ = across.of_squares();
    forget_later(across);
    let [root, twice] = root_of_long(run().1);
    let of_center = squared(DIRECTION_ACROSS).times(&squared(TO_CENTER));
    let inner = squared(DIRECTION).times(&squared(S)).plus(&of_center);
    let square = squared(DIRECTION_ACROSS).times(&squared(S)).times(&inner).scaled(2.0);
    assert!(twice.bounds().size.covers(&square), "the size of a long cylinder lacks a part");
    root.assume_relative(length(LONG), 0.0);
    _ = root.of_squares();
    forget_later(root);
    let [h, c, discriminant] = run().0;
    let [across, whole] = [squared(DIRECTION_ACROSS), squared(DIRECTION).times(&squared(TO_CENTER))];
    let constant = added(run().1, &length(LONG).plus(&whole.scaled(SHARE_OF_WHOLE)), margin, U);
    let needs = [
        h.bounds().error.times(&length(DIRECTION_ACROSS)).times(&length(RADIUS)),
        c.bounds().error.times(&across),
        discriminant.bounds().error,
    ];
    let [of_h, of_c, of_discriminant] = needs.map(|error| relative_to_long(&error));
    let lambda = (of_a + 2.0_f64.sqrt() * of_h + of_c / 2.0 + 2.5) * constants.condition_limit + 2.0;
    let row = |what, constant, need, unit| Row::new(what, "exact/cylinder_decision.rs", [constant, need], unit);
    [
        row("discriminant of a long cylinder", constant, of_discriminant, "u m"),
        row("numerator of a long side's root", constant, of_discriminant + 1.0 + of_h + 2.0, "u m / sqrt(D)"),
        row("lambda of a long side", constants.lambda_error() / 3.0 / U, lambda, "u lambda"),
    ]
}

fn factors_of(product: Bounded) -> [Bounded; 2] {
    let Operation::Product(a, b) = product.operation() else { panic!("it is no product") };
    [a, b]
}

/// Returns the root in the size of a long cylinder, and the number of which it is the root. The error of the
/// discriminant is a multiple of this size, which is a sum of a multiple of the root, the share and underflow, and then
/// underflow.
fn root_of_long(error: Bounded) -> [Bounded; 2] {
    let first_term = |sum: Bounded| {
        let Operation::Sum(first, _) = sum.operation() else { panic!("it is no sum") };
        first
    };
    let [root, _] = factors_of(first_term(first_term(factors_of(first_term(error))[0])));
    let Operation::Root(square) = root.operation() else { panic!("it is no root") };
    [root, square]
}

/// Returns an error relative to `m` and the share of `M`. Lengths across the axis and the radius are at most `S`.
fn relative_to_long(error: &Polynomial) -> f64 {
    const ACROSS: u8 = DERIVED + 8;
    let named = |polynomial: &Polynomial| {
        let families =
            [(DIRECTION_ACROSS, ACROSS), (TO_CENTER_ACROSS, S), (RADIUS, S)].map(|(old, new)| (old, Some(new)));
        polynomial.enlarged(&families).enlarged(&[(AXIS, None)])
    };
    let inner = squared(ACROSS).times(&squared(S));
    let size = length(ACROSS).times(&length(DIRECTION)).times(&squared(S));
    let size = size.plus(&squared(ACROSS).times(&length(S)).times(&length(TO_CENTER)));
    let (mut first, mut rest) = (Polynomial::default(), Polynomial::default());
    for (monomial, &coefficient) in &error.0 {
        let one = Polynomial::of(monomial.clone()).scaled(coefficient);
        let is_first = named(&one).0.keys().all(|name| inner.0.contains_key(name) || size.0.contains_key(name));
        let part = if is_first { &mut first } else { &mut rest };
        *part = part.clone().plus(&one);
    }
    let whole = squared(DIRECTION).times(&squared(TO_CENTER).plus(&squared(RADIUS)));
    let rest = IN_SCALE.relative(&rest, &whole, LAMBDA_MIN);
    relative_to_sizes(&named(&first), 0.0, &[size, inner], 1.0) + rest / SHARE_OF_WHOLE
}

/// Returns the error of `w`, relative to `w` and in units of `u` times its condition, as docs/accuracy.md derives.
/// `of_h` is the need of `h`. The discriminant exceeds the error that the code takes, so its root is far above 0.
fn of_w([_, near, far]: &[Row; 3], of_h: f64) -> f64 {
    let share = near.need.max(far.need) / near.constant;
    share * sphere_filter::SPHERE_BOUND.error_constant / (1.0 + (1.0 - share).sqrt()) + of_h
}

/// Returns the errors of the quadratic whose `a`, `h`, `c` and discriminant `run` computes, together with its filter.
fn quadratic(constants: BoundConstants, file: &'static str, run: impl Fn() -> [Bounded; 4]) -> QuadraticErrors {
    begin(Arithmetic::F64, LAMBDA_MIN * constants.lambda_error());
    run();
    // Both roots are compared with the smallest lambda from both sides.
    assert_eq!(uses_of_margin(), 4, "{file}: the margin of lambda is not used, or on the wrong side");
    let margin = constants.error_of_size();
    begin(Arithmetic::F64, margin);
    let [a, h, c, discriminant] = run();
    let size = squared(DIRECTION).times(&squared(TO_CENTER).plus(&squared(RADIUS)));
    let error = error_of(constants, [a, h, discriminant]);
    let relative = |number: Bounded, size: &Polynomial| IN_SCALE.relative(&number.bounds().error, size, margin);
    let c = enlarged(&c.bounds().error);
    let constant = error.bounds().size.coefficient(&Polynomial::constant(1.0));
    assert_eq!(constant, UNDERFLOW, "the error bound covers underflow");
    QuadraticErrors {
        constants,
        constant: added(error, &size, margin, U),
        file,
        a: relative(a, &squared(DIRECTION)),
        h: relative(h, &length(DIRECTION).times(&length(TO_CENTER))),
        c: [TO_CENTER, RADIUS].map(|family| c.coefficient(&squared(family))),
        discriminant: relative(discriminant, &size),
    }
}

/// Returns the bound `E` of the error with which the code compares the discriminant.
///
/// # Panics
/// If the code does not compare both roots as [`QuadraticErrors`] takes them: with `E`, with the least lambda in range
/// and with the condition limit.
fn error_of(constants: BoundConstants, [a, h, discriminant]: [Bounded; 3]) -> Bounded {
    let (pairs, of) = (compared(), Bounded::of);
    let [error, _] = *pairs.iter().find(|pair| pair[1] == -discriminant).expect("a filter compares the discriminant");
    let Operation::Sum(product, _) = error.operation() else { panic!("it is no sum") };
    let ([size, _], share, root) = (factors_of(product), 1.0 / constants.condition_limit, discriminant.sqrt());
    let (least, margin) = (of(LAMBDA_MIN), of(LAMBDA_MIN * constants.lambda_error()));
    for numerator in [h - root, h + root] {
        let terms =
            (size * of(share / HEADROOM) + of(UNDERFLOW)) + numerator * numerator * of(NUMERATOR_WEIGHT * share);
        for (what, pair) in [
            ("whether a root is too small", [error, (a * (least - margin) - numerator) * root]),
            ("whether a root is in range", [least + margin, numerator / a]),
            ("whether a root is accurate", [terms, root * numerator]),
        ] {
            assert!(pairs.contains(&pair), "the code does not decide {what} as the proof takes it");
        }
    }
    error
}

/// Runs the formulas of a sphere. Returns `a`, `h`, `c` and the discriminant.
pub fn sphere() -> [Bounded; 4] {
    let (ray, center) = (ray(), Bounded::vector(CENTER, 0.0));
    is(center - ray.origin, TO_CENTER);
    let view = SphereRecord::new(center, Bounded::number(RADIUS, 0.0)).seen_from(ray.origin);
    let a = ray.direction.dot(ray.direction);
    let (h, discriminant) = view.quadratic(ray.direction, a);
    _ = sphere_filter::filtered_from(&view, ray.direction, a);
    [a, h, view.c, discriminant]
}

/// Runs the formulas of the side of a cylinder. Returns `a`, `-h`, `c` and the discriminant: a sphere's `h` has the
/// other sign.
pub fn cylinder(is_long: bool) -> [Bounded; 4] {
    let (ray, record) = (ray(), record());
    is(ray.origin - record.center, TO_CENTER);
    is((ray.origin - record.center).perpendicular_to(record.axis), TO_CENTER_ACROSS);
    is(ray.direction.perpendicular_to(record.axis), DIRECTION_ACROSS);
    let view = record.seen_from(ray.origin);
    let (a, h, discriminant) = record.quadratic(&view, ray.direction);
    _ = SideLanes::new(&PlainSide::new(&record, &view, &ray, is_long));
    [a, -h, view.c, discriminant]
}
