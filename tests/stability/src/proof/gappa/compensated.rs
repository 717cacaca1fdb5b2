//! The proofs of the error of `c` of a side by the compensated formula, before the last rounding. It is of the order
//! of `u^2`, because the code adds the errors of its own operations. Underflow is left out.
//!
//! With the vectors `O - C` and `V`, `c` is `|(O - C) x V|^2 - r^2 |V|^2`.

use cpu::Vec3;
use cpu::internals::exact::compensated_roots::ERROR_OF_C;
use cpu::internals::exact::cylinder_compensated::{SHARE_IN_C, SideTerms};
use cpu::internals::math::error_free::{accurate_cross, cross_with_error, vector_difference};

use super::super::bounded::{Bounded, Operation, begin};
use super::super::bounds::Arithmetic;
use super::super::parts::{FILE_AXIS, record};
use super::super::row::{U, ray};
use super::{DOUBLE, Proof, Script, dyadic, one_bit_less, within};

const ROW: &str = "c of a side, compensated";

/// What a proof shows of a component of `(O - C) x V`, relative to the sum of the magnitudes of both products: the size
/// of its second part in units of `u`, and the error of both parts in units of `u^2`.
const OF_COMPONENT: [f64; 2] = [3.2, 8.6];
/// What a proof shows of `r^2 |V|^2`, relative to itself: the size of its second part in units of `u`, and the error of
/// both parts in units of `u^2`.
const OF_RADIUS: [f64; 2] = [5.7, 27.0];
/// The error of `c` relative to `size_of_c`, in units of `u^2`. The rest of the margin covers the rounding of
/// `size_of_c`.
const OF_C: f64 = 63.0;
const _: () = assert!(OF_C < ERROR_OF_C, "the margin covers the error");
const _: () = assert!(SHARE_IN_C == 4.0, "`f4` is `4 x^2`");

/// The numbers of a side.
pub(super) struct Side {
    /// The axis of the scene file, and the radius.
    pub(super) axis: Vec3<Bounded>,
    pub(super) radius: Bounded,
    /// `O - C` and its rounding error.
    pub(super) from_center: [Vec3<Bounded>; 2],
    /// The two parts of `(O - C) x V`.
    pub(super) cross: [Vec3<Bounded>; 2],
    /// `d x V`.
    pub(super) direction_cross: Vec3<Bounded>,
    /// `r^2 |V|^2` and its second part.
    pub(super) radius_term: [Bounded; 2],
    /// The two numbers of which the code adds up `c`.
    pub(super) parts_of_c: [Bounded; 2],
    /// `|(O - C) x V|^2 + r^2 |V|^2`.
    pub(super) squares: Bounded,
    /// What the code returns.
    pub(super) terms: SideTerms<Bounded>,
}

/// Runs the formulas of a side.
pub(super) fn side() -> Side {
    begin(Arithmetic::F64, f64::NAN);
    let (ray, record, axis) = (ray(), record(), Bounded::vector(FILE_AXIS, 0.0));
    let (from_center, rest) = vector_difference(ray.origin, record.center);
    let cross = cross_with_error((from_center, rest), axis);
    let terms = SideTerms::new(&record, axis, &ray);
    let sum = |number: Bounded| {
        let Operation::Sum(a, b) = number.operation() else { panic!("it is no sum") };
        [a, b]
    };
    let [difference, error] = sum(terms.quadratic.c);
    let [_, second] = sum(difference);
    let [_, minus] = sum(second);
    let Operation::Negative(squared) = minus.operation() else { panic!("the square of the radius is subtracted") };
    let [without_cross, _] = sum(error);
    let [_, errors] = sum(without_cross);
    let [_, last] = sum(errors);
    let Operation::Difference(_, rest_of_radius) = last.operation() else { panic!("its error is subtracted") };
    let [squares, _] = sum(terms.quadratic.size_of_c);
    Side {
        axis,
        radius: record.radius,
        from_center: [from_center, rest],
        cross: [cross.0, cross.1],
        direction_cross: accurate_cross(ray.direction, axis),
        radius_term: [squared, rest_of_radius],
        parts_of_c: [difference, error],
        squares,
        terms,
    }
}

/// Returns the proofs, those that the last one builds on first.
pub(super) fn proofs() -> [Proof; 3] {
    [component(), radius_term(), c()]
}

fn proof(what: &'static str, text: String) -> Proof {
    Proof { row: ROW, what, text, wrong: one_bit_less(DOUBLE) }
}

/// Returns the proof of the error of a component of `(O - C) x V`. The magnitudes of its two products add up to at most
/// 1. This holds in a suitable unit, because the component and its error are proportional to each factor.
fn component() -> Proof {
    let Side { axis, from_center: [from_center, _], cross: [cross, rest], .. } = side();
    let mut script = Script::relative(DOUBLE);
    script.define(axis.z, ["w"; 2]);
    script.define(axis.y, ["1 - w"; 2]);
    script.hypotheses.push(within("w", [0.0, 1.0]));
    for number in [from_center.y, from_center.z] {
        let [_, exact] = script.export(number);
        script.hypotheses.push(within(&exact, [-1.0, 1.0]));
    }
    let ([first, exact], [second, _]) = (script.export(cross.x), script.export(rest.x));
    let error = format!("{first} + {second} - {exact}");
    let hints = format!("{error} -> {};\n$ w in 16;\n", script.roundings(rest.x).join(" + "));
    proof("a component of (O - C) x V", script.proves(&[], &goal(&second, &error, OF_COMPONENT), &hints))
}

/// Returns the proof of `r^2 |V|^2`. The radius and `|V|` are 1, and `w0`, `w1` and `w2` are the squares of the
/// components of `V`.
fn radius_term() -> Proof {
    let Side { axis, radius, radius_term: [squared, rest], .. } = side();
    let Operation::Product(of_radius, of_axis) = squared.operation() else { panic!("it is no product") };
    let mut script = Script::relative(DOUBLE);
    script.definitions += "w2 = 1 - w0 - w1;\n";
    for (name, component) in ["w0", "w1", "w2"].into_iter().zip(axis.to_array()) {
        let root = format!("sqrt({name})");
        script.define(component, [&root; 2]);
        script.hypotheses.push(within(name, [0.0, 1.0]));
    }
    let [radius, _] = script.export(radius);
    script.hypotheses.push(within(&radius, [1.0; 2]));
    let ([first, exact], [second, _]) = (script.export(squared), script.export(rest));
    let error = format!("{first} + {second} - {exact}");
    // The code leaves out the product of the errors of `r^2` and of `V.V`.
    let of_radius = script.export(of_radius);
    let [computed_axis, exact_axis] = script.export(of_axis);
    let left_out = format!("({} - {}) * ({exact_axis} - {computed_axis})", of_radius[1], of_radius[0]);
    let hints = format!("{error} -> {} - {left_out};\n$ w0 in 16, w1 in 16;\n", script.roundings(rest).join(" + "));
    proof("the term of the radius", script.proves(&[], &goal(&second, &error, OF_RADIUS), &hints))
}

/// Returns that the second part of a number and the error of both parts are at most these multiples of `u` and `u^2`.
fn goal(second: &str, error: &str, [of_second, of_error]: [f64; 2]) -> String {
    format!("|{second}| <= {} /\\ |{error}| <= {}", dyadic(of_second * U), dyadic(of_error * U * U))
}

/// Returns the proof of the error of `c` before its own rounding. `q2` is `|(O - C) x V|^2`, `r2` is `r^2 |V|^2`, `x`
/// is `|O - C| |V|`, and `f4` is `4 x^2`. The terms `q2 + r2 + f4` are 1. The products of a component of `(O - C) x V`
/// add up to at most `x`, by the inequality of Cauchy and Schwarz. Of a component, `s0`, `s1` or `s2` is the second
/// part relative to `x`, and `m0`, `m1` or `m2` the error of both parts; `s` and `m` are those of `r2`.
fn c() -> Proof {
    let Side { cross: [cross, rests], radius_term: [squared, rest], parts_of_c: [difference, error], .. } = side();
    let mut script = Script::relative(DOUBLE);
    script.definitions += "r2 = 1 - q2 - f4;\nx = 1b-1 * sqrt(f4);\n";
    script.hypotheses.extend(["q2", "r2", "f4"].map(|name| within(name, [0.0, 1.0])));
    // What the code leaves out: the squares of the second parts, and the errors of both parts.
    let mut left_out = String::new();
    let at_most = |script: &mut Script, name: &str, most: f64| script.hypotheses.push(within(name, [-most, most]));
    for (index, (number, rest)) in cross.to_array().into_iter().zip(rests.to_array()).enumerate() {
        let exact = script.multiple(number, "sqrt(q2)", [-1.0, 1.0]);
        let [second, of_both] = [format!("s{index}"), format!("m{index}")];
        at_most(&mut script, &second, OF_COMPONENT[0] * U);
        at_most(&mut script, &of_both, OF_COMPONENT[1] * U * U);
        let [second, _] = script.define(rest, [&format!("x * {second}"), "0"]);
        let [_, exact] = script.define(number, [&format!("{exact} - {second} + x * {of_both}"), &exact]);
        left_out += &format!(" - {second} * {second} + x * {of_both} * (2 * {exact} + x * {of_both})");
    }
    at_most(&mut script, "s", OF_RADIUS[0] * U);
    at_most(&mut script, "m", OF_RADIUS[1] * U * U);
    let [second, _] = script.define(rest, ["r2 * s", "0"]);
    script.define(squared, [&format!("r2 - {second} + r2 * m"), "r2"]);
    let ([difference, exact], [computed, _]) = (script.export(difference), script.export(error));
    let before = format!("{difference} + {computed} - {exact}");
    let hints =
        format!("{before} -> {}{left_out} - r2 * m;\n$ q2 in 16, f4 in 16;\n", script.roundings(error).join(" + "));
    let goal = format!("|{before}| <= {}", dyadic(OF_C * U * U));
    proof("the error of c before it is rounded, relative to its terms", script.proves(&[], &goal, &hints))
}
