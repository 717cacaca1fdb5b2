//! The intersections of a ray with one object, by the formulas of the statement (section 3.4).

use cpu::internals::input::scene::Cylinder;
use cpu::{Ray, Shape, Vec3};

use crate::rules::Rules;

/// The parts of objects.
pub const PARTS: [&str; 4] = ["sphere", "side", "upper base", "lower base"];

/// Why a sphere or a side has no lambda: the line of the ray misses it.
pub const MISSED: &str = "the discriminant is negative";

/// A lambda at which a ray may hit a part of an object, or the reason why there is none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Candidate {
    /// The part, a place in [`PARTS`].
    pub part: usize,
    /// The lambda, in lengths of the ray's direction, or NaN if there is none.
    pub lambda: f64,
    /// Why it does not count, or nothing if it counts.
    pub fault: &'static str,
    /// The distance of the point from the centre, along the axis for a side, and the largest that is on the part.
    pub reach: [f64; 2],
}

/// The candidates of one object, in the order in which they are tested.
pub type Candidates = [Option<Candidate>; 4];

/// Whether a lambda is not below the limit. NaN is.
fn in_range(lambda: f64, rules: &Rules) -> bool {
    if rules.has("limit") { lambda > rules.or("limit", 0.0) } else { lambda >= 1e-3 }
}

/// Returns the candidates of an object.
pub fn candidates(shape: &Shape, ray: &Ray, rules: &Rules) -> Candidates {
    match shape {
        Shape::Sphere(sphere) => {
            let r_c = sphere.center - ray.origin;
            let b = rules.or("sign-of-b", -2.0) * ray.direction.dot(r_c);
            let c = r_c.dot(r_c) - squared(sphere.radius, 1, rules);
            let [first, second] = roots([ray.direction.dot(ray.direction), b, c], 0, rules, |_| [0.0; 2]);
            [first, second, None, None]
        }
        Shape::Cylinder(cylinder) => {
            let [first, second] = side(cylinder, ray, rules).map(|root| root.filter(|_| !rules.has("no-side")));
            let upper = base(cylinder, ray, 2, rules).filter(|_| !rules.covers("no-base", 1));
            let lower = base(cylinder, ray, 3, rules).filter(|_| !rules.covers("no-base", 2));
            [first, second, upper, lower]
        }
    }
}

/// Returns lambda and part of an object's hit: the first candidate that counts, unless a later base is nearer.
pub fn hit(candidates: &Candidates, rules: &Rules) -> Option<(f64, usize)> {
    let counting = candidates.iter().flatten().filter(|candidate| candidate.fault.is_empty());
    let nearer = |hit: Option<(f64, usize)>, candidate: &Candidate| {
        let is_nearer = hit.is_none_or(|(lambda, part)| match rules.or("in-cylinder", 0.0) {
            1.0 => true,
            2.0 => part != 1 && candidate.lambda < lambda,
            _ => candidate.lambda < lambda,
        });
        if is_nearer { Some((candidate.lambda, candidate.part)) } else { hit }
    };
    counting.fold(None, nearer)
}

/// Returns the centre of a cylinder, its axis for the side and for the bases, and its height.
fn parts(cylinder: &Cylinder, rules: &Rules) -> (Vec3, [Vec3; 2], f64) {
    let (unit, height) = cylinder.axis.unit_and_length();
    let center = cylinder.center + unit * (height / 2.0 * rules.or("center", 0.0));
    let unit = if rules.or("axis", 0.0) == 4.0 { Vec3::new(0.0, 1.0, 0.0) } else { unit };
    let axis = |thing| if rules.covers("axis", thing) { cylinder.axis } else { unit };
    (center, [axis(1), axis(2)], height * rules.or("cylinder-height", 1.0))
}

fn side(cylinder: &Cylinder, ray: &Ray, rules: &Rules) -> [Option<Candidate>; 2] {
    let (center, [axis, _], height) = parts(cylinder, rules);
    let perpendicular = |vector: Vec3| vector - axis * vector.dot(axis);
    let (r_c, d) = (perpendicular(ray.origin - center), perpendicular(ray.direction));
    let c = r_c.dot(r_c) - squared(cylinder.radius, 2, rules);
    roots([d.dot(d), 2.0 * r_c.dot(d), c], 1, rules, |lambda| {
        let from_center = ray.origin + ray.direction * lambda - center;
        let along = if rules.has("side-distance") { from_center.length() } else { from_center.dot(axis).abs() };
        [along, height / 2.0 * rules.or("side-height", 1.0)]
    })
}

fn base(cylinder: &Cylinder, ray: &Ray, part: usize, rules: &Rules) -> Option<Candidate> {
    let (center, [_, axis], height) = parts(cylinder, rules);
    let normal = if part == 2 { axis } else { -axis };
    let base = center + normal * (height / 2.0 * rules.or("base-height", 1.0));
    let slope = ray.direction.dot(normal);
    let lambda = (base - ray.origin).dot(normal) / slope;
    let distance = (ray.origin + ray.direction * lambda - base).length();
    let distance = [distance, 0.0, distance * distance][rules.or("base-radius", 0.0) as usize];
    // A plane along the ray has no point.
    let is_parallel = slope.abs() < 1e-8;
    let fault = match (in_range(lambda, rules), distance <= cylinder.radius) {
        _ if is_parallel => "the base is parallel to the ray",
        (true, true) => "",
        (true, false) => "it is outside of the radius",
        _ => "it is below 1e-3",
    };
    let lambda = if is_parallel { f64::NAN } else { lambda };
    (!slope.is_nan()).then_some(Candidate { part, lambda, fault, reach: [distance, cylinder.radius] })
}

fn squared(radius: f64, object: u32, rules: &Rules) -> f64 {
    if rules.covers("radius", object) { radius } else { radius * radius }
}

/// Returns both roots of `a x^2 + b x + c` as candidates of `part`. A root counts only if the
/// first number of its `reach` is at most the second one. Without roots, one candidate says why.
fn roots([a, b, c]: [f64; 3], part: usize, rules: &Rules, reach: impl Fn(f64) -> [f64; 2]) -> [Option<Candidate>; 2] {
    let slip = rules.or("quadratic", 0.0);
    let a = if slip == 1.0 { 1.0 } else { a };
    let discriminant = b * b - if slip == 4.0 { 1.0 } else { 4.0 } * a * c;
    if discriminant < 0.0 {
        return [Some(Candidate { part, lambda: f64::NAN, fault: MISSED, reach: [0.0; 2] }), None];
    }
    let object = part as u32 + 1;
    let mut is_taken = false;
    [(-1.0, "far-root"), (1.0, "first-root")].map(|(sign, without)| {
        let numerator = -b + sign * discriminant.sqrt();
        let lambda = match slip {
            2.0 => numerator / 2.0 * a,
            3.0 => numerator / a,
            _ => numerator / (2.0 * a),
        };
        let reach = reach(lambda);
        let fault = match (in_range(lambda, rules), reach[0] <= reach[1]) {
            _ if lambda.is_nan() => "it is not a number",
            (false, _) => "it is below 1e-3",
            (_, false) => "it is beyond the bases",
            _ if is_taken => "the smaller root counts",
            _ => "",
        };
        let is_left_out = rules.covers(without, object);
        is_taken |= fault.is_empty() && !is_left_out;
        (!is_left_out).then_some(Candidate { part, lambda, fault, reach })
    })
}

/// Returns the outward normal of a part of an object at a point on it.
pub fn outward(shape: &Shape, part: usize, point: Vec3, rules: &Rules) -> Vec3 {
    match shape {
        Shape::Sphere(sphere) => {
            let normal = point - sphere.center;
            let unit = normal / sphere.radius;
            [unit, normal, -unit][rules.or("sphere-normal", 0.0) as usize]
        }
        Shape::Cylinder(cylinder) => {
            let (center, [of_side, of_bases], _) = parts(cylinder, rules);
            let across = (point - center) - of_side * (point - center).dot(of_side);
            let of_side = [across, across.unit(), point - center, (point - center).unit(), -across];
            let upper = [of_bases, of_bases, -of_bases];
            let lower = [-of_bases, of_bases, of_bases];
            let turned = rules.or("base-normal", 0.0) as usize;
            [of_side[rules.or("side-normal", 0.0) as usize], upper[turned], lower[turned]][part - 1]
        }
    }
}
