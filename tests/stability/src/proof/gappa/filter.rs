//! The proofs of the flat filter, whose numbers have 24 bits.
//!
//! `C` and `O` are the distances of the object's centre and of the ray's origin from the middle, and `r` is the square
//! of the bounding sphere's radius. `S = C^2 + O^2 + r` is 1. The centre has another sign, as in the code. Underflow is
//! left out.

use cpu::internals::accel::may_hit::filter_ray::{CYLINDER_MARGIN, SPHERE_MARGIN};
use cpu::internals::geometry::ray::LAMBDA_MIN;

use super::super::bounded::{Bounded, Operation};
use super::super::bounds::Arithmetic;
use super::super::filters::flat_numbers;
use super::super::row::U;
use super::relative::Dot;
use super::{Proof, Script, dyadic, within};

/// The precision of the numbers.
const BITS: u32 = 24;
/// The relative error, in units of `u`, of a number that is rounded once to 24 bits after a few roundings to 53 bits.
const ONCE: f64 = 1.001 * Arithmetic::F32.roundoff / U;

/// Returns the proofs.
pub(super) fn proofs() -> [Proof; 2] {
    [passed(), misses_cylinder()]
}

/// Returns the change of a text to numbers with one bit less.
fn less_precise() -> [String; 2] {
    [BITS, BITS - 1].map(|bits| format!("rel<{bits}>"))
}

/// Begins a proof about the numbers `-2 h` and `c` of a bounding sphere, for a direction of this length. The text
/// `definitions` defines what the length depends on.
fn sphere([minus_two_h, c]: [Bounded; 2], direction: &str, definitions: &str) -> Script {
    let mut script = Script::relative(BITS);
    script.definitions = format!("r = 1 - C * C - O * O;\n{definitions}");
    script.hypotheses.extend(["C", "O", "r"].map(|name| within(name, [0.0, 1.0])));
    let (h, c) = (Dot::of(minus_two_h), Dot::of(c));
    let (Some(two_d_o), Some(start)) = (h.start, c.start) else { panic!("the products are added to a number") };
    let Operation::Sum(d_o, _) = two_d_o.operation() else { panic!("it is no double") };
    let Operation::Sum(constant, of_origin) = start.operation() else { panic!("it is no sum") };
    let Operation::Product(origin_squared, _) = of_origin.operation() else { panic!("it is no product") };
    script.given_vector(h.vectors[0], direction, ONCE);
    script.given_vector(h.vectors[1], "2 * C", ONCE);
    script.given_vector(c.vectors[0], "O", ONCE);
    let [less, more] = [1.0 - SPHERE_MARGIN, 1.0 + SPHERE_MARGIN].map(dyadic);
    // The constant's error is relative to its two terms, which are at most `S`.
    let exact = format!("C * C * {less} - r * {more}");
    let [computed, exact] = script.define(constant, ["y", &exact]);
    script.hypotheses.push(format!("|{computed} - {exact}| <= {}", dyadic(ONCE * U)));
    script.bound_sums(&Dot::of(origin_squared), "O * O");
    script.bound_sums(&Dot::of(d_o), &format!("O * {direction}"));
    script.bound_sums(&h, &format!("2 * C * {direction}"));
    script.bound_sums(&c, "2 * C * O");
    script
}

/// Returns the proof of the error of `f(t)`, with `c` lowered by the margin. `T` is `t |d|`, which does not exceed the
/// sum of the three distances if the ray has a point of the bounding sphere at `t` or later.
fn passed() -> Proof {
    let at_first = flat_numbers(f64::NAN).at_first;
    let Operation::Sum(of_direction, c) = at_first.operation() else { panic!("it is no sum") };
    let Operation::Fused(minus_two_h, t, a_t_t) = of_direction.operation() else { panic!("it is no fused sum") };
    let Operation::Product(a, t_t) = a_t_t.operation() else { panic!("it is no product") };
    let least = dyadic(LAMBDA_MIN);
    let length = format!("T = share * (C + O + sqrt(r));\nD = T / {least};\n");
    let mut script = sphere([minus_two_h, c], "D", &length);
    script.hypotheses.push(within("share", [0.0, 1.0]));
    script.given(a, "D * D", ONCE);
    let single = |value: f64| dyadic(f64::from(value as f32));
    script.define(t, [&single(LAMBDA_MIN), &least]);
    script.define(t_t, [&single(LAMBDA_MIN * LAMBDA_MIN), &format!("{least} * {least}")]);
    let [computed, exact] = script.export(at_first);
    let goal = format!("|{computed} - {exact}| <= {}", dyadic(SPHERE_MARGIN));
    Proof {
        row: "the ray has passed a bounding sphere",
        what: "the error of f(t) relative to S",
        text: script.proves(&[], &goal, "$ C in 8, O in 8;\n"),
        wrong: less_precise(),
    }
}

/// Returns the proof of the error of four times the discriminant of an infinite cylinder, relative to `a S`. `a` is 1.
/// The parts of `d` and `O - C` across the axis are at most as long as the vectors, so `|h'| <= |d| (|C| + |O|)`. The
/// axis of the code has the length `q`, the root of 2.
fn misses_cylinder() -> Proof {
    let result = flat_numbers(f64::NAN).cylinder;
    let Operation::Difference(discriminant, margin) = result.operation() else { panic!("the margin is subtracted") };
    let [_, minus_two_h, of_a_c] = fused(discriminant);
    let Operation::Product(two_a, two_c) = of_a_c.operation() else { panic!("it is no product") };
    let [_, along, sphere_h] = fused(minus_two_h);
    let [_, slope, sphere_a] = fused(two_a);
    let Operation::Sum(a, _) = sphere_a.operation() else { panic!("it is no double") };
    let [_, _, with_height] = fused(two_c);
    let [c, _, height_squared] = fused(with_height);
    let [size, ..] = fused(margin);
    let mut script = sphere([sphere_h, c], "1", "q = sqrt(2);\n");
    let (slope, along) = (Dot::of(slope), Dot::of(along));
    let Some(of_center) = along.start else { panic!("the products are added to a number") };
    script.given(a, "1", ONCE);
    script.given_vector(slope.vectors[1], "q", ONCE);
    for (number, most, range) in [(of_center, "q * C", [-1.0, 1.0]), (height_squared, "2 * r", [0.0, 1.0])] {
        let exact = script.multiple(number, most, range);
        script.given(number, &exact, ONCE);
    }
    script.given(size, "C * C + r", ONCE);
    script.bound_sums(&slope, "q");
    script.bound_sums(&along, "q * O");
    script.is_multiple(minus_two_h, "2 * (C + O)", [-1.0, 1.0]);
    let [computed, exact] = script.export(result);
    let goal = format!("|{computed} - {exact}| <= {}", dyadic(4.0 * CYLINDER_MARGIN));
    Proof {
        row: "the line misses an infinite cylinder",
        what: "the error of four times the discriminant relative to a S",
        text: script.proves(&[], &goal, "$ C in 16, O in 16;\n"),
        wrong: less_precise(),
    }
}

/// Returns the operands of a fused operation.
fn fused(number: Bounded) -> [Bounded; 3] {
    let Operation::Fused(a, b, c) = number.operation() else { panic!("it is no fused operation") };
    [a, b, c]
}
