//! The list of the proofs that are exported, and single ones. Several build on another one,
//! whose goal is their hypothesis.

use cpu::internals::exact::cylinder_decision::CYLINDER_BOUND;
use cpu::internals::exact::cylinder_plain::LEAST_SIZE;
use cpu::internals::exact::error_bound::LARGEST_IN_SCALE;
use cpu::internals::exact::order::is_certainly_closer;

use super::super::bounded::{Bounded, Operation, begin, compared};
use super::super::bounds::Arithmetic;
use super::super::exact;
use super::super::row::{U, family::*};
use super::hypotheses::{MODERATE, relative};
use super::{Proof, Script, background, camera, cap, compensated, compensated_underflow, dyadic, filter};
use super::{in_single_precision, largest, sphere, within};

/// Returns the proofs, those that others build on first.
#[must_use]
pub fn scripts() -> Vec<Proof> {
    let mut proofs = cap::proofs().to_vec();
    proofs.extend(sphere::proofs());
    proofs.extend(compensated::proofs());
    proofs.extend(compensated_underflow::proofs());
    proofs.extend(filter::proofs());
    proofs.extend([order(), long_side(), side_lambda(), camera::direction()]);
    proofs.extend(
        [largest::sphere(), largest::side(), largest::cap(), largest::conservative(), background::remainder()].concat(),
    );
    proofs
}

/// Returns the proof of the side's lambda, for the errors of the coefficients that our own prover finds.
fn side_lambda() -> Proof {
    let errors = exact::side_errors();
    let [q, p] = errors.c.map(|error| error / 2.0);
    // `QuadraticErrors::lambda` has the reasons.
    let numbers = [(q + 1.0).max(p + 2.0), errors.h + errors.a / 2.0 * 2.0_f64.sqrt(), 0.0];
    sphere::lambda("lambda of a side", CYLINDER_BOUND.condition_limit, CYLINDER_BOUND.lambda_error(), numbers)
}

/// Returns the proof that one lambda is smaller than another if the code says so, with the errors of both.
fn order() -> Proof {
    begin(Arithmetic::F64, f64::NAN);
    let [one, other] = [DERIVED, DERIVED + 1].map(|family| Bounded::number(family, 0.0));
    _ = is_certainly_closer(one, other);
    let [with_margin, _] = compared()[0];
    let mut script = Script::new();
    let (of_one, of_other) = (script.define(one, ["L", "l"]), script.define(other, ["O", "o"]));
    let of_margin = script.export(with_margin);
    let Operation::Product(_, factor) = with_margin.operation() else { panic!("it is no product") };
    let factor = &script.export(factor)[0];
    let ([[x, e], [y, o], [with_margin, _]], of_lambda) =
        ([&of_one, &of_other, &of_margin], CYLINDER_BOUND.lambda_error() / 3.0 / U);
    let magnitudes = [x, e, y, o].map(|name| within(name, MODERATE));
    let mut hypotheses = vec![relative(&of_one, of_lambda), relative(&of_other, of_lambda)];
    hypotheses.extend(magnitudes);
    hypotheses.push(format!("{with_margin} / {y} <= 1"));
    let hints = format!(
        "{e} / {o} -> ({with_margin} / {y}) * ((1 + ({y} - {o}) / {o}) / ((1 + ({x} - {e}) / {e}) * (1 + ({with_margin} \
         - {x} * {factor}) / ({x} * {factor})) * {factor})) {{ {x} <> 0, {y} <> 0, {e} <> 0, {o} <> 0, {factor} <> 0 }};\n"
    );
    Proof {
        row: "order of two hits",
        what: "the exact lambda is at most the exact other one, if the computed one with its margin is",
        text: script.proves(&hypotheses, &format!("{e} / {o} <= 1"), &hints),
        wrong: in_single_precision(),
    }
}

/// Returns the proof that the other factor of `m^2 / 2` is a normal number, if `m` is at least the least size.
fn long_side() -> Proof {
    let least = dyadic(LEAST_SIZE * LEAST_SIZE / 2.0);
    let [longest, longer] = [LARGEST_IN_SCALE, LARGEST_IN_SCALE * LARGEST_IN_SCALE].map(dyadic);
    let text = format!(
        "{{ a in [1b-1074,{longest}] /\\ a * x >= {least} /\\ x in [0,1b1023] -> x >= {} }}\nx -> a * x / a {{ a <> 0 }};\n",
        dyadic(f64::MIN_POSITIVE)
    );
    let wrong = [longest, longer];
    Proof { row: "underflow of a long side", what: "the smaller factor of the square of m", text, wrong }
}
