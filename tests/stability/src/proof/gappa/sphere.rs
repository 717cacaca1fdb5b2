//! The proofs of the plain formula of a sphere.

use cpu::Vec3;
use cpu::internals::exact::error_bound::NUMERATOR_WEIGHT;
use cpu::internals::exact::sphere_filter::SPHERE_BOUND;
use cpu::internals::geometry::sphere::SphereRecord;

use super::super::bounded::{Bounded, Operation, begin};
use super::super::bounds::Arithmetic;
use super::super::row::{U, family::*, ray};
use super::hypotheses::{MODERATE, relative};
use super::relative::{Dot, product};
use super::{DOUBLE, Proof, Script, dyadic, in_single_precision, one_bit_less, within};

/// The errors of the quadratic of a sphere in units of `u`, which a proof shows for each: of `a` and of `q = |O - C|^2`
/// relative to themselves, of `h` relative to `|d| |O - C|`, and of the discriminant relative to `M`.
const OF_A: f64 = 3.01;
const OF_Q: f64 = 5.01;
const OF_H: f64 = 4.3;
/// The relative error of a term of `h`, in units of `u`.
const OF_TERM: f64 = 2.001;
const OF_DISCRIMINANT: f64 = 22.0;

/// Returns the proofs, those that others build on first.
pub(super) fn proofs() -> Vec<Proof> {
    vec![
        square("a of a sphere", "the relative error of d.d", OF_A, |direction, _| direction.dot(direction), 0.0),
        square("discriminant of a sphere", "the relative error of |O - C|^2", OF_Q, |_, r_c| r_c.dot(r_c), 1.0),
        product("discriminant of a sphere", DOUBLE, [0.0, 1.0], OF_TERM),
        half_of_b(),
        discriminant(),
        numerator(),
        lambda(
            "lambda of a sphere",
            SPHERE_BOUND.condition_limit,
            SPHERE_BOUND.lambda_error(),
            [4.01, OF_H, OF_A / 2.0],
        ),
    ]
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
    Proof { row, what, text: script.proves(&hypotheses, &goal, ""), wrong: in_single_precision() }
}

/// Runs the formulas of a sphere. Returns `a`, `h`, `c` and the discriminant.
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
    let mut script = Script::relative(DOUBLE);
    script.given_dot(&Dot::of_products(h), "1", OF_TERM);
    let [computed, exact] = script.export(h);
    let goal = format!("|{computed} - {exact}| <= {}", dyadic(OF_H * U));
    Proof {
        row: "discriminant of a sphere",
        what: "the error of h relative to |d| |O - C|",
        text: script.proves(&[], &goal, ""),
        wrong: one_bit_less(DOUBLE),
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
        wrong: in_single_precision(),
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
        wrong: in_single_precision(),
    }
}

/// Returns the proof of the largest error of an accepted lambda. `k` times the largest value of `(A + B t + C t^2) / (1
/// + w t^2)`, and 2, must not exceed a third of the bound; `QuadraticErrors::lambda` has the reason. A `t` above 1 is
/// `1 / v`.
pub(super) fn lambda(row: &'static str, limit: f64, bound: f64, [a, b, c]: [f64; 3]) -> Proof {
    let [a, b, c, w] = [a, b, c, NUMERATOR_WEIGHT].map(dyadic);
    let most = dyadic((bound / 3.0 / U - 2.0) / limit);
    let text = format!(
        "{{ t in [0,1] /\\ v in [0,1]\n  -> ({a} + {b} * t + {c} * t * t) / (1 + {w} * t * t) <= {most}\n  \
         /\\ ({a} * v * v + {b} * v + {c}) / (v * v + {w}) <= {most} }}\n$ t in 64;\n$ v in 64;\n"
    );
    let wrong = [most, dyadic(1.0)];
    Proof { row, what: "the largest multiple of k that an error of an accepted lambda can be", text, wrong }
}
