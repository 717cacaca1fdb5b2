//! The proofs of the caps of a cylinder: the slope of a ray along the axis, and lambda.

use cpu::internals::exact::cylinder_decision::{CYLINDER_BOUND, CapPlane};
use cpu::internals::math::real::Real;

use super::super::bounded::{Bounded, Operation, begin, compared};
use super::super::bounds::Arithmetic;
use super::super::parts::{axis_and_half_height, record};
use super::super::row::{U, family::*, ray};
use super::hypotheses::{MODERATE, relative};
use super::relative::{Dot, product};
use super::{DOUBLE, Proof, Script, dyadic, in_single_precision, one_bit_less, within};

/// The relative error of a component of a unit axis, in units of `u`, which the first proof shows.
const OF_AXIS: f64 = 3.53;
/// The error of the slope of a ray along an axis relative to `|d|_1`, and that of the distance of a cap's plane. The
/// latter is no proof of Gappa's but the need of its row, less the one rounding of the comparison, as in `parts.rs`.
const OF_SLOPE: f64 = 6.85;
const OF_PLANE: f64 = 7.5;

/// The relative error of a term of the slope, which the second proof shows.
const OF_TERM: f64 = OF_AXIS + 1.001;
const SLOPE: &str = "slope of a ray along an axis";

/// Returns the proofs, those that others build on first.
pub(super) fn proofs() -> [Proof; 5] {
    [axis(), product(SLOPE, DOUBLE, [0.0, OF_AXIS], OF_TERM), slope(), parallel(), cap()]
}

fn axis() -> Proof {
    begin(Arithmetic::F64, f64::NAN);
    let (axis, _) = axis_and_half_height();
    let mut script = Script::new();
    let [computed, exact] = script.export(axis.x);
    let hypotheses = [0, 1, 2].map(|component| within(&format!("|x17_{component}|"), MODERATE));
    let goal = relative(&[computed, exact], OF_AXIS);
    Proof {
        row: SLOPE,
        what: "the relative error of a component of the unit axis",
        text: script.proves(&hypotheses, &goal, ""),
        wrong: in_single_precision(),
    }
}

/// Returns the proof of the error of a slope relative to `|d|_1`, which is 1 here. It is at least the sum of the
/// products' magnitudes, as no component of the axis exceeds 1.
fn slope() -> Proof {
    begin(Arithmetic::F64, f64::NAN);
    let slope = ray().direction.dot(record().axis);
    let mut script = Script::relative(DOUBLE);
    script.given_dot(&Dot::of_products(slope), "1", OF_TERM);
    let [computed, exact] = script.export(slope);
    let goal = format!("|{computed} - {exact}| <= {}", dyadic(OF_SLOPE * U));
    Proof {
        row: SLOPE,
        what: "the error of the slope relative to |d|_1",
        text: script.proves(&[], &goal, ""),
        wrong: one_bit_less(DOUBLE),
    }
}

/// Returns the proof that a slope with its margin, which the code compares with the limit of parallel rays, is at least
/// the exact slope `s`. `|d|_1` is 1, and its computed value `m` has been rounded twice.
fn parallel() -> Proof {
    begin(Arithmetic::F64, f64::NAN);
    let (ray, record) = (ray(), record());
    let slope = ray.direction.dot(record.axis);
    _ = CapPlane::new(&record, &ray, record.top);
    let [with_margin, _] = compared()[0];
    let Operation::Sum(size, margin) = with_margin.operation() else { panic!("the margin is added") };
    let Operation::Product(length, _) = margin.operation() else { panic!("the margin is a product") };
    assert_eq!(size, slope.abs(), "the code compares the magnitude of the slope");
    let mut script = Script::relative(DOUBLE);
    script.define(size, ["S", "s"]);
    script.define(length, ["m", "1"]);
    let ([computed, _], [margin, _]) = (script.export(with_margin), script.export(margin));
    let hypotheses = [
        within("s", [0.0, 1.0]),
        format!("|S - s| <= {}", dyadic(OF_SLOPE * U)),
        format!("|m - 1| <= {}", dyadic(2.01 * U)),
    ];
    let size = &script.export(size)[0];
    let hints = format!("{computed} - s -> ({computed} - ({size} + {margin})) + ({size} - s) + {margin};\n");
    Proof {
        row: SLOPE,
        what: "the slope with its margin is at least the exact slope",
        text: script.proves(&hypotheses, &format!("{computed} - s >= 0"), &hints),
        wrong: one_bit_less(DOUBLE),
    }
}

/// Returns the proof of the error of a cap's lambda, `t / s`, for a distance of which the error is relative to its size
/// `X`, and for a slope of which it is relative to `|d|_1`, here `D`. They are accepted if they exceed shares of both.
fn cap() -> Proof {
    begin(Arithmetic::F64, f64::NAN);
    let [distance, slope] = [DERIVED, DERIVED + 1].map(|family| Bounded::number(family, 0.0));
    let mut script = Script::new();
    script.define(distance, ["T", "t"]);
    script.define(slope, ["S", "s"]);
    let [computed, exact] = script.export(distance / slope);
    let limit = CYLINDER_BOUND.condition_limit * (1.0 + 16.0 * U);
    let mut hypotheses = vec![
        format!("|(T - t) / X| <= {}", dyadic(OF_PLANE * U)),
        format!("|(S - s) / D| <= {}", dyadic(OF_SLOPE * U)),
        format!("|X / T| <= {}", dyadic(4.0 * limit)),
        format!("|D / S| <= {}", dyadic(8.0 * limit)),
    ];
    let all = ["X", "D", "|T|", "|t|", "|S|", "|s|", &format!("|{computed}|")];
    hypotheses.extend(all.map(|name| within(name, MODERATE)));
    let hint = |[size, computed, exact]: [&str; 3]| {
        let error = format!("({computed} - {exact}) / {size} * ({size} / {computed})");
        format!(
            "({computed} - {exact}) / {exact} -> ({error}) / (1 - {error}) {{ {computed} <> 0, {exact} <> 0, {size} <> 0 }};\n"
        )
    };
    let hints = hint(["X", "T", "t"]) + &hint(["D", "S", "s"]);
    let goal = format!("|{computed} -/ {exact}| <= {}", dyadic(CYLINDER_BOUND.lambda_error() / 3.0));
    Proof {
        row: "lambda of a cap",
        what: "the relative error of an accepted lambda, for the errors of distance and slope",
        text: script.proves(&hypotheses, &goal, &hints),
        wrong: in_single_precision(),
    }
}
