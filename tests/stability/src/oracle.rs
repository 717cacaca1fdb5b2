//! The oracle computes the definitions of the specification, section 9, with numbers of 2,048 bits, from the exact
//! numbers of a [`Case`].
//!
//! If the magnitudes in a case are not too far apart, sums and products of the inputs fit in these bits, so a
//! discriminant of zero is exactly zero. In [`SPHERES`](crate::regimes::SPHERES) and
//! [`CYLINDERS`](crate::regimes::CYLINDERS) all numbers except 0 are between 2^-100 and 2^60. Roots and quotients are
//! rounded. Two lambdas that agree in 1,000 bits count as equal. Different lambdas cannot agree so far, because they
//! are roots of polynomials with shorter coefficients.
//!
//! The oracle shares no code with `cpu::internals::exact`, and uses another library for big numbers, so that each can
//! show an error of the other. Their formulas differ too: the oracle computes roots and compares lambdas, but
//! `cpu::internals::exact` decides without a root.

use cpu::internals::geometry::cap::PARALLEL;
use cpu::internals::geometry::cylinder::CylinderPart;
use cpu::internals::geometry::ray::LAMBDA_MIN;
use cpu::internals::input::scene::{Cylinder, Shape, Sphere};
use cpu::{Ray, Vec3};
use dashu_float::FBig;
use dashu_float::round::mode::HalfEven;

use crate::case::Case;

/// A floating-point number with 2,048 bits.
pub type Big = FBig<HalfEven, 2>;

const BITS: usize = 2048;
const EQUAL_BITS: isize = 1000;

/// Returns `value` as a number of 2,048 bits. An infinite value or NaN becomes 0, but no case has such a value.
#[must_use]
pub fn big(value: f64) -> Big {
    Big::try_from(value).unwrap_or(Big::ZERO).with_precision(BITS).value()
}

/// The exact hit of a ray with an object.
#[derive(Clone, Debug)]
pub struct Truth {
    /// The smallest lambda that is in range and on the object.
    pub lambda: Big,
    /// The part of the cylinder that the ray hits; for a sphere always the side.
    pub part: CylinderPart,
    /// Whether the ray comes from outside the object.
    pub front: bool,
}

/// The oracle's answer for a case.
#[derive(Clone, Debug)]
pub struct Judgement {
    /// The hit, or `None` if the ray misses the object.
    pub truth: Option<Truth>,
    /// All lambdas at which the line crosses the infinite surfaces of the object, in range or not, each with its part.
    pub crossings: Vec<(CylinderPart, Big)>,
    /// The smallest distance by which a sphere's surface must move to change the decision. Then the line is tangent, or
    /// the point at the least lambda is on the surface. `None` for cylinders, for which it is not computed.
    pub slack: Option<f64>,
}

type Big3 = [Big; 3];

/// Returns the vector with components of 2,048 bits.
#[must_use]
pub fn big3(vector: Vec3) -> Big3 {
    vector.to_array().map(big)
}

/// Returns the dot product.
#[must_use]
pub fn dot(a: &Big3, b: &Big3) -> Big {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

/// Returns the difference.
#[must_use]
pub fn minus(a: &Big3, b: &Big3) -> Big3 {
    [0, 1, 2].map(|index| &a[index] - &b[index])
}

/// Returns the point of the ray at `lambda`.
fn at(ray: &Ray, lambda: &Big) -> Big3 {
    let (origin, direction) = (big3(ray.origin), big3(ray.direction));
    [0, 1, 2].map(|index| &origin[index] + &direction[index] * lambda)
}

fn magnitude(value: &Big) -> Big {
    if *value < Big::ZERO { -value.clone() } else { value.clone() }
}

/// Whether `a <= b`. Numbers that agree in 1,000 bits count as equal.
fn at_most(a: &Big, b: &Big) -> bool {
    a <= b || magnitude(&(a - b)) << EQUAL_BITS <= magnitude(a).max(magnitude(b))
}

/// Whether `lambda`, rounded to `f64`, is at least `LAMBDA_MIN`. The limit is the midpoint between `LAMBDA_MIN` and the
/// number below it. The midpoint is rounded up, because the last bit of `LAMBDA_MIN` is even.
fn in_range(lambda: &Big) -> bool {
    assert_eq!(LAMBDA_MIN.to_bits() % 2, 0);
    at_most(&((big(LAMBDA_MIN) + big(LAMBDA_MIN.next_down())) >> 1), lambda)
}

/// Returns the exact answer for a case.
#[must_use]
pub fn judge(case: &Case) -> Judgement {
    match &case.shape {
        Shape::Sphere(sphere) => judge_sphere(sphere, &case.ray),
        Shape::Cylinder(cylinder) => judge_cylinder(cylinder, &case.ray),
    }
}

/// Returns the index and the part of the closest hit of several objects, in the order of the scene file. Of hits with
/// equal lambdas, the last sphere or side counts, or else the first cap (specification, section 8.2). Lambdas of two
/// objects that differ may agree in more bits than those of one object, but in random cases they do not.
#[must_use]
pub fn closest(shapes: &[Shape], ray: &Ray) -> Option<(usize, CylinderPart)> {
    let mut closest: Option<(usize, Truth)> = None;
    for (index, &shape) in shapes.iter().enumerate() {
        let Some(hit) = judge(&Case { shape, ray: *ray }).truth else { continue };
        let is_closer = closest.as_ref().is_none_or(|(_, best)| match hit.part {
            CylinderPart::Side => at_most(&hit.lambda, &best.lambda),
            CylinderPart::Top | CylinderPart::Bottom => !at_most(&best.lambda, &hit.lambda),
        });
        if is_closer {
            closest = Some((index, hit));
        }
    }
    closest.map(|(index, hit)| (index, hit.part))
}

fn judge_sphere(sphere: &Sphere, ray: &Ray) -> Judgement {
    let direction = big3(ray.direction);
    let r_c = minus(&big3(sphere.center), &big3(ray.origin));
    let (a, h) = (dot(&direction, &direction), dot(&direction, &r_c));
    let radius = big(sphere.radius);
    let c = dot(&r_c, &r_c) - &radius * &radius;
    let discriminant = &h * &h - &a * &c;
    // The line's distance from the centre is sqrt(r^2 - discriminant / a).
    let off_center = magnitude(&(&radius * &radius - &discriminant / &a)).sqrt();
    let start = minus(&at(ray, &big(LAMBDA_MIN)), &big3(sphere.center));
    let moves = [off_center, dot(&start, &start).sqrt()].map(|distance| to_f64(&magnitude(&(distance - &radius))));
    let slack = Some(moves[0].min(moves[1]));
    if discriminant < Big::ZERO {
        return Judgement { truth: None, crossings: Vec::new(), slack };
    }
    let root = discriminant.sqrt();
    let roots = [(&h - &root) / &a, (&h + &root) / &a];
    let truth = roots.iter().enumerate().find(|(_, lambda)| in_range(lambda)).map(|(index, lambda)| Truth {
        lambda: lambda.clone(),
        part: CylinderPart::Side,
        front: index == 0 && root > Big::ZERO,
    });
    Judgement { truth, crossings: roots.map(|root| (CylinderPart::Side, root)).into(), slack }
}

fn judge_cylinder(cylinder: &Cylinder, ray: &Ray) -> Judgement {
    let (direction, axis) = (big3(ray.direction), big3(cylinder.axis));
    let r_c = minus(&big3(ray.origin), &big3(cylinder.center));
    let (square, half) = (dot(&axis, &axis), dot(&axis, &axis) >> 1);
    let (slope, height) = (dot(&direction, &axis), dot(&r_c, &axis));
    let radius_squared = big(cylinder.radius) * big(cylinder.radius);
    let mut crossings = Vec::new();
    let mut hits = Vec::new();

    // The quadratic equation of the side, multiplied by axis . axis, so that no division is needed.
    let a = dot(&direction, &direction) * &square - &slope * &slope;
    let h = dot(&r_c, &direction) * &square - &height * &slope;
    let c = (dot(&r_c, &r_c) - &radius_squared) * &square - &height * &height;
    let discriminant = &h * &h - &a * &c;
    if a > Big::ZERO && discriminant >= Big::ZERO {
        let root = discriminant.sqrt();
        let roots = [(-&h - &root) / &a, (-&h + &root) / &a];
        let counts = |lambda: &Big| {
            in_range(lambda)
                && at_most(&magnitude(&dot(&minus(&at(ray, lambda), &big3(cylinder.center)), &axis)), &half)
        };
        if let Some(index) = (0..2).find(|&index| counts(&roots[index])) {
            let front = index == 0 && root > Big::ZERO;
            hits.push(Truth { lambda: roots[index].clone(), part: CylinderPart::Side, front });
        }
        crossings.extend(roots.map(|root| (CylinderPart::Side, root)));
    }

    let steep = &slope * &slope >= big(PARALLEL) * big(PARALLEL) * &square;
    for (sign, part) in [(1.0, CylinderPart::Top), (-1.0, CylinderPart::Bottom)] {
        if !steep {
            continue;
        }
        let outward = big(sign) * &slope;
        let lambda = (&half - big(sign) * &height) / &outward;
        let point = minus(&at(ray, &lambda), &big3(cylinder.center));
        let from_base = [0, 1, 2].map(|index| &point[index] - ((big(sign) * &axis[index]) >> 1));
        if in_range(&lambda) && at_most(&dot(&from_base, &from_base), &radius_squared) {
            hits.push(Truth { lambda: lambda.clone(), part, front: outward < Big::ZERO });
        }
        crossings.push((part, lambda));
    }

    // The hit with the smallest lambda. Of hits with equal lambdas, the first one counts.
    let truth = hits.into_iter().reduce(|best, hit| if at_most(&best.lambda, &hit.lambda) { best } else { hit });
    Judgement { truth, crossings, slack: None }
}

/// Returns the distance of `point` from a part of the object's surface. The part has no edges here: the side is an
/// infinite cylinder, and a cap is a plane.
#[must_use]
pub fn distance_from_surface(case: &Case, part: CylinderPart, point: Vec3) -> f64 {
    let from_center = minus(&big3(point), &big3(case.center()));
    let distance = match (&case.shape, part) {
        (Shape::Sphere(sphere), _) => dot(&from_center, &from_center).sqrt() - big(sphere.radius),
        (Shape::Cylinder(cylinder), CylinderPart::Side) => {
            let axis = big3(cylinder.axis);
            let along = dot(&from_center, &axis);
            let across = dot(&from_center, &from_center) - &along * &along / dot(&axis, &axis);
            // For a point on the axis, rounding in the division may make the square slightly negative.
            across.max(Big::ZERO).sqrt() - big(cylinder.radius)
        }
        (Shape::Cylinder(cylinder), CylinderPart::Top | CylinderPart::Bottom) => {
            let axis = big3(cylinder.axis);
            let length = dot(&axis, &axis).sqrt();
            magnitude(&(dot(&from_center, &axis) / &length)) - (length >> 1)
        }
    };
    to_f64(&magnitude(&distance))
}

/// Returns the `f64` nearest to `value`.
#[must_use]
pub fn to_f64(value: &Big) -> f64 {
    value.to_f64().value()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn nearest(case: &Case) -> Option<(f64, CylinderPart, bool)> {
        judge(case).truth.map(|truth| (to_f64(&truth.lambda), truth.part, truth.front))
    }

    const Z: Vec3 = Vec3::new(0.0, 0.0, 1.0);

    #[test]
    fn spheres_are_met_touched_and_missed_by_one_bit() {
        let ray = |x: f64, z: f64| Case::sphere(Vec3::ZERO, 1.0, Vec3::new(x, 0.0, z), Z);
        assert_eq!(nearest(&ray(0.0, -3.0)), Some((2.0, CylinderPart::Side, true)));
        assert_eq!(nearest(&ray(0.0, 0.0)), Some((1.0, CylinderPart::Side, false)));
        assert_eq!(nearest(&ray(1.0, -3.0)), Some((3.0, CylinderPart::Side, false)), "a tangent comes from no side");
        assert_eq!(nearest(&ray(1.0_f64.next_up(), -3.0)), None);
        assert_eq!(
            nearest(&ray(0.0, -1.0 - LAMBDA_MIN)).map(|hit| hit.0 < 1.0),
            Some(false),
            "1.001 is nearer than 1e-3"
        );
    }

    #[test]
    fn the_slack_is_the_distance_to_the_nearest_other_decision() {
        let case = |x: f64, z: f64| Case::sphere(Vec3::ZERO, 1.0, Vec3::new(x, 0.0, z), Z);
        assert_eq!(judge(&case(1.5, -3.0)).slack, Some(0.5));
        assert_eq!(judge(&case(0.75, -3.0)).slack, Some(0.25));
        assert_eq!(judge(&case(0.0, -1.25)).slack, Some(0.25 - LAMBDA_MIN));
    }

    #[test]
    fn cylinders_are_met_at_all_parts_and_the_side_counts_on_the_rim() {
        let cylinder = Cylinder { center: Vec3::ZERO, radius: 1.0, axis: Vec3::new(0.0, 4.0, 0.0) };
        let case = |origin: [f64; 3], direction: [f64; 3]| Case::cylinder(cylinder, origin.into(), direction.into());
        assert_eq!(nearest(&case([0.0, 0.0, -3.0], [0.0, 0.0, 1.0])), Some((2.0, CylinderPart::Side, true)));
        assert_eq!(nearest(&case([0.0, 0.0, 0.0], [0.0, 0.0, 1.0])), Some((1.0, CylinderPart::Side, false)));
        assert_eq!(nearest(&case([0.0, 5.0, 0.0], [0.0, -1.0, 0.0])), Some((3.0, CylinderPart::Top, true)));
        assert_eq!(nearest(&case([0.0, 0.0, 0.0], [0.0, -1.0, 0.0])), Some((2.0, CylinderPart::Bottom, false)));
        assert_eq!(nearest(&case([0.0, 4.0, -3.0], [0.0, -1.0, 1.0])), Some((2.0, CylinderPart::Side, true)));
        assert_eq!(nearest(&case([0.0, 2.0_f64.next_up(), -3.0], [0.0, 0.0, 1.0])), None);
    }

    #[test]
    fn distances_are_measured_from_the_part() {
        let cylinder = Cylinder { center: Vec3::ZERO, radius: 1.0, axis: Vec3::new(0.0, 4.0, 0.0) };
        let case = Case::cylinder(cylinder, Vec3::ZERO, Z);
        assert_eq!(distance_from_surface(&case, CylinderPart::Side, Vec3::new(0.0, 1.0, 1.5)), 0.5);
        assert_eq!(distance_from_surface(&case, CylinderPart::Bottom, Vec3::new(0.5, -2.25, 0.0)), 0.25);
        let case = Case::sphere(Vec3::ZERO, 1.0, Vec3::ZERO, Z);
        assert_eq!(distance_from_surface(&case, CylinderPart::Side, Vec3::new(0.0, 0.0, 3.0)), 2.0);
    }
}
