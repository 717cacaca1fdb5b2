//! The proofs that are exported. Several of them build on another one, whose goal is their hypothesis.

use cpu::Vec3;
use cpu::internals::exact::cylinder_decision::{CYLINDER_BOUND, CapPlane};
use cpu::internals::exact::cylinder_plain::LEAST_SIZE;
use cpu::internals::exact::error_bound::{LARGEST_IN_SCALE, NUMERATOR_WEIGHT};
use cpu::internals::exact::order::is_certainly_closer;
use cpu::internals::exact::sphere_filter::SPHERE_BOUND;
use cpu::internals::geometry::sphere::SphereRecord;
use cpu::internals::math::real::Real;

use super::super::bounded::{Bounded, Operation, begin, compared};
use super::super::bounds::Arithmetic;
use super::super::parts::{axis_and_half_height, record};
use super::super::row::{U, family::*, ray};
use super::{Proof, Script, dyadic};

/// The relative error of a component of a unit axis, in units of `u`, which the first proof shows.
const OF_AXIS: f64 = 3.53;
/// The errors of the quadratic of a sphere in units of `u`, which a proof shows for each: of `a` and of `q = |O - C|^2`
/// relative to themselves, of `h` relative to `|d| |O - C|`, and of the discriminant relative to `M`.
const OF_A: f64 = 3.01;
const OF_Q: f64 = 5.01;
const OF_H: f64 = 4.3;
const OF_DISCRIMINANT: f64 = 22.0;
/// The error of the slope of a ray along an axis relative to `|d|_1`, and that of the distance of a cap's plane, which
/// is no proof of Gappa's but the need of its row.
const OF_SLOPE: f64 = 6.85;
const OF_PLANE: f64 = 7.5;

/// Returns the proofs, those that others build on first.
#[must_use]
pub fn scripts() -> Vec<Proof> {
    vec![
        axis(),
        slope(),
        parallel(),
        cap(),
        square("a of a sphere", "the relative error of d.d", OF_A, |direction, _| direction.dot(direction), 0.0),
        square("discriminant of a sphere", "the relative error of |O - C|^2", OF_Q, |_, r_c| r_c.dot(r_c), 1.0),
        half_of_b(),
        discriminant(),
        numerator(),
        lambda(
            "lambda of a sphere",
            SPHERE_BOUND.condition_limit,
            SPHERE_BOUND.lambda_error(),
            [3.5, OF_H, OF_A / 2.0],
        ),
        order(),
        long_side(),
    ]
}

fn within(name: &str, [low, high]: [f64; 2]) -> String {
    format!("{name} in [{},{}]", dyadic(low), dyadic(high))
}

/// Returns that a computed value has a relative error of at most `error u`.
fn relative([computed, exact]: &[String; 2], error: f64) -> String {
    format!("|{computed} -/ {exact}| <= {}", dyadic(error * U))
}

/// Magnitudes for which no square overflows or underflows.
const MODERATE: [f64; 2] = [f64::from_bits((1023 - 300) << 52), f64::from_bits((1023 + 300) << 52)];

fn axis() -> Proof {
    begin(Arithmetic::F64, f64::NAN);
    let (axis, _) = axis_and_half_height();
    let mut script = Script::new();
    let [computed, exact] = script.export(axis.x);
    let hypotheses = [0, 1, 2].map(|component| within(&format!("|x17_{component}|"), MODERATE));
    let goal = relative(&[computed, exact], OF_AXIS);
    Proof {
        row: "slope of a ray along an axis",
        what: "the relative error of a component of the unit axis",
        text: script.proves(&hypotheses, &goal, ""),
    }
}

/// Defines the three products of a dot product, of which the exact magnitudes are at most `w0`, `w1` and `w2`. These
/// add up to 1. `error` is the relative error of the second factors, in units of `u`. Returns the hypotheses.
fn products(script: &mut Script, dot: Bounded, error: f64) -> Vec<String> {
    let Operation::Sum(two, third) = dot.operation() else { panic!("it is no sum") };
    let Operation::Sum(first, second) = two.operation() else { panic!("it is no sum of three") };
    script.definitions += "w0 = 1 - w1 - w2;\n";
    let mut hypotheses = Vec::new();
    for (index, product) in [first, second, third].into_iter().enumerate() {
        assert!(matches!(product.operation(), Operation::Product(..)), "a dot product adds products");
        let before = format!("p{index}");
        let [_, exact] = script.define(product, [&format!("rnd({before})"), &format!("r{index} * w{index}")]);
        hypotheses.push(within(&format!("r{index}"), [-1.0, 1.0]));
        hypotheses.push(within(&format!("w{index}"), [0.0, 1.0]));
        hypotheses.push(relative(&[before, exact], error));
    }
    hypotheses
}

/// Returns the proof of the error of a slope relative to `|d|_1`, which is 1 here. It is at least the sum of the
/// products' magnitudes, as no component of the axis exceeds 1.
fn slope() -> Proof {
    begin(Arithmetic::F64, f64::NAN);
    let slope = ray().direction.dot(record().axis);
    let mut script = Script::new();
    let hypotheses = products(&mut script, slope, OF_AXIS);
    let [computed, exact] = script.export(slope);
    let goal = format!("|{computed} - {exact}| <= {}", dyadic(OF_SLOPE * U));
    Proof {
        row: "slope of a ray along an axis",
        what: "the error of the slope relative to |d|_1",
        text: script.proves(&hypotheses, &goal, "$ w1 in 32, w2 in 32;\n"),
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
    let mut script = Script::new();
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
        row: "slope of a ray along an axis",
        what: "the slope with its margin is at least the exact slope",
        text: script.proves(&hypotheses, &format!("{computed} - s >= 0"), &hints),
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
    }
}

/// Returns the proof of the relative error of a vector's square. The components have relative errors of `error u`.
fn square(
    row: &'static str,
    what: &'static str,
    goal: f64,
    of: impl Fn(Vec3<Bounded>, Vec3<Bounded>) -> Bounded,
    error: f64,
) -> Proof {
    begin(Arithmetic::F64, f64::NAN);
    let (ray, center) = (ray(), Bounded::vector(CENTER, 0.0));
    let to_center = SphereRecord::new(center, Bounded::number(RADIUS, 0.0)).seen_from(ray.origin).to_center;
    let mut script = Script::new();
    let mut hypotheses = Vec::new();
    for (index, (direction, to_center)) in ray.direction.to_array().into_iter().zip(to_center.to_array()).enumerate() {
        let [computed, exact] = ["y", "x"].map(|name| format!("{name}{index}"));
        script.define(direction, [&exact, &exact]);
        script.define(to_center, [&computed, &exact]);
        hypotheses.push(within(&format!("|{exact}|"), MODERATE));
        hypotheses.push(relative(&[computed, exact], error));
    }
    let goal = relative(&script.export(of(ray.direction, to_center)), goal);
    Proof { row, what, text: script.proves(&hypotheses, &goal, "") }
}

/// Runs the formulas of a sphere. Returns the ray's direction, `a`, `h`, `c` and the discriminant.
fn sphere() -> [Bounded; 4] {
    begin(Arithmetic::F64, f64::NAN);
    let (ray, center) = (ray(), Bounded::vector(CENTER, 0.0));
    let view = SphereRecord::new(center, Bounded::number(RADIUS, 0.0)).seen_from(ray.origin);
    let a = ray.direction.dot(ray.direction);
    let (h, discriminant) = view.quadratic(ray.direction, a);
    [a, h, view.c, discriminant]
}

/// Returns the proof of the error of `h = d.(C - O)` relative to `|d| |C - O|`, here 1, which is at least the sum of
/// the products' magnitudes. A component of `C - O` has been rounded once.
fn half_of_b() -> Proof {
    let [_, h, ..] = sphere();
    let mut script = Script::new();
    let hypotheses = products(&mut script, h, 1.0);
    let [computed, exact] = script.export(h);
    let goal = format!("|{computed} - {exact}| <= {}", dyadic(OF_H * U));
    Proof {
        row: "discriminant of a sphere",
        what: "the error of h relative to |d| |O - C|",
        text: script.proves(&hypotheses, &goal, "$ w1 in 32, w2 in 32;\n"),
    }
}

/// Returns the proof of the error of `D = h^2 - a c` relative to `M = a (q + r^2)`. Both are 1 here, `Q` is `|O - C|`,
/// and `r^2` is `1 - Q^2`.
fn discriminant() -> Proof {
    let [a, h, c, discriminant] = sphere();
    let mut script = Script::new();
    let of_a = script.define(a, ["A", "1"]);
    let of_h = script.define(h, ["r * Q + g * Q", "r * Q"]);
    let Operation::Difference(square, radius_squared) = c.operation() else { panic!("c is a difference") };
    let of_q = script.define(square, ["P", "Q * Q"]);
    script.define(radius_squared, ["rnd(1 - Q * Q)", "1 - Q * Q"]);
    let [computed, exact] = script.export(discriminant);
    let hypotheses = [
        within("Q", [0.0, 1.0]),
        within("r", [-1.0, 1.0]),
        relative(&of_a, OF_A),
        relative(&of_q, OF_Q),
        format!("|g| <= {}", dyadic(OF_H * U)),
    ];
    let goal = format!("|{computed} - {exact}| <= {}", dyadic(OF_DISCRIMINANT * U));
    let hints = format!("{} - {} -> g * Q;\n$ Q in 64;\n", of_h[0], of_h[1]);
    Proof {
        row: "discriminant of a sphere",
        what: "the error of the discriminant relative to M",
        text: script.proves(&hypotheses, &goal, &hints),
    }
}

/// Returns the proof of the error of `n = h +- sqrt(D)`, times the root of the computed `D`, relative to `M`, here 1.
/// `s` is the root of the exact `D`, and `S` that of the computed one. Both are at most 1, and `|h| s` is at most 1/2.
fn numerator() -> Proof {
    begin(Arithmetic::F64, f64::NAN);
    let [h, root] = [DERIVED, DERIVED + 1].map(|family| Bounded::number(family, 0.0));
    let mut script = Script::new();
    let [of_h, of_root] = [script.define(h, ["H + gh", "H"]), script.define(root, ["rnd(S)", "s"])];
    let [computed, exact] = script.export(h + root);
    // The root is far above its error, so that the computed `D` is within a millionth of the exact one.
    let hypotheses = [
        within("S", [2.0_f64.powi(-20), 1.0 + 1e-6]),
        within("s", [2.0_f64.powi(-20), 1.0]),
        format!("|S * S - s * s| <= {}", dyadic(OF_DISCRIMINANT * U)),
        within("H * S", [-0.500_001, 0.500_001]),
        within("H", [-1.0, 1.0]),
        format!("|gh * S| <= {}", dyadic(OF_H / 2.0 * U * 1.000_001)),
        format!("|gh| <= {}", dyadic(OF_H * U)),
    ];
    let error = format!("({computed} - {exact}) * S");
    let goal = format!("|{error}| <= {}", dyadic(SPHERE_BOUND.error_constant * U));
    let (root, sum) = (&of_root[0], format!("{} + {}", of_h[0], of_root[0]));
    let last = format!("{computed} - ({sum})");
    let hints = format!(
        "{error} -> ({last}) * S + gh * S + ({root} - S) * S + (S * S - s * s) * (S / (S + s)) {{ S + s <> 0 }};\n\
         ({last}) * S -> (({last}) / ({sum})) * (H * S + gh * S + {root} * S) {{ {sum} <> 0 }};\n\
         S / (S + s) -> 1 / (1 + s / S) {{ S <> 0, S + s <> 0 }};\n"
    );
    Proof {
        row: "numerator of a sphere's root",
        what: "the error of the numerator times the root, relative to M",
        text: script.proves(&hypotheses, &goal, &hints),
    }
}

/// Returns the proof of the largest error of an accepted lambda. `k` times the largest value of `(A + B t + C t^2) / (1
/// + w t^2)`, and 2, must not exceed a third of the bound; `QuadraticErrors::lambda` has the reason. A `t` above 1 is
/// `1 / v`.
fn lambda(row: &'static str, limit: f64, bound: f64, [a, b, c]: [f64; 3]) -> Proof {
    let [a, b, c, w] = [a, b, c, NUMERATOR_WEIGHT].map(dyadic);
    let most = dyadic((bound / 3.0 / U - 2.0) / limit);
    let text = format!(
        "{{ t in [0,1] /\\ v in [0,1]\n  -> ({a} + {b} * t + {c} * t * t) / (1 + {w} * t * t) <= {most}\n  \
         /\\ ({a} * v * v + {b} * v + {c}) / (v * v + {w}) <= {most} }}\n$ t in 64;\n$ v in 64;\n"
    );
    Proof { row, what: "the largest multiple of k that an error of an accepted lambda can be", text }
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
    }
}

/// Returns the proof that the other factor of `m^2 / 2` is a normal number, if `m` is at least the least size.
fn long_side() -> Proof {
    let least = dyadic(LEAST_SIZE * LEAST_SIZE / 2.0);
    let text = format!(
        "{{ a in [1b-1074,{}] /\\ a * x >= {least} /\\ x in [0,1b1023] -> x >= {} }}\nx -> a * x / a {{ a <> 0 }};\n",
        dyadic(LARGEST_IN_SCALE),
        dyadic(f64::MIN_POSITIVE)
    );
    Proof { row: "underflow of a long side", what: "the smaller factor of the square of m", text }
}
