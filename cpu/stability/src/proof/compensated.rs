//! The margins of the compensated formulas, which subtract the rounding errors of their own operations.
//!
//! Underflow is left out: it adds at most 2^-1074 to a number, and the code requires numbers far above that.

use cpu::internals::exact::cylinder_compensated::{self, SHARE_OF_DISTANCE, SHARE_OF_SIZE};
use cpu::internals::exact::cylinder_parts::LIMITS;
use cpu::internals::exact::sphere_compensated::{self, Discriminant, ERROR_OF_C, Terms};
use cpu::internals::exact::sphere_filter;
use cpu::internals::geometry::sphere::SphereRecord;
use cpu::internals::math::error_free::{self, cross};
use cpu::internals::math::real::Real as _;
use cpu::{Ray, Vec3};

use super::bounded::{Bounded, Operation, begin, compared, forget_later};
use super::bounds::Arithmetic;
use super::direction::hardens;
use super::parts::{FILE_AXIS, record};
use super::polynomial::{Polynomial, Variable};
use super::quadratic::Quadratic;
use super::row::{Row, U, added, components, factors, family::*, is, length, ray, relative_to_sizes, squared, sum};
use super::signed::{Signed, difference};

const WITHOUT_UNDERFLOW: Arithmetic = Arithmetic { underflow: 0.0, ..Arithmetic::F64 };

const FILE: &str = "exact/cylinder_compensated.rs";
const SPHERE: &str = "exact/sphere_compensated.rs";
const SPHERE_MARGIN: f64 = sphere_filter::LIMITS.error_constant * U;

/// The families of `d x V` and `(O - C) x V`, for the axis `V` of the file, and of a number that cancels.
const DIRECTION_CROSS: u8 = DERIVED + 2;
const TO_CENTER_CROSS: u8 = DERIVED + 3;
const CANCELS: u8 = DERIVED + 4;
/// The families of `sqrt(q + R^2)` and of `h`.
const SIZE: u8 = DERIVED + 5;
const OF_H: u8 = DERIVED + 6;

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
fn sphere() -> (Ray<Bounded>, Terms<Bounded>, [(Variable, Polynomial); 3]) {
    let (ray, center) = (ray(), Bounded::vector(CENTER, 0.0));
    is(center + -ray.origin, TO_CENTER);
    let record = SphereRecord::new(center, Bounded::number(RADIUS, 0.0));
    let inputs = origin(|axis| difference(&component(CENTER, axis), &component(TO_CENTER, axis)));
    (ray, Terms::new(&record, &ray), inputs)
}

/// Returns the operands of a difference of two products.
fn products(number: Bounded) -> [Bounded; 4] {
    let Operation::Difference(first, second) = number.operation() else { panic!("it is no difference") };
    let [Operation::Product(a, b), Operation::Product(c, d)] = [first, second].map(Bounded::operation) else {
        panic!("it is no difference of products")
    };
    [a, b, c, d]
}

/// Returns the constant and the need of a discriminant with this value and size, which is compared with its error.
fn of_discriminant(terms: &Terms<Bounded>, of: Discriminant<Bounded>, size: &Polynomial, need: f64) -> [f64; 2] {
    let from = compared().len();
    _ = terms.hits(of);
    let errors = compared().split_off(from).into_iter().filter(|pair| pair[1] == of.value || pair[1] == -of.value);
    let constants = errors.map(|[error, _]| added(error, size, SPHERE_MARGIN, U)).collect::<Vec<_>>();
    let [accepts, misses] = constants[..] else { panic!("the discriminant is compared twice") };
    [accepts.min(misses), need]
}

/// Returns the rows of a sphere: `c`, and its discriminant in two forms.
pub fn sphere_rows() -> [Row; 3] {
    const MARGIN: f64 = ERROR_OF_C * U * U;
    begin(WITHOUT_UNDERFLOW, MARGIN);
    let (_, terms, inputs) = sphere();
    let near = terms.near();
    let [.., c] = products(near.value);
    let known = [(difference(&dot(TO_CENTER, TO_CENTER), &squared(RADIUS)), length(CANCELS))];
    let [exact, error] = Signed::new(&inputs, &known).of(c);
    assert_eq!(exact, known[0].0, "c has another formula");
    let squares = squared(TO_CENTER).plus(&squared(RADIUS));
    let [relative, of_c] = factors(&error.in_lengths(), 0.0, &[length(CANCELS), squares.clone()], 1.0)[..] else {
        unreachable!("there are two sizes")
    };
    assert!(relative < 1.001, "c is rounded once");
    _ = terms.hits(near);
    let uses: Vec<_> = compared().into_iter().filter(|&pair| hardens(pair) == Some(1)).collect();
    // `c` must be accurate, or its root too small.
    let [_, [too_small, _]] = uses[..] else { panic!("the error of c is compared twice") };
    let constant = added(too_small, &squares, MARGIN, U * U);
    let row = |what, [constant, need]: [f64; 2], unit| Row { what, file: SPHERE, constant, need, unit };
    [
        row("c of a compensated root", [constant, of_c / U], "u^2 (q + R^2)"),
        row("discriminant of a sphere, near", near_discriminant(error.in_lengths()), "u M"),
        row("discriminant of a sphere, far", far_discriminant(), "u M"),
    ]
}

/// Returns the constant and the need of `h^2 - a c`, for this error of `c`.
fn near_discriminant(of_c: Polynomial) -> [f64; 2] {
    begin(WITHOUT_UNDERFLOW, SPHERE_MARGIN);
    // Each lemma is about a number that comes after the ones before it.
    let [.., c] = products(sphere().1.near().value);
    c.assume_error(length(CANCELS), of_c);
    forget_later(c);
    let [h, ..] = products(sphere().1.near().value);
    let error = h.raw().error.in_lengths();
    h.assume_error(length(OF_H), error);
    forget_later(h);
    let (_, terms, _) = sphere();
    let Operation::Sum(first, _) = terms.near().size.operation() else { panic!("the size is a sum") };
    let Operation::Product(magnitude, root) = first.operation() else { panic!("the size has h times a root") };
    assert_eq!(magnitude, h.abs());
    let relative = root.raw().relative;
    root.assume_relative(length(DIRECTION).times(&length(SIZE)), relative);
    _ = root.of_squares();
    c.abs().assume(length(CANCELS));
    h.abs().assume(length(OF_H));
    forget_later(root);
    let (_, terms, _) = sphere();
    let near = terms.near();
    // `|C - O|` and the radius are at most `sqrt(q + R^2)`.
    let to_size = [TO_CENTER, RADIUS].map(|family| (family, Some(SIZE)));
    let a = squared(DIRECTION);
    let size = sum(&[
        length(OF_H).times(&length(DIRECTION)).times(&length(SIZE)),
        a.times(&length(CANCELS)),
        a.times(&squared(SIZE)).scaled(ERROR_OF_C * U),
    ]);
    let error = near.value.bounds().error.enlarged(&to_size);
    // `h^2` is at most the first term.
    let need = relative_to_sizes(&error, 0.0, &[size, squared(OF_H)], 1.0);
    let size = length(OF_H).times(&length(DIRECTION)).times(&length(SIZE)).plus(&a.times(&length(CANCELS)));
    of_discriminant(&terms, near, &size, need)
}

/// Returns the constant and the need of `a r^2 - |(C - O) x d|^2`.
fn far_discriminant() -> [f64; 2] {
    begin(WITHOUT_UNDERFLOW, SPHERE_MARGIN);
    let (ray, center) = (ray(), Bounded::vector(CENTER, 0.0));
    let (to_center, rounded_off) = error_free::difference(center, ray.origin);
    is(to_center, TO_CENTER);
    let inputs = origin(|axis| difference(&component(CENTER, axis), &component(TO_CENTER, axis)));
    assume_cross(to_center, rounded_off, ray.direction, DIRECTION, &inputs);
    let (_, terms, _) = sphere();
    let far = terms.far();
    let [distance, radius] = [TO_CENTER, RADIUS].map(|family| squared(family).times(&squared(DIRECTION)));
    let size = |share| sum(&[squared(TO_CENTER_CROSS), radius.clone(), distance.clone().scaled(share)]);
    let share = sphere_compensated::SHARE_OF_DISTANCE;
    of_discriminant(&terms, far, &size(share), relative_in(far.value, share, &[size(1.0)]))
}

/// Computes `vector x axis`, where `vector` comes with its rounding error, and states what is known of it: the exact
/// product has the family [`TO_CENTER_CROSS`].
fn assume_cross(
    vector: Vec3<Bounded>,
    rounded_off: Vec3<Bounded>,
    axis: Vec3<Bounded>,
    family: u8,
    inputs: &[(Variable, Polynomial)],
) {
    let product = |a: u8, b: u8| component(TO_CENTER, a).times(&component(family, b));
    let known = [(1, 2, 0), (2, 0, 1), (0, 1, 2)]
        .map(|(a, b, of)| (difference(&product(a, b), &product(b, a)), component(TO_CENTER_CROSS, of)));
    let mut signed = Signed::new(inputs, &known);
    let across = cross(vector, axis) + cross(rounded_off, axis);
    for (number, (formula, name)) in across.to_array().into_iter().zip(&known) {
        let [exact, error] = signed.of(number);
        assert_eq!(exact, *formula, "the cross product has another formula");
        number.assume_error(name.clone(), error.in_lengths());
    }
}

/// Returns the error of a number relative to `sizes`, with `|O - C|` in units that make this share of its square 1.
fn relative_in(number: Bounded, share: f64, sizes: &[Polynomial]) -> f64 {
    let families = [DIRECTION_CROSS, TO_CENTER_CROSS].map(|family| (family, Some(family)));
    let error = number.bounds().error.enlarged(&families).scaled_by(TO_CENTER, 1.0 / share.sqrt());
    relative_to_sizes(&error, 0.0, sizes, 1.0)
}

/// Returns the quadratic of the side of a cylinder.
///
/// The errors of `d x V` are those of Kahan's algorithm (the head of the module in `cpu` names the article). Where it
/// computes `(O - C) x V`, the operands have errors too, so it is treated like other formulas.
pub fn side() -> Quadratic {
    begin(WITHOUT_UNDERFLOW, LIMITS.error_constant * U);
    let (ray, record, axis) = (ray(), record(), Bounded::vector(FILE_AXIS, 0.0));
    let (from_center, rounded_off) = error_free::difference(ray.origin, record.center);
    is(from_center, TO_CENTER);
    let inputs = origin(|axis| component(CENTER, axis).plus(&component(TO_CENTER, axis)));
    assume_cross(from_center, rounded_off, axis, FILE_AXIS, &inputs);
    for (axis, number) in (0..).zip(cross(ray.direction, axis).to_array()) {
        number.assume_relative(component(DIRECTION_CROSS, axis), 2.0);
    }
    let side = cylinder_compensated::side(&record, axis, &ray);
    let from = compared().len();
    _ = side.bound.misses(side.discriminant);
    let [error, _] = compared()[from];
    let Operation::Difference(_, product) = side.discriminant.operation() else { unreachable!("D is h^2 - a c") };
    let Operation::Product(_, c) = product.operation() else { unreachable!("D is h^2 - a c") };
    let relative = |number, sizes: &[Polynomial]| relative_in(number, SHARE_OF_DISTANCE, sizes);
    let [far, radius] = [TO_CENTER, RADIUS].map(|family| squared(family).times(&squared(FILE_AXIS)));
    let squares = |far| sum(&[squared(TO_CENTER_CROSS), far, radius.clone()]);
    let lengths = [length(TO_CENTER_CROSS), length(TO_CENTER).times(&length(FILE_AXIS))];
    let a = squared(DIRECTION_CROSS);
    Quadratic {
        limits: LIMITS,
        constant: added(error, &a.times(&squares(far.clone().scaled(SHARE_OF_DISTANCE))), LIMITS.error_constant * U, U),
        file: FILE,
        a: relative(side.a, std::slice::from_ref(&a)),
        h: relative(side.h, &lengths.map(|size| size.times(&length(DIRECTION_CROSS)))),
        c: [relative(c, &[squares(far.clone())]); 2],
        discriminant: relative(side.discriminant, &[a.times(&squares(far))]),
    }
}

/// Returns the row of the distance of a cap's plane.
///
/// Its error is a multiple of the distance, and of `u X`, which is `u X / s` times the share `s` of `X` in the size.
/// The plain plane needs more, so the bound of its lambda holds here too.
pub fn plane() -> Row {
    let [[constant, need], other] = [true, false].map(constant_and_need);
    let (constant, need) = (constant.min(other[0]), need.max(other[1]));
    Row { what: "distance of a cap's plane, compensated", file: FILE, constant, need, unit: "u (abs(p) + s X)" }
}

/// Returns the constant and the need of the distance of the top or bottom cap's plane.
fn constant_and_need(is_top: bool) -> [f64; 2] {
    const MARGIN: f64 = 16.0 * U;
    begin(WITHOUT_UNDERFLOW, MARGIN);
    let (ray, record, axis) = (ray(), record(), Bounded::vector(FILE_AXIS, 0.0));
    let cap = if is_top { record.top } else { record.bottom };
    is(cap - ray.origin, TO_CENTER);
    let run = || cylinder_compensated::plane(&record, axis, &ray, cap, is_top).to_plane;
    let to_plane = run();
    let Operation::Product(numerator, reciprocal) = to_plane.operation() else { unreachable!("it is a quotient") };
    // The cap's exact centre is `C + V / 2` or `C - V / 2`.
    let half = |axis| component(FILE_AXIS, axis).scaled(if is_top { 0.5 } else { -0.5 });
    let inputs = origin(|axis| difference(&component(CENTER, axis).plus(&half(axis)), &component(TO_CENTER, axis)));
    let known = [(dot(TO_CENTER, FILE_AXIS).scaled(2.0), length(CANCELS))];
    let [exact, error] = Signed::new(&inputs, &known).of(numerator);
    assert_eq!(exact, known[0].0, "the distance has another formula");
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
