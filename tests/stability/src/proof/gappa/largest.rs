//! Proofs that no number of a formula overflows.
//!
//! The longer a direction is, the smaller are the vectors that it is multiplied by. So the domain is divided into parts
//! by the length of the direction, and each part has limits of all inputs and a proof.

use cpu::Vec3;
use cpu::internals::accel::extent::Extent;
use cpu::internals::accel::may_hit::conservative::ConservativeRay;
use cpu::internals::exact::cylinder_decision::{CYLINDER_BOUND, CapPlane};
use cpu::internals::exact::cylinder_plain::SHARE_ACROSS_AXIS;
use cpu::internals::exact::error_bound::{HEADROOM, LARGEST_IN_SCALE, OVERFLOW, SMALLEST_IN_SCALE};
use cpu::internals::geometry::ray::LAMBDA_MIN;

use super::super::bounded::{Bounded, Operation, begin, numbers};
use super::super::bounds::Arithmetic;
use super::super::exact;
use super::super::filters::{EXTENT, target};
use super::super::parts::{axis_and_half_height, record};
use super::super::row::{family::*, ray};
use super::{Proof, Script, dyadic, within};

/// The limits of a part of the domain, as binary logarithms.
#[derive(Clone, Copy)]
struct Part {
    /// The shortest and the longest direction.
    direction: [i32; 2],
    /// The longest vector between the ray's origin and the object, and the largest radius.
    size: i32,
    /// The largest coordinate of the object and of the ray's origin.
    extent: i32,
}

/// Numbers whose magnitudes are known in a part of the domain, not by the operations that compute them.
struct Known<'a> {
    /// Vectors that are not longer than the part's size.
    of_size: &'a [Vec3<Bounded>],
    /// The unit axis and half of the height of a cylinder.
    cylinder: Option<(Vec3<Bounded>, Bounded)>,
    /// A number by which others are divided: it is at least this multiple of a power of the shortest direction.
    least: Option<(Bounded, f64, i32)>,
}

/// Returns the proofs that no computed number reaches 2^1024, one for each part: the sum of the magnitudes of all
/// numbers does not.
fn proofs(row: &'static str, parts: &[Part], known: &Known) -> Vec<Proof> {
    let mut script = Script::new();
    let mut free = |number: Bounded| {
        let name = format!("x{}", number.place());
        script.define(number, [&name, &name]);
        name
    };
    let (mut directions, mut sizes, mut extents, mut units) = (vec![], vec![], vec![], vec![]);
    sizes.extend(known.of_size.iter().flat_map(|vector| vector.to_array()).map(&mut free));
    let mut first = 0;
    if let Some((axis, half_height)) = known.cylinder {
        units.extend(axis.to_array().map(&mut free));
        extents.push(free(half_height));
        first = half_height.place();
    }
    let mut computed = Vec::new();
    for number in numbers() {
        let text = match number.operation() {
            _ if script.names.contains_key(&number) => continue,
            Operation::Input((family, _)) => {
                let [name, _] = script.export(number);
                match family {
                    DIRECTION => directions.push(name),
                    RADIUS | INNER_RADIUS => sizes.push(name),
                    CENTER | ORIGIN | EXTENT => extents.push(name),
                    // The axis of the file makes the known numbers of the cylinder.
                    _ => {}
                }
                continue;
            }
            // This factor makes an error bound infinite, and then nothing is certain. An infinite constant is a result
            // that is chosen.
            Operation::Constant(bits) if f64::from_bits(bits) == HEADROOM => "1".to_owned(),
            Operation::Constant(bits) if f64::from_bits(bits).is_infinite() => "0".to_owned(),
            _ if number.place() < first => continue,
            Operation::Constant(_) => continue,
            Operation::Flipped(of, _) => script.export(of)[0].clone(),
            // The root of a negative number is NaN, which no comparison holds for.
            Operation::Root(of) => format!("rnd(sqrt(|{}|))", script.export(of)[0]),
            _ => {
                computed.push(format!("|{}|", script.export(number)[0]));
                continue;
            }
        };
        script.define(number, [&text, "0"]);
    }
    let least = known.least.map(|(number, factor, power)| (script.export(number)[0].clone(), factor, power));
    script.definitions += &format!("sum = {};\n", computed.join(" + "));
    script.keep_only('c');
    let of_part =
        |part: &Part| {
            let Part { direction: [shortest, longest], size, extent } = *part;
            let limits = [(&directions, longest), (&sizes, size), (&extents, extent), (&units, 1)];
            let limits = limits.into_iter().flat_map(|(names, most)| {
                names.iter().map(move |name| within(&format!("|{name}|"), [0.0, 2.0_f64.powi(most)]))
            });
            let mut hypotheses: Vec<_> = limits.collect();
            hypotheses.extend(least.iter().map(|(name, factor, power)| {
                format!("|{name}| >= {}", dyadic(factor * 2.0_f64.powi(shortest * power)))
            }));
            let goal = format!("sum <= {}", dyadic(2.0_f64.powi(1023)));
            let wrong = ["1b1023", "1b340"].map(ToOwned::to_owned);
            Proof { row, what: "no number exceeds 2^1023", text: script.proves(&hypotheses, &goal, ""), wrong }
        };
    parts.iter().map(of_part).collect()
}

/// The binary logarithms of the lengths of directions that are in scale.
fn in_scale() -> [i32; 2] {
    [SMALLEST_IN_SCALE, LARGEST_IN_SCALE].map(|squared| squared.log2() as i32 / 2)
}

/// Returns ranges of directions of which the longest is 2 to the power of `step` times as long as the shortest.
fn directions([shortest, longest]: [i32; 2], step: i32) -> impl Iterator<Item = [i32; 2]> {
    (shortest..longest).step_by(step as usize).map(move |least| [least, least + step])
}

/// Returns the parts of a quadratic: neither `w^2 = |O - C|^2 + r^2` nor `|d|^2 w^2` exceeds the limit.
fn quadratic() -> Vec<Part> {
    let ([shortest, longest], most) = (in_scale(), OVERFLOW.log2() as i32 / 2);
    let directions = [[shortest, 0]].into_iter().chain(directions([0, longest], 3));
    directions.map(|of| Part { direction: of, size: most - of[0].max(0), extent: 2 * most }).collect()
}

pub(super) fn sphere() -> Vec<Proof> {
    begin(Arithmetic::F64, HEADROOM);
    let [a, ..] = exact::sphere();
    let to_center = Bounded::vector(CENTER, 0.0) - ray().origin;
    let known = Known { of_size: &[to_center], cylinder: None, least: Some((a, 1.0, 2)) };
    proofs("largest number of a sphere", &quadratic(), &known)
}

/// Returns the proofs of the side of a cylinder. The part of a vector across the axis is not longer than the vector.
pub(super) fn side() -> Vec<Proof> {
    begin(Arithmetic::F64, HEADROOM);
    let [a, ..] = exact::cylinder(false);
    let (axis, half_height) = axis_and_half_height();
    let from_center = ray().origin - record().center;
    let of_size = [from_center, from_center.perpendicular_to(axis)];
    let share = 0.5 / (SHARE_ACROSS_AXIS * CYLINDER_BOUND.condition_limit.powi(2));
    let known = Known { of_size: &of_size, cylinder: Some((axis, half_height)), least: Some((a, share, 2)) };
    proofs("largest number of a side", &quadratic(), &known)
}

/// Returns the proofs of a cap, for coordinates up to 2^480 as in `proof/magnitudes.rs`.
pub(super) fn cap() -> Vec<Proof> {
    begin(Arithmetic::F64, f64::NAN);
    let (ray, record) = (ray(), record());
    _ = CapPlane::new(&record, &ray, record.top).disc(&record, &ray);
    let (slope, share) = (ray.direction.dot(record.axis), 1.0 / (8.0 * CYLINDER_BOUND.condition_limit));
    let known = Known {
        of_size: &[record.top - ray.origin],
        cylinder: Some(axis_and_half_height()),
        least: Some((slope, share, 1)),
    };
    let parts: Vec<_> = directions(in_scale(), 6).map(|direction| Part { direction, size: 480, extent: 480 }).collect();
    proofs("largest number of a cap", &parts, &known)
}

/// Returns the proof of the conservative tests. A ray with `t |d| > 3.5 L` has passed all objects at the least lambda
/// `t`, and a direction that is in scale may be longer only if the ray starts inside an object.
pub(super) fn conservative() -> Vec<Proof> {
    begin(Arithmetic::F64, f64::NAN);
    let (ray, target) = (ray(), target(false));
    let test = ConservativeRay::new(ray);
    _ = test.cylinder(&target);
    _ = test.starts_within(&test.cylinder_quadratic(&target).0);
    let log = |value: f64| value.log2().ceil() as i32;
    let (extent, size, [_, longest]) = (log(Extent::LARGEST), log(3.5 * Extent::LARGEST), in_scale());
    let known = Known { of_size: &[target.center - ray.origin], cylinder: Some(axis_and_half_height()), least: None };
    assert!(log(3.5 * Extent::LARGEST / LAMBDA_MIN) < longest, "all directions are in scale");
    let part = Part { direction: [0, longest], size, extent };
    proofs("largest number of a conservative test", &[part], &known)
}
