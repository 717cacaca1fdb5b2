//! The margins of the compensated formulas, which subtract the rounding errors of their own operations.
//!
//! Underflow is left out, and bounded apart (`underflow.rs`).

use cpu::Ray;
use cpu::internals::exact::compensated_roots::{self, ACCURACY_OF_C, CONDITION_LIMIT, Discriminant, ERROR_OF_C};
use cpu::internals::exact::cylinder_compensated::{self, SHARE_IN_C, SHARE_IN_H, SHARE_OF_SIZE};
use cpu::internals::exact::cylinder_decision::LEAST_REACH;
use cpu::internals::exact::error_bound::{LARGEST_IN_SCALE, SMALLEST_IN_SCALE, UNDERFLOW};
use cpu::internals::exact::sphere_compensated::{self, SphereTerms};
use cpu::internals::exact::sphere_filter;
use cpu::internals::geometry::{ray::LAMBDA_MIN, sphere::SphereRecord};
use cpu::internals::math::error_free::{self, accurate_cross, cross_with_error};
use cpu::internals::math::real::Real as _;

use super::bounded::{Bounded, Operation, begin, compared, forget_later};
use super::bounds::Arithmetic;
use super::direction::hardens;
use super::logarithm::{self, Log};
use super::parts::{FILE_AXIS, record};
use super::polynomial::{Polynomial, Variable};
use super::row::{Row, U, added, components, factors, family::*, is, length, ray, relative_to_sizes, squared, sum};
use super::signed::{Signed, difference};
use super::underflow::{Known, Underflow, steps};

const WITHOUT_UNDERFLOW: Arithmetic = Arithmetic { underflow: 0.0, ..Arithmetic::F64 };

pub const FILE: &str = "exact/cylinder_compensated.rs";
const SPHERE: &str = "exact/sphere_compensated.rs";
pub const ROOTS: &str = "exact/compensated_roots.rs";
const SPHERE_MARGIN: f64 = sphere_filter::SPHERE_BOUND.error_constant * U;

/// The families of `d x V` and `(O - C) x V`, for the axis `V` of the file, and of a number that cancels.
const DIRECTION_CROSS: u8 = DERIVED + 2;
const TO_CENTER_CROSS: u8 = DERIVED + 3;
const CANCELS: u8 = DERIVED + 4;
/// The families of `sqrt(q + R^2)` and of `h`.
const SIZE: u8 = DERIVED + 5;
const OF_H: u8 = DERIVED + 6;
/// The family of the terms of `c`.
const TERMS: u8 = DERIVED + 7;

type Roots = compensated_roots::Quadratic<Bounded>;

fn component(family: u8, component: u8) -> Polynomial {
    Polynomial::of([(family, component)])
}

/// Returns the dot product of vectors of two families.
fn dot(a: u8, b: u8) -> Polynomial {
    sum(&[0, 1, 2].map(|axis| component(a, axis).times(&component(b, axis))))
}

/// Returns the components of the ray's origin, each as a polynomial.
fn origin(of: impl Fn(u8) -> Polynomial) -> [(Variable, Polynomial); 3] {
    [0, 1, 2].map(|axis| ((ORIGIN, axis), of(axis)))
}

/// Runs the formulas of a sphere. Returns them with the ray, and the inputs of [`Signed`].
fn sphere() -> (Ray<Bounded>, SphereTerms<Bounded>, [(Variable, Polynomial); 3]) {
    let (ray, center) = (ray(), Bounded::vector(CENTER, 0.0));
    is(center + -ray.origin, TO_CENTER);
    let record = SphereRecord::new(center, Bounded::number(RADIUS, 0.0));
    let inputs = origin(|axis| difference(&component(CENTER, axis), &component(TO_CENTER, axis)));
    (ray, SphereTerms::new(&record, &ray), inputs)
}

/// Returns the operands of a difference of two products.
fn products(number: Bounded) -> [Bounded; 4] {
    let Operation::Difference(first, second) = number.operation() else { panic!("it is no difference") };
    let [Operation::Product(a, b), Operation::Product(c, d)] = [first, second].map(Bounded::operation) else {
        panic!("it is no difference of products")
    };
    [a, b, c, d]
}

/// Returns the constant that is added to a number.
fn covered(number: Bounded) -> f64 {
    number.bounds().size.coefficient(&Polynomial::constant(1.0))
}

/// Returns the bound of the error of `c`, and the least lambda, lowered, as the code must compute them.
fn error_of_c_and_least(quadratic: &Roots) -> [Bounded; 2] {
    let of = Bounded::of;
    let least = of(LAMBDA_MIN) - of(LAMBDA_MIN * sphere_filter::SPHERE_BOUND.lambda_error());
    [quadratic.size_of_c * of(ERROR_OF_C * U * U) + of(UNDERFLOW), least]
}

/// Returns the comparisons by which roots are accurate or too small, as docs/accuracy.md takes them, for this
/// discriminant. Each comes with its purpose.
fn of_roots(quadratic: &Roots, of: Discriminant<Bounded>) -> [(&'static str, [Bounded; 2]); 5] {
    let &Roots { a, h, c, size_of_h, .. } = quadratic;
    let ([error, least], root, limit) =
        (error_of_c_and_least(quadratic), of.value.sqrt(), Bounded::of(CONDITION_LIMIT));
    let w = h.abs() + root;
    [
        ("whether `h` is accurate", [size_of_h, w * limit]),
        ("whether the root is accurate", [of.size, root * w * limit]),
        ("whether `c` is accurate", [error * Bounded::of(1.0 / (ACCURACY_OF_C * U)), c.abs()]),
        ("whether the small root is too small", [c.abs() + error, w * least]),
        ("whether the large root is too small", [w, a * least]),
    ]
}

/// Returns the constant and the need of a discriminant with this value and size, which is compared with its error.
fn of_discriminant(quadratic: &Roots, of: Discriminant<Bounded>, size: &Polynomial, need: f64) -> [f64; 2] {
    let from = compared().len();
    _ = quadratic.roots(of);
    let pairs = compared().split_off(from);
    for (what, pair) in of_roots(quadratic, of) {
        assert!(pairs.contains(&pair), "the code does not decide {what} as the proof takes it");
    }
    let errors = pairs.into_iter().filter(|pair| pair[1] == of.value || pair[1] == -of.value);
    let constants = errors.map(|[error, _]| {
        assert_eq!(covered(error), UNDERFLOW, "the error of a discriminant covers underflow");
        added(error, size, SPHERE_MARGIN, U)
    });
    let constants = constants.collect::<Vec<_>>();
    let [accepts, misses] = constants[..] else { panic!("the discriminant is compared twice") };
    [accepts.min(misses), need]
}

/// Returns the constant and the need of `c`, with these terms and this bound of its error. The bound consists of one
/// rounding, and of the rest, in which `|O - C|^2` has this share of the terms.
fn of_c(quadratic: &Roots, error: &Polynomial, terms: &Polynomial, share: f64) -> [f64; 2] {
    const MARGIN: f64 = ERROR_OF_C * U * U;
    // No component is longer than its vector.
    let lengths = [TO_CENTER, TO_CENTER_CROSS, FILE_AXIS].map(|family| (family, Some(family)));
    let unit = |polynomial: &Polynomial| polynomial.enlarged(&lengths).scaled_by(TO_CENTER, 1.0 / share.sqrt());
    let [relative, need] = factors(&unit(error), 0.0, &[length(CANCELS), unit(terms)], 1.0)[..] else {
        unreachable!("there are two sizes")
    };
    assert!(relative < 1.001, "c is rounded once");
    let from = compared().len();
    _ = quadratic.roots(quadratic.near());
    let uses: Vec<_> = compared().split_off(from).into_iter().filter(|&pair| hardens(pair) == Some(1)).collect();
    // `c` must be accurate, or its root too small.
    let [_, [too_small, _]] = uses[..] else { panic!("the error of c is compared twice") };
    assert_eq!(covered(too_small), UNDERFLOW, "the error of c covers underflow");
    [added(too_small, terms, MARGIN, U * U), need / U]
}

/// Returns the constant and the need of `h^2 - a c`. The error of `c` is one rounding and `of_c u^2` times its terms.
/// `run` computes the quadratic anew, `direction` is the family of the root of `a`, and `to_size` replaces the vectors
/// of the terms of `h`, which are the root of `a size_of_h`, by the root of `size_of_h`.
fn near_discriminant(
    run: impl Fn() -> Roots,
    of_c: f64,
    size_of_h: &Polynomial,
    direction: u8,
    to_size: impl Fn(&Polynomial) -> Polynomial,
) -> ([f64; 2], f64, Roots) {
    // Each lemma is about a number that comes after the ones before it.
    let [.., c] = products(run().near().value);
    let error = length(CANCELS).scaled(1.001).plus(&length(TERMS).scaled(of_c * U));
    c.assume_error(length(CANCELS), error);
    forget_later(c);
    let h = run().h;
    let error = h.raw().error.in_lengths();
    let of_h = relative_to_sizes(&to_size(&error), 0.0, &[length(direction).times(&length(SIZE))], 1.0);
    h.assume_error(length(OF_H), error);
    forget_later(h);
    let root = run().size_of_h;
    let Operation::Root(product) = root.operation() else { panic!("it is no root") };
    let Operation::Product(_, squares) = product.operation() else { panic!("it is no product") };
    assert!(squares.raw().is_positive && squares.bounds().size.covers(size_of_h), "the terms of h lack a part");
    let relative = root.raw().relative;
    root.assume_relative(length(direction).times(&length(SIZE)), relative);
    _ = root.of_squares();
    let terms = run().size_of_c;
    let relative = terms.raw().relative;
    terms.assume_relative(length(TERMS), relative);
    c.abs().assume(length(CANCELS));
    h.abs().assume(length(OF_H));
    forget_later(root.later(terms));
    let quadratic = run();
    let near = quadratic.near();
    let a = squared(direction);
    let first = length(OF_H).times(&length(direction)).times(&length(SIZE)).plus(&a.times(&length(CANCELS)));
    let [lost, of_second_order] = [length(TERMS), squared(SIZE)].map(|terms| a.times(&terms).scaled(ERROR_OF_C * U));
    // `h^2` is at most the first term, and the terms of `h^2 / a` are at most those of `c`.
    let sizes = [first.clone().plus(&lost), squared(OF_H), of_second_order];
    let need = relative_to_sizes(&to_size(&near.value.bounds().error), 0.0, &sizes, 1.0);
    (of_discriminant(&quadratic, near, &first, need), of_h, quadratic)
}

/// A part of the domain: the largest magnitudes, the smallest terms of `c` and of a discriminant, and radicands.
struct Cell {
    corner: Vec<(u8, Log)>,
    least: [Log; 2],
    radicands: Vec<(Bounded, Log)>,
}

/// Returns the largest error that underflow adds to `c` or to a discriminant and that is not negligible beside the
/// error that the code takes. An error of `h` below `negligible` is.
fn of_underflow(
    c: Bounded,
    (h, negligible): (Bounded, Log),
    of: Discriminant<Bounded>,
    cells: impl Iterator<Item = Cell>,
) -> Log {
    let known = Known::default();
    let of_cell = |Cell { corner, least, radicands }: Cell| {
        let mut underflow = Underflow::new(&known, &corner, &radicands);
        let [of_c, of_h, value, size] = [c, h, of.value, of.size].map(|number| underflow.of(number) + 1.0);
        assert!(of_h < negligible, "underflow adds 2^{of_h} to h");
        let of_discriminant = logarithm::sum(value, size + SPHERE_MARGIN.log2());
        let parts = [(of_c, ERROR_OF_C * U * U), (of_discriminant, SPHERE_MARGIN)].into_iter().zip(least);
        let rest = parts.filter(|((part, margin), least)| *part >= (1e-6 * margin).log2() + least);
        rest.map(|((part, _), _)| part).fold(f64::NEG_INFINITY, f64::max)
    };
    cells.map(of_cell).fold(f64::NEG_INFINITY, f64::max)
}

/// Returns the largest negligible error of the `h` of a side: its `w` is at least the root of a discriminant that
/// exceeds its error.
fn side_h() -> Log {
    (1e-6 * U * UNDERFLOW.sqrt()).log2()
}

/// Returns that of a sphere: if a ray leaves, its `h` times the least lambda exceeds the constant.
fn sphere_h() -> Log {
    (1e-6 * sphere_filter::SPHERE_BOUND.lambda_error() / LAMBDA_MIN * UNDERFLOW).log2()
}

/// Returns the row of the constant that covers underflow, in bits above the smallest number. A quarter of it must do,
/// so that the error of a discriminant is no larger part of the bound.
fn row_of_underflow(what: &'static str, parts: &[Log]) -> Row {
    let logs = [UNDERFLOW.log2() - 2.0, parts.iter().copied().fold(f64::NEG_INFINITY, f64::max)];
    Row::new(what, ROOTS, logs.map(|log| log - f64::from_bits(1).log2()), "log2")
}

/// Returns the number of which the code takes the root.
fn radicand(root: Bounded) -> Bounded {
    let Operation::Root(radicand) = root.operation() else { panic!("it is no root") };
    radicand
}

/// The step between cells, in bits.
const STEP: Log = 25.0;

/// Returns the parts of the domain of a sphere. The terms of a discriminant have at least this share of `M`.
fn sphere_cells(size_of_h: Bounded, share: f64) -> impl Iterator<Item = Cell> {
    let [shortest, longest] = [SMALLEST_IN_SCALE, LARGEST_IN_SCALE].map(|squared| squared.log2() / 2.0);
    // A farther sphere has infinite terms. Numbers below the first step count as 0.
    let sizes = [[f64::NEG_INFINITY, -1075.0]].into_iter().chain(steps(-1075.0, 512.0, STEP));
    let directions = steps(shortest - 1.0, longest, STEP);
    sizes.flat_map(move |size| directions.clone().map(move |direction| (direction, size))).map(
        move |(direction, size)| {
            let [least, most] = [0, 1].map(|end| direction[end] + size[end]);
            let ([direction, least_size], size) = ([direction[1], size[0]], size[1]);
            let corner = vec![
                (DIRECTION, direction),
                (TO_CENTER, size),
                (RADIUS, size),
                (SIZE, size),
                (CANCELS, 2.0 * size),
                (TERMS, 2.0 * size),
                (OF_H, most),
                (TO_CENTER_CROSS, most),
            ];
            let radicands = vec![(radicand(size_of_h), 2.0 * least - 1.0)];
            Cell { corner, least: [2.0 * least_size, 2.0 * least + share.log2()], radicands }
        },
    )
}

/// Returns the rows of a sphere: `c`, and its discriminant in two forms; then the row of underflow and the need of `h`.
pub fn sphere_rows() -> ([Row; 3], Row, f64) {
    begin(WITHOUT_UNDERFLOW, ERROR_OF_C * U * U);
    let (_, terms, inputs) = sphere();
    let c = terms.quadratic.c;
    let known = [(difference(&dot(TO_CENTER, TO_CENTER), &squared(RADIUS)), length(CANCELS))];
    let [exact, error] = Signed::new(&inputs, &known).of(c);
    assert_eq!(exact, known[0].0, "c has another formula");
    let squares = squared(TO_CENTER).plus(&squared(RADIUS));
    let of_c = of_c(&terms.quadratic, &error.in_lengths(), &squares, 1.0);
    begin(WITHOUT_UNDERFLOW, SPHERE_MARGIN);
    // `|C - O|` and the radius are at most `sqrt(q + R^2)`.
    let to_size = |polynomial: &Polynomial| polynomial.enlarged(&[TO_CENTER, RADIUS].map(|of| (of, Some(SIZE))));
    let (near, of_h, quadratic) = near_discriminant(|| sphere().1.quadratic, of_c[1], &squares, DIRECTION, to_size);
    let Roots { c, h, size_of_h, .. } = quadratic;
    let share = quadratic.near().size.bounds().size.coefficient(&squared(DIRECTION).times(&length(TERMS)));
    let near_underflow = of_underflow(c, (h, sphere_h()), quadratic.near(), sphere_cells(size_of_h, share));
    let (far, far_underflow) = far_discriminant();
    let rows = [
        Row::new("c of a sphere, compensated", ROOTS, of_c, "u^2 (q + R^2)"),
        Row::new("discriminant of a sphere, near", ROOTS, near, "u M"),
        Row::new("discriminant of a sphere, far", SPHERE, far, "u M"),
    ];
    (rows, row_of_underflow("underflow of a sphere, compensated", &[near_underflow, far_underflow]), of_h)
}

/// Returns the row of the bound of lambda for rays that leave a sphere: `|c| / |h|` is compared with the least lambda.
/// `of_h` is the need of `h`, and 6 is enough for the roundings of `c`, of the sum with its error, of the product and
/// of the least lambda, and for the limit, 1e-3 - 2^-63.
///
/// If `S = q + R^2` or `a S` underflows, the sign of `h` may be wrong. Then every lambda is at most `sqrt(2 S / a)`,
/// below 2^-200, and the ray misses.
pub fn leaves(of_h: f64) -> Row {
    for margin in [ERROR_OF_C * U * U, LAMBDA_MIN * sphere_filter::SPHERE_BOUND.lambda_error()] {
        begin(WITHOUT_UNDERFLOW, margin);
        let (_, terms, _) = sphere();
        let from = compared().len();
        _ = terms.quadratic.moves_away();
        let pairs = compared().split_off(from);
        let sides: Vec<_> = pairs.iter().copied().map(hardens).collect();
        assert_eq!(sides, [Some(0), Some(0), Some(1)], "a margin is not used, or on the wrong side");
        let ([error, least], Roots { h, c, size_of_h, .. }) = (error_of_c_and_least(&terms.quadratic), terms.quadratic);
        let [zero, limit] = [0.0, CONDITION_LIMIT].map(Bounded::of);
        let expected = [[h, zero], [size_of_h, h.abs() * limit], [c.abs() + error, h.abs() * least]];
        assert_eq!(pairs, expected, "the code decides in another way than the proof takes");
    }
    let margins = [sphere_filter::SPHERE_BOUND.lambda_error() / U, of_h * CONDITION_LIMIT + 6.0];
    Row::new("lambda of a ray that leaves a sphere", ROOTS, margins, "u lambda")
}

/// Returns the constant and the need of `a r^2 - |(C - O) x d|^2`, and what underflow adds.
fn far_discriminant() -> ([f64; 2], Log) {
    begin(WITHOUT_UNDERFLOW, SPHERE_MARGIN);
    let (ray, center) = (ray(), Bounded::vector(CENTER, 0.0));
    let (to_center, rounded_off) = error_free::vector_difference(center, ray.origin);
    is(to_center, TO_CENTER);
    let inputs = origin(|axis| difference(&component(CENTER, axis), &component(TO_CENTER, axis)));
    let known = known_cross(DIRECTION);
    let mut signed = Signed::new(&inputs, &known);
    let across = accurate_cross(to_center, ray.direction) + accurate_cross(rounded_off, ray.direction);
    for (number, known) in across.to_array().into_iter().zip(&known) {
        assume_known(&mut signed, number, known);
    }
    let (_, terms, _) = sphere();
    let far = terms.far();
    let [distance, radius] = [TO_CENTER, RADIUS].map(|family| squared(family).times(&squared(DIRECTION)));
    let size = |share| sum(&[squared(TO_CENTER_CROSS), radius.clone(), distance.clone().scaled(share)]);
    let share = sphere_compensated::SHARE_OF_DISTANCE;
    let row = of_discriminant(&terms.quadratic, far, &size(share), relative_in(far.value, share, &[size(1.0)]));
    let Roots { c, h, size_of_h, .. } = terms.quadratic;
    (row, of_underflow(c, (h, sphere_h()), far, sphere_cells(size_of_h, share)))
}

/// Returns the components of the cross product of [`TO_CENTER`] and another vector, with their names.
fn known_cross(family: u8) -> [(Polynomial, Polynomial); 3] {
    let product = |a: u8, b: u8| component(TO_CENTER, a).times(&component(family, b));
    [(1, 2, 0), (2, 0, 1), (0, 1, 2)]
        .map(|(a, b, of)| (difference(&product(a, b), &product(b, a)), component(TO_CENTER_CROSS, of)))
}

/// States what is known of a number: its formula, whose magnitude has a name, and its error.
fn assume_known(signed: &mut Signed, number: Bounded, (formula, name): &(Polynomial, Polynomial)) {
    let [exact, error] = signed.of(number);
    assert_eq!(exact, *formula, "the cross product has another formula");
    number.assume_error(name.clone(), error.in_lengths());
}

/// Returns the error of a number relative to `sizes`, with `|O - C|` in units that make this share of its square 1.
fn relative_in(number: Bounded, share: f64, sizes: &[Polynomial]) -> f64 {
    let families = [DIRECTION_CROSS, TO_CENTER_CROSS].map(|family| (family, Some(family)));
    let error = number.bounds().error.enlarged(&families).scaled_by(TO_CENTER, 1.0 / share.sqrt());
    relative_to_sizes(&error, 0.0, sizes, 1.0)
}

/// Runs the formulas of the side of a cylinder, after the lemmas about `d x V` and `(O - C) x V`. Returns them with
/// bounds of the errors of `c` and of `(O - C).p`.
///
/// The errors of `d x V` are those of Kahan's algorithm (the head of the module in `cpu` names the article). Where it
/// computes `(O - C) x V`, the operands have errors too, so it is treated like other formulas.
fn side() -> (impl Fn() -> cylinder_compensated::SideTerms<Bounded>, [Polynomial; 2]) {
    let (ray, record, axis) = (ray(), record(), Bounded::vector(FILE_AXIS, 0.0));
    let (from_center, rounded_off) = error_free::vector_difference(ray.origin, record.center);
    is(from_center, TO_CENTER);
    let inputs = origin(|axis| component(CENTER, axis).plus(&component(TO_CENTER, axis)));
    let mut known = known_cross(FILE_AXIS).to_vec();
    let inner = [0, 1, 2].map(|of| Polynomial::of([(TO_CENTER_CROSS, of); 2]));
    let rim = dot(FILE_AXIS, FILE_AXIS).times(&squared(RADIUS));
    known.push((difference(&sum(&inner), &rim), length(CANCELS)));
    let mut signed = Signed::new(&inputs, &known);
    let (q, rest) = cross_with_error((from_center, rounded_off), axis);
    let wholes = (q + rest).to_array();
    for (((number, rest), whole), known) in q.to_array().into_iter().zip(rest.to_array()).zip(wholes).zip(&known) {
        assume_known(&mut signed, number, known);
        // The second part is known before the first one has another name.
        _ = signed.of(rest);
        signed.rename(number, &known.1);
        assume_known(&mut signed, whole, &(known.1.clone(), known.1.clone()));
    }
    for (axis, number) in (0..).zip(accurate_cross(ray.direction, axis).to_array()) {
        number.assume_relative(component(DIRECTION_CROSS, axis), 2.0);
        signed.take(number, &component(DIRECTION_CROSS, axis), 2.0);
    }
    let run = move || cylinder_compensated::SideTerms::new(&record, axis, &ray);
    let [exact, error] = signed.of(run().quadratic.c);
    assert_eq!(exact, known[3].0, "c has another formula");
    let [exact, of_aside] = signed.of(aside(&run()));
    assert_eq!(exact, dot(TO_CENTER, DIRECTION_CROSS), "the discriminant has another formula");
    (run, [error.in_lengths(), of_aside.in_lengths()])
}

/// Returns the number `(O - C).p`.
fn aside(terms: &cylinder_compensated::SideTerms<Bounded>) -> Bounded {
    let Operation::Product(_, rest) = terms.far.value.operation() else { panic!("it is no product") };
    let Operation::Difference(_, square) = rest.operation() else { panic!("it is no difference") };
    let Operation::Product(aside, same) = square.operation() else { panic!("it is no product") };
    assert_eq!(aside, same);
    aside
}

/// Returns the rows of the side of a cylinder: `c`, and its discriminant in two forms; then the rows of underflow
/// and of the largest number, and the needs of `a` and of `h`.
pub fn side_rows() -> ([Row; 3], [Row; 2], [f64; 2]) {
    begin(WITHOUT_UNDERFLOW, ERROR_OF_C * U * U);
    let (run, [error, _]) = side();
    let [far, rim] = [TO_CENTER, RADIUS].map(|family| squared(family).times(&squared(FILE_AXIS)));
    let terms = |share| sum(&[squared(TO_CENTER_CROSS), rim.clone(), far.clone().scaled(share)]);
    let (terms, size_of_h) = (terms(SHARE_IN_C), terms(SHARE_IN_H));
    let of_c = of_c(&run().quadratic, &error, &terms, SHARE_IN_C);
    begin(WITHOUT_UNDERFLOW, SPHERE_MARGIN);
    let (run, _) = side();
    let a = relative_in(run().quadratic.a, 1.0, &[squared(DIRECTION_CROSS)]);
    let to_size = |polynomial: &Polynomial| {
        let same = (DIRECTION_CROSS, Some(DIRECTION_CROSS));
        let sizes = [TO_CENTER_CROSS, RADIUS, TO_CENTER].map(|family| (family, Some(SIZE)));
        let families = [sizes[0], sizes[1], sizes[2], (FILE_AXIS, None), same];
        polynomial.clone().scaled_by(TO_CENTER, 1.0 / SHARE_IN_H.sqrt()).enlarged(&families)
    };
    let (near, of_h, quadratic) = near_discriminant(|| run().quadratic, of_c[1], &size_of_h, DIRECTION_CROSS, to_size);
    let Roots { c, h, size_of_h, .. } = quadratic;
    let share = quadratic.near().size.bounds().size.coefficient(&squared(DIRECTION_CROSS).times(&length(TERMS)));
    let near_underflow = of_underflow(c, (h, side_h()), quadratic.near(), side_cells(size_of_h, share));
    let near_largest = largest_of_side(quadratic.near(), share);
    let (far, [far_underflow, far_largest]) = far_discriminant_of_side();
    let largest = [f64::from(f64::MAX_EXP), near_largest.max(far_largest)];
    let rows = [
        Row::new("c of a side, compensated", ROOTS, of_c, "u^2 (Q + 4 F)"),
        Row::new("discriminant of a side, near", ROOTS, near, "u M"),
        Row::new("discriminant of a side, far", FILE, far, "u M"),
    ];
    let range = [
        row_of_underflow("underflow of a side, compensated", &[near_underflow, far_underflow]),
        Row::new("largest number of a side, compensated", FILE, largest, "log2"),
    ];
    (rows, range, [a, of_h])
}

/// The family of `(O - C).p`.
const ASIDE: u8 = DERIVED + 8;

/// Returns the parts of the domain of a side. With `Y^2 = |O - C|^2 + r^2`, the terms of a discriminant are at least
/// `|p|^2 |V|^2 Y^2` times `share`. `|V| Y` is at least the root of `Q`, which is in scale, and `|q|` is at most that.
/// `(O - C).p` is at most `|q| |p| / |V|`, because `p` is across the axis.
fn side_cells(size_of_h: Bounded, share: f64) -> impl Iterator<Item = Cell> {
    let [shortest, longest] = [SMALLEST_IN_SCALE, LARGEST_IN_SCALE].map(|squared| squared.log2() / 2.0);
    let cells = steps(shortest - 1.0, longest, STEP).flat_map(move |direction| {
        let sizes = steps(shortest - 1.0, longest + 512.0, STEP);
        sizes.flat_map(move |size| steps(shortest - 1.0, longest, 10.0).map(move |axis| (direction, axis, size)))
    });
    cells.map(move |(direction, axis, size)| {
        let (least, least_size) = (direction[0] + size[0], size[0]);
        let corner = side_corner(direction[1], axis, size[1] + 1.0);
        let radicands = vec![(radicand(size_of_h), 2.0 * (direction[0] + shortest) - 1.0)];
        Cell { corner, least: [2.0 * least_size, 2.0 * least + share.log2()], radicands }
    })
}

/// Returns the largest magnitudes for these of `p` and of `|V| Y`, and for this range of the axis.
fn side_corner(direction: Log, [shortest_axis, axis]: [Log; 2], size: Log) -> Vec<(u8, Log)> {
    let across = size.min(LARGEST_IN_SCALE.log2() / 2.0);
    vec![
        (DIRECTION_CROSS, direction),
        (FILE_AXIS, axis),
        (TO_CENTER, size - shortest_axis),
        (RADIUS, across - shortest_axis),
        (TO_CENTER_CROSS, across),
        (SIZE, size),
        (CANCELS, 2.0 * across),
        (TERMS, 2.0 * size + 2.0),
        (OF_H, direction + across),
        (ASIDE, direction + across - shortest_axis),
    ]
}

/// Returns the largest magnitude of a discriminant whose terms are finite.
fn largest_of_side(of: Discriminant<Bounded>, share: f64) -> Log {
    let [shortest, longest] = [SMALLEST_IN_SCALE, LARGEST_IN_SCALE].map(|squared| squared.log2() / 2.0);
    let known = Known::default();
    let cells = steps(shortest - 1.0, longest, 1.0)
        .flat_map(|direction| steps(shortest - 1.0, longest, 1.0).map(move |axis| (direction, axis)));
    let largest = cells.map(|(direction, axis)| {
        let size = (f64::from(f64::MAX_EXP) - share.log2()) / 2.0 - direction[0];
        Underflow::new(&known, &side_corner(direction[1], axis, size), &[]).size(of.value)
    });
    largest.fold(f64::NEG_INFINITY, f64::max)
}

/// Returns the constant and the need of `V.V (a r^2 - ((O - C).p)^2)`, what underflow adds, and the largest
/// magnitude.
fn far_discriminant_of_side() -> ([f64; 2], [Log; 2]) {
    begin(WITHOUT_UNDERFLOW, SPHERE_MARGIN);
    let (run, [_, error]) = side();
    let aside = aside(&run());
    aside.assume_error(length(ASIDE), error);
    forget_later(aside);
    aside.abs().assume(length(ASIDE));
    let reach = [length(TO_CENTER), length(DIRECTION_CROSS)];
    let Operation::Product(_, rest) = run().far.size.operation() else { panic!("it is a product") };
    let Operation::Sum(_, rest) = rest.operation() else { panic!("it is a sum") };
    let Operation::Sum(first, _) = rest.operation() else { panic!("it is a sum") };
    let Operation::Product(_, root) = first.operation() else { panic!("it is a product") };
    let relative = root.raw().relative;
    root.assume_relative(reach[0].times(&reach[1]), relative);
    _ = root.of_squares();
    forget_later(root);
    let terms = run();
    let share = cylinder_compensated::SHARE_IN_D;
    let size = |share: f64, aside: Polynomial| {
        let of_radius = squared(DIRECTION_CROSS).times(&squared(RADIUS));
        let far = squared(DIRECTION_CROSS).times(&squared(TO_CENTER)).scaled(share);
        sum(&[of_radius, aside, far]).times(&squared(FILE_AXIS))
    };
    let aside = length(ASIDE).times(&reach[0]).times(&reach[1]);
    let error = terms.far.value.bounds().error;
    // `((O - C).p)^2` is at most the second term.
    let sizes = [size(share, aside.clone()), squared(ASIDE).times(&squared(FILE_AXIS))];
    let need = relative_to_sizes(&error, 0.0, &sizes, 1.0);
    let row = of_discriminant(&terms.quadratic, terms.far, &size(share, aside), need);
    let Roots { c, h, size_of_h, .. } = terms.quadratic;
    let of_underflow = of_underflow(c, (h, side_h()), terms.far, side_cells(size_of_h, share));
    (row, [of_underflow, largest_of_side(terms.far, share)])
}

/// Returns the row of the distance of a cap's plane.
///
/// Its error is a multiple of the distance, and of `u X`, which is `u X / s` times the share `s` of `X` in the size.
/// The plain plane needs more, so the bound of its lambda holds here too.
pub fn plane() -> Row {
    let [[constant, need], other] = [true, false].map(constant_and_need);
    let (constant, need) = (constant.min(other[0]), need.max(other[1]));
    Row::new("distance of a cap's plane, compensated", FILE, [constant, need], "u (abs(p) + s X)")
}

/// Returns the constant and the need of the distance of the top or bottom cap's plane.
fn constant_and_need(is_top: bool) -> [f64; 2] {
    const MARGIN: f64 = 16.0 * U;
    begin(WITHOUT_UNDERFLOW, MARGIN);
    let (ray, record, axis) = (ray(), record(), Bounded::vector(FILE_AXIS, 0.0));
    let cap = if is_top { record.top } else { record.bottom };
    is(cap - ray.origin, TO_CENTER);
    let to_cap = if is_top { axis } else { -axis };
    let run = || cylinder_compensated::plane(&record, axis, &ray, cap, to_cap).to_plane;
    let to_plane = run();
    let Operation::Product(numerator, reciprocal) = to_plane.operation() else { unreachable!("it is a quotient") };
    // The cap's exact centre is `C + V / 2` or `C - V / 2`.
    let half = |axis| component(FILE_AXIS, axis).scaled(if is_top { 0.5 } else { -0.5 });
    let inputs = origin(|axis| difference(&component(CENTER, axis).plus(&half(axis)), &component(TO_CENTER, axis)));
    let known = [(dot(TO_CENTER, FILE_AXIS).scaled(2.0), length(CANCELS))];
    let [exact, error] = Signed::new(&inputs, &known).of(numerator);
    assert_eq!(exact, known[0].0, "the distance has another formula");
    // The divisor is `2 |V|`. The size contains the least extent.
    let of_underflow = Underflow::new(&Known::default(), &[], &[]).of(numerator) - SMALLEST_IN_SCALE.log2() / 2.0;
    assert!(of_underflow < (1e-6 * MARGIN * SHARE_OF_SIZE * LEAST_REACH).log2(), "underflow adds 2^{of_underflow}");
    let sizes = [length(CANCELS), length(TO_CENTER).times(&length(FILE_AXIS)), squared(FILE_AXIS)];
    let [relative, to_cap, height] = factors(&error.in_lengths(), 0.0, &sizes, 1.0)[..] else {
        unreachable!("there are three sizes")
    };
    // The divisor is `2 |V|`, and half of the height is `|V| / 2`.
    let need = (relative + reciprocal.raw().relative + 1.0).max((to_cap / 2.0).max(height) / SHARE_OF_SIZE);
    to_plane.assume_relative(length(CANCELS), 0.0);
    forget_later(to_plane);
    assert_eq!(run(), to_plane);
    let [distance, _] = compared()[2];
    let extent = sum(&[components(CENTER), components(TO_CENTER), length(HALF_HEIGHT)]);
    [added(distance, &length(CANCELS).plus(&extent.scaled(SHARE_OF_SIZE)), MARGIN, U), need]
}
