//! Tests of secondary rays: a ray that leaves a surface must not hit it again from the wrong side.

use cpu::internals::geometry::cylinder::CylinderPart;
use cpu::internals::geometry::ray::{LAMBDA_MIN, facing};
use cpu::internals::input::scene::{Cylinder, Shape, Sphere};
use cpu::reference::intersect::{Exact, Intersect, Plain};
use cpu::{Ray, Vec3};
use stability::random::Random;
use stability::record::Record;

const SHAPES: usize = 1_000;
const RAYS: usize = 1_000;

/// The power of ten of the smallest sine of the angle at which a ray leaves a surface.
const LEAST_SLOPE_DECADE: f64 = -6.0;

/// Whether rounding of the ray's origin may put a part of the ray beyond the least lambda on the wrong side of the
/// surface. Then a wrong hit is no error of the intersection.
fn starts_in_noise(origin: Vec3, slope: f64) -> bool {
    let largest = origin.to_array().iter().fold(0.0_f64, |most, component| most.max(component.abs()));
    slope.abs() * LAMBDA_MIN < 16.0 * f64::EPSILON * largest
}

/// Returns the point of the ray's hit, the normal that points out of the object, and whether the ray comes from
/// outside.
fn intersect<P: Intersect>(shape: &Shape, ray: &Ray) -> Option<(Vec3, Vec3, bool)> {
    let record = Record::new(shape);
    let (lambda, part) = record.by(ray, P::sphere, P::cylinder)?;
    let outward = record.outward(part, ray.at(lambda));
    // Only the normal of a cylinder's side has another length than one.
    let is_side = matches!(shape, Shape::Cylinder(_)) && part == CylinderPart::Side;
    let outward = if is_side { outward.unit() } else { outward };
    Some((ray.at(lambda), outward, facing(ray.direction, outward).0))
}

/// Returns the length of the chord through a sphere, for a ray whose angle to the surface has the sine `slope`. Returns
/// 0 for a cylinder, whose chord is not known.
fn chord(shape: &Shape, slope: f64) -> f64 {
    match shape {
        Shape::Sphere(sphere) => 2.0 * sphere.radius * slope.abs(),
        Shape::Cylinder(_) => 0.0,
    }
}

/// Counts of rays that leave a surface: outwards, outwards with a wrong hit, inwards, and inwards without the right
/// hit.
#[derive(Debug, Default)]
struct Outcome {
    left: usize,
    met_from_outside: usize,
    entered: usize,
    lost_inside: usize,
}

/// Sends rays to a shape, lets a secondary ray leave each hit point outwards or inwards, and counts the results in
/// `outcome`.
fn leave<P: Intersect>(shape: &Shape, random: &mut Random, aim: Vec3, distance: f64, outcome: &mut Outcome) {
    for _ in 0..RAYS {
        let origin = aim + random.unit() * distance;
        let ray = Ray { origin, direction: aim + random.cube(0.5) - origin };
        let Some((point, outward, _)) = intersect::<P>(shape, &ray) else { continue };
        let slope = random.sign() * random.decades(LEAST_SLOPE_DECADE, 0.0);
        let scattered = random.perpendicular(outward) + outward * slope;
        if starts_in_noise(point, slope) {
            continue;
        }
        let again = intersect::<P>(shape, &Ray { origin: point, direction: scattered });
        if slope > 0.0 {
            outcome.left += 1;
            outcome.met_from_outside += usize::from(again.is_some());
        } else {
            outcome.entered += 1;
            // A ray inside must hit the surface from inside. No hit is right if the chord is shorter than the least
            // lambda.
            let lost = again.map_or(chord(shape, slope) > 2.0 * LAMBDA_MIN, |(_, _, front)| front);
            outcome.lost_inside += usize::from(lost);
        }
    }
}

fn spheres<P: Intersect>() -> Outcome {
    let (mut random, mut outcome) = (Random::new(17), Outcome::default());
    for _ in 0..SHAPES {
        // The surface passes through the origin of coordinates, as that of a ground does.
        let radius = random.decades(-1.0, 9.0);
        let up = random.unit();
        let shape = Shape::Sphere(Sphere { center: up * -radius, radius });
        leave::<P>(&shape, &mut random, Vec3::ZERO, radius.min(20.0) * 0.5, &mut outcome);
    }
    outcome
}

fn cylinders<P: Intersect>() -> Outcome {
    let (mut random, mut outcome) = (Random::new(19), Outcome::default());
    for _ in 0..SHAPES {
        let (radius, height) = (random.decades(-0.5, 6.0), random.decades(-0.5, 6.0));
        let axis = random.unit() * height;
        let side = random.perpendicular(axis) * radius;
        let center = if random.below(2) == 0 { -side } else { axis * -0.5 };
        let shape = Shape::Cylinder(Cylinder { center, radius, axis });
        leave::<P>(&shape, &mut random, Vec3::ZERO, 10.0, &mut outcome);
    }
    outcome
}

#[test]
fn rays_leaving_a_sphere_do_not_meet_it_again_from_the_wrong_side() {
    let outcome = spheres::<Exact>();
    assert!(outcome.left > SHAPES * RAYS / 10 && outcome.entered > SHAPES * RAYS / 10, "{outcome:?}");
    assert_eq!((outcome.met_from_outside, outcome.lost_inside), (0, 0), "{outcome:?}");
    let plain = spheres::<Plain>();
    assert!(plain.met_from_outside > 0, "the test is too mild to find the plain formulas' errors: {plain:?}");
}

#[test]
fn rays_leaving_a_cylinder_do_not_meet_it_again_from_the_wrong_side() {
    let outcome = cylinders::<Exact>();
    assert!(outcome.left > SHAPES * RAYS / 10 && outcome.entered > SHAPES * RAYS / 10, "{outcome:?}");
    assert_eq!((outcome.met_from_outside, outcome.lost_inside), (0, 0), "{outcome:?}");
}
