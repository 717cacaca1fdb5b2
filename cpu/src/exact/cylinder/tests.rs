//! Tests that decisions about sides and caps are certain or exact.

use crate::exact::cylinder::*;
use crate::geometry::cap::PARALLEL;
use crate::sampling::uniform::Uniform;

mod surface;

fn ray(origin: [f64; 3], direction: [f64; 3]) -> Ray {
    Ray { origin: origin.into(), direction: direction.into() }
}

fn hit(axis: [f64; 3], ray: &Ray) -> Option<(f64, CylinderPart)> {
    let axis = axis.into();
    intersect(&CylinderRecord::new(Vec3::ZERO, 1.0, axis), &axis, ray)
}

const UPRIGHT: [f64; 3] = [0.0, 4.0, 0.0];

#[test]
fn nothing_is_certain_where_a_product_overflows() {
    // The ray hits the side. In the discriminant `h^2` is finite, and `a c` overflows.
    let center = Vec3::new(-1.141091951153477e153, 6.341182490742231e152, -4.749887967150452e152);
    let axis = Vec3::new(0.550038010843549, 0.7925339449163328, -0.26334033641397786);
    let record = CylinderRecord::with_unit_axis(center, 1e140, axis, 1e139);
    let ray = ray([0.0; 3], [-7.9279994299912815, 4.405682742854909, -3.300094182421093]);
    let (.., discriminant) = record.quadratic(&record.seen_from(ray.origin), ray.direction);
    assert_eq!((discriminant, filtered(&record, &ray)), (f64::NEG_INFINITY, Decision::Uncertain));
}

#[test]
fn a_ray_that_misses_the_sphere_around_a_cylinder_misses_the_cylinder() {
    let mut draws = Uniform::new(31);
    let [mut misses, mut hits] = [0; 2];
    for exponent in [-305, -200, -9, 0, 9, 150, 200, 305] {
        for number in 0..400 {
            let size = 10.0_f64.powi(exponent);
            let mut vector = || Vec3::from([(); 3].map(|()| draws.draw(-1.0, 1.0)));
            let (axis, to_center, beside) = (vector() * size, vector(), vector());
            let distance = size * [0.0, 1.0, 3.0, 1e3][number % 4];
            let radius = size * draws.draw(1e-3, 1.0);
            let record = CylinderRecord::new(to_center * distance, radius, axis);
            // Half of the rays are aimed near the cylinder.
            let direction = if number % 8 < 4 { to_center + beside * (size / distance.max(size)) } else { beside };
            let ray = Ray { origin: Vec3::ZERO, direction };
            let (exact, around) = (precise(&record, &axis, &ray), sphere::wide(&sphere_around(&record), &ray));
            let part = |hit: Option<(f64, CylinderPart)>| hit.map(|(_, part)| part);
            assert_eq!(part(compensated_or_precise(&record, &axis, &ray)), part(exact), "{record:?}, {ray:?}");
            hits += usize::from(exact.is_some());
            if around == Decision::Certain(None) {
                assert_eq!(exact, None, "{record:?}, {ray:?}");
                misses += 1;
            }
        }
    }
    assert!(misses > 500 && hits > 300, "{misses}, {hits}");
}

#[test]
fn a_sphere_decides_a_miss_where_the_products_of_a_cylinder_overflow() {
    let axis = Vec3::from(UPRIGHT);
    let record = CylinderRecord::new(Vec3::ZERO, 1.0, axis);
    let far = ray([1e160, -3e160, 1e159], [0.3, 0.1, 0.7]);
    assert_eq!(compensated(&record, &axis, &far), Decision::Uncertain);
    assert_eq!(sphere::wide(&sphere_around(&record), &far), Decision::Certain(None));
    assert_eq!(precise(&record, &axis, &far), None);
}

#[test]
fn the_plain_formulas_decide_rays_from_cap_to_cap_that_run_along_the_axis() {
    let axis = Vec3::from(UPRIGHT);
    let record = CylinderRecord::new(Vec3::ZERO, 1.0, axis);
    for (height, up) in [(-2.0, 1.0), (0.0, 1.0), (1.0, -1.0), (3.0, -1.0)] {
        let ray = ray([0.3, height, 0.2], [1e-7, up, 1e-9]);
        let hit = filtered(&record, &ray);
        assert_eq!(hit, Decision::Certain(precise(&record, &axis, &ray)), "{ray:?}");
    }
}

#[test]
fn a_size_whose_square_underflows_makes_no_wrong_answer_certain() {
    let mut draws = Uniform::new(8);
    let (direction_size, across_size) = (2.0_f64.powi(-123), 2.0_f64.powi(-139));
    for _ in 0..2000 {
        let mut vector = || Vec3::from([(); 3].map(|()| draws.draw(-1.0, 1.0)));
        let (unit, other) = (vector().unit(), vector());
        let out = other.perpendicular_to(unit).unit();
        // The ray runs nearly along the axis, and touches the side but for rounding.
        let direction = unit * direction_size + unit.cross(out) * across_size;
        let (axis, radius) = (unit * 2.0_f64.powi(-117), across_size * draws.draw(0.5, 2.0));
        let lambda = draws.draw(0.1, 1.0);
        // The ray starts beside the middle. A larger distance would have a larger error bound.
        let record = CylinderRecord::new(unit * (direction_size * -lambda), radius, axis);
        let ray = Ray { origin: out * radius - direction * lambda, direction };
        if let Decision::Certain(hit) = filtered(&record, &ray) {
            assert_eq!(hit.is_some(), precise(&record, &axis, &ray).is_some(), "{record:?}, {ray:?}");
        }
    }
}

#[test]
fn ordinary_rays_are_certain_and_have_the_plain_formulas_hits() {
    let record = CylinderRecord::new(Vec3::ZERO, 1.0, UPRIGHT.into());
    for (ray, expected) in [
        (ray([0.1, 0.0, -3.0], [0.0, 0.1, 1.0]), Some(CylinderPart::Side)),
        (ray([0.0, 0.1, 0.0], [0.0, 0.1, 1.0]), Some(CylinderPart::Side)),
        (ray([0.5, 5.0, 0.0], [-0.3, -1.0, 0.1]), Some(CylinderPart::Top)),
        (ray([0.5, -5.0, 0.0], [-0.3, 1.0, 0.1]), Some(CylinderPart::Bottom)),
        (ray([0.0, 0.0, 0.0], [0.1, 1.0, 0.0]), Some(CylinderPart::Top)),
        // These rays start inside the infinite cylinder. The first two hit a cap first, and the third hits the
        // side.
        (ray([0.0, 3.0, 0.0], [1.0, -1.5, 0.0]), Some(CylinderPart::Top)),
        (ray([0.0, -3.0, 0.0], [1.0, 1.5, 0.0]), Some(CylinderPart::Bottom)),
        (ray([0.0, 1.9, 0.0], [1.0, -1.5, 0.0]), Some(CylinderPart::Side)),
        (ray([1.1, 5.0, 0.0], [0.0, -1.0, 0.1]), None),
        (ray([0.0, 2.1, -3.0], [0.0, 0.1, 1.0]), None),
        (ray([0.0, 0.0, 3.0], [0.0, 0.1, 1.0]), None),
    ] {
        let decision = filtered(&record, &ray);
        assert_eq!(decision, Decision::Certain(record.intersect(&ray)), "{ray:?}");
        let Decision::Certain(answer) = decision else { unreachable!() };
        assert_eq!(answer.map(|(_, part)| part), expected, "{ray:?}");
    }
}

#[test]
fn rims_axes_planes_and_tangents_are_decided_exactly() {
    use CylinderPart::{Side, Top};

    let beyond_1 = 1.0_f64.next_up();
    for (what, origin, direction, expected) in [
        ("through the rim the side counts", [0.0, 4.0, -3.0], [0.0, -1.0, 1.0], Some((2.0, Side))),
        ("through the other rim", [0.0, -4.0, -3.0], [0.0, 1.0, 1.0], Some((2.0, Side))),
        ("through the rim from inside", [0.0, 1.0, 0.0], [0.0, 1.0, 1.0], Some((1.0, Side))),
        ("along the axis", [0.0; 3], [0.0, 1.0, 0.0], Some((2.0, Top))),
        ("along the axis on the rim", [1.0, 5.0, 0.0], [0.0, -2.0, 0.0], Some((1.5, Top))),
        ("along the axis beside the rim", [beyond_1, 5.0, 0.0], [0.0, -2.0, 0.0], None),
        ("in the plane of a cap", [0.0, 2.0, -3.0], [0.0, 0.0, 1.0], Some((2.0, Side))),
        ("above that plane", [0.0, 2.0_f64.next_up(), -3.0], [0.0, 0.0, 1.0], None),
        ("parallel to the caps", [0.0, 0.0, -3.0], [0.0, 0.0, 0.5], Some((4.0, Side))),
        ("a tangent", [1.0, 0.0, -3.0], [0.0, 0.0, 0.5], Some((6.0, Side))),
        ("beside the tangent", [beyond_1, 0.0, -3.0], [0.0, 0.0, 0.5], None),
        ("a null direction", [0.0; 3], [0.0; 3], None),
        ("no number", [0.0, f64::NAN, 0.0], [0.0, 1.0, 0.0], None),
    ] {
        assert_eq!(hit(UPRIGHT, &ray(origin, direction)), expected, "{what}");
    }
    let leaning = [1.0, 2.0, -0.3];
    assert_eq!(hit(leaning, &ray([0.0; 3], leaning.map(|component| component * 0.25))), Some((2.0, Top)));
}

#[test]
fn planes_within_the_limit_of_parallel_are_skipped() {
    // The slopes are close to 1e-8. The ray whose slope is just below hits no cap, although its line crosses the
    // disc.
    let start = [0.0, 1.0 - 1e-9, 0.0];
    let toward = |slope: f64| ray(start, [0.5, slope, 0.0]);
    let flat = [0.0, 2.0, 0.0];
    assert_eq!(hit(flat, &toward(PARALLEL)).map(|(_, part)| part), Some(CylinderPart::Top));
    assert_eq!(hit(flat, &toward(PARALLEL.next_down())), None, "the side is hit beyond the cap");
}
