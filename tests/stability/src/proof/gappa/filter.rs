//! The proofs of the flat filter, whose numbers have 24 bits.
//!
//! `C` and `O` are the distances of the object's centre and of the ray's origin from the middle, and `R2` is the square
//! of the bounding sphere's radius. `S = C^2 + O^2 + R2` is 1. The scripts have `-2 C` and `-sqrt(2) C.n`, which the
//! code stores. The code may use fused operations or not. Underflow is left out.
//!
//! These proofs show that the rounding error is at most the constant. They do not show that the code adds or subtracts
//! the margin where it must. Our own prover shows that.

use cpu::internals::accel::may_hit::filter_ray::{CYLINDER_MARGIN, SPHERE_MARGIN};
use cpu::internals::geometry::ray::LAMBDA_MIN;

use super::super::bounded::{Bounded, Operation};
use super::super::bounds::Arithmetic;
use super::super::filters::flat_numbers;
use super::super::row::U;
use super::relative::{Dot, product};
use super::{Proof, SINGLE, Script, dyadic, one_bit_less, within};

/// The relative error of a number that is rounded once to 24 bits after a few roundings to 53 bits: 1.001 units of 24
/// bits, in units of `u`, because `given` takes `u`.
const ONCE: f64 = 1.001 * Arithmetic::F32.roundoff / U;
/// The relative error of the product of two such numbers, in units of `u`, which the first proof shows.
const OF_PRODUCT: f64 = 3.003 * Arithmetic::F32.roundoff / U;
const PASSED: &str = "the ray has passed a bounding sphere";

/// Returns the proofs, that one first that the others build on.
pub(super) fn proofs() -> [Proof; 3] {
    [product(PASSED, SINGLE, [ONCE; 2], OF_PRODUCT), passed(), misses_cylinder()]
}

/// Begins a proof about the numbers `-2 h` and `c` of a bounding sphere, for a direction of this length. The text
/// `definitions` defines what the length depends on.
fn sphere([minus_two_h, c]: [Bounded; 2], direction: &str, definitions: &str) -> Script {
    let mut script = Script::relative(SINGLE);
    script.definitions = format!("R2 = 1 - C * C - O * O;\n{definitions}");
    script.hypotheses.extend(["C", "O", "R2"].map(|name| within(name, [0.0, 1.0])));
    let (h, c) = (Dot::of(minus_two_h), Dot::of(c));
    let (Some(two_d_o), Some(start)) = (h.start, c.start) else { panic!("the products are added to a number") };
    let Operation::Sum(d_o, _) = two_d_o.operation() else { panic!("it is no double") };
    let Operation::Sum(constant, of_origin) = start.operation() else { panic!("it is no sum") };
    let Operation::Product(origin_squared, _) = of_origin.operation() else { panic!("it is no product") };
    let [less, more] = [1.0 - SPHERE_MARGIN, 1.0 + SPHERE_MARGIN].map(dyadic);
    // The constant's error is relative to its two terms, which are at most `S`.
    let exact = format!("C * C * {less} - R2 * {more}");
    let [computed, exact] = script.define(constant, ["y", &exact]);
    script.hypotheses.push(format!("|{computed} - {exact}| <= {}", dyadic(ONCE * U)));
    script.given_dot(&Dot::of(origin_squared), "O * O", OF_PRODUCT);
    script.given_dot(&Dot::of(d_o), &format!("O * {direction}"), OF_PRODUCT);
    script.given_dot(&h, &format!("2 * C * {direction}"), OF_PRODUCT);
    script.given_dot(&c, "2 * C * O", OF_PRODUCT);
    script
}

/// Returns the proof of the error of `f(t)`, with `c` lowered by the margin. `T` is `t |d|`, which hardly exceeds
/// `C + O + R` if the ray has a point of the bounding sphere at `t` or later. A hit counts from a lambda on that rounds
/// to `t`, so `T` may exceed the sum by a relative 2^-53, and the proof allows for more.
fn passed() -> Proof {
    let at_first = flat_numbers(f64::NAN).at_first;
    let Operation::Sum(of_direction, c) = at_first.operation() else { panic!("it is no sum") };
    let Operation::Fused(minus_two_h, t, a_t_t) = of_direction.operation() else { panic!("it is no fused sum") };
    let Operation::Product(a, t_t) = a_t_t.operation() else { panic!("it is no product") };
    let least = dyadic(LAMBDA_MIN);
    let length = format!("T = share * (C + O + sqrt(R2));\nD = T / {least};\n");
    let mut script = sphere([minus_two_h, c], "D", &length);
    script.hypotheses.push(within("share", [0.0, 1.0 + 1e-9]));
    script.given(a, "D * D", ONCE);
    let single = |value: f64| dyadic(f64::from(value as f32));
    script.define(t, [&single(LAMBDA_MIN), &least]);
    script.define(t_t, [&single(LAMBDA_MIN * LAMBDA_MIN), &format!("{least} * {least}")]);
    let [computed, exact] = script.export(at_first);
    let goal = format!("|{computed} - {exact}| <= {}", dyadic(SPHERE_MARGIN));
    Proof {
        row: PASSED,
        what: "the error of f(t) relative to S",
        text: script.proves(&[], &goal, "$ C in 8, O in 8;\n"),
        wrong: one_bit_less(SINGLE),
    }
}

/// Returns the proof of the error of the number that is compared with 0, `-4 D'` less the margin, relative to `a S`.
/// `a` is 1. The parts of `d` and `O - C` across the axis are at most as long as the vectors, so
/// `|h'| <= |d| (|C| + |O|)`. The axis of the code has the length `root2`, the root of 2.
///
/// `2 hh^2`, with half of the height `hh`, is at most `2 R2`, because `accel/flat_filter.rs` builds its targets without
/// slack.
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
    let mut script = sphere([sphere_h, c], "1", "root2 = sqrt(2);\n");
    let (slope, along) = (Dot::of(slope), Dot::of(along));
    let Some(of_center) = along.start else { panic!("the products are added to a number") };
    script.given(a, "1", ONCE);
    // The code computes `C.n` in `f64`, which may cancel, so its error is relative to `C`.
    let exact = script.multiple(of_center, "root2 * C", [-1.0, 1.0]);
    let error = "yc * (root2 * C)";
    let [computed, exact] = script.define(of_center, [&format!("{exact} + {error}"), &exact]);
    script.hints += &format!("{computed} - {exact} -> {error};\n");
    script.hypotheses.push(format!("|yc| <= {}", dyadic(ONCE * U)));
    let exact = script.multiple(height_squared, "2 * R2", [0.0, 1.0]);
    script.given(height_squared, &exact, ONCE);
    script.given(size, "C * C + R2", ONCE);
    script.given_dot(&slope, "root2", OF_PRODUCT);
    script.given_dot(&along, "root2 * O", OF_PRODUCT);
    script.is_multiple(minus_two_h, "2 * (C + O)", [-1.0, 1.0]);
    let [computed, exact] = script.export(result);
    let goal = format!("|{computed} - {exact}| <= {}", dyadic(4.0 * CYLINDER_MARGIN));
    Proof {
        row: "the line misses an infinite cylinder",
        what: "the error of four times the discriminant relative to a S",
        text: script.proves(&[], &goal, "$ C in 16, O in 16;\n"),
        wrong: one_bit_less(SINGLE),
    }
}

/// Returns the operands of a fused operation.
fn fused(number: Bounded) -> [Bounded; 3] {
    let Operation::Fused(a, b, c) = number.operation() else { panic!("it is no fused operation") };
    [a, b, c]
}
