//! Tests of the order of two hits.

use super::*;
use crate::sampling::uniform::Uniform;

/// Returns the cap, at this height above `point`, of a cylinder with this axis. The cap faces a ray along
/// `direction`.
fn cap(point: Vec3, direction: Vec3, height: f64, axis: Vec3) -> Surface {
    let (part, half) = match direction.dot(axis) < 0.0 {
        true => (CylinderPart::Top, 0.5),
        false => (CylinderPart::Bottom, -0.5),
    };
    let center = point + Vec3::new(0.0, height, 0.0) - axis * half;
    Surface::Cylinder(CylinderRecord::new(center, 2.0, axis), axis, part)
}

#[test]
fn computed_lambdas_decide_only_beyond_their_errors() {
    let error = CYLINDER_BOUND.lambda_error();
    assert!(is_certainly_closer(1.0, 1.0 + 2.0 * error) && !is_certainly_closer(1.0, 1.0 + error / 2.0));
    assert!(is_certainly_closer(5.0, f64::INFINITY) && !is_certainly_closer(f64::INFINITY, f64::INFINITY));
    assert!(!is_certainly_closer(f64::NAN, 1.0) && !is_certainly_closer(1.0, f64::NAN));
}

#[test]
fn every_step_has_the_order_of_the_exact_lambdas() {
    let mut draws = Uniform::new(48);
    let mut orders = [0; 3];
    for _ in 0..3000 {
        let mut vector = || Vec3::from([(); 3].map(|()| draws.draw(-1.0, 1.0)));
        let (direction, aside, target) = (vector(), vector() * 0.3, vector());
        let ray = Ray { origin: target - direction * 7.0, direction };
        let gap = [0.0, 2e-16, 1e-14, 1e-11][draws.draw(0.0, 4.0) as usize] * draws.draw(-1.0, 1.0).signum();
        let center = target + Vec3::new(aside.x, 0.0, aside.z);
        let straight = [(0.0, 2.0), (gap, draws.draw(0.5, 4.0))];
        let straight = straight.map(|(height, length)| cap(center, direction, height, Vec3::new(0.0, length, 0.0)));
        let tilted = [(0.0, 0.25), (gap, [-0.25, 0.31][draws.draw(0.0, 2.0) as usize])];
        let tilted = tilted.map(|(height, share)| cap(target, direction, height, Vec3::new(0.5, 4.0, -0.3) * share));
        let shells = [2.0, 2.0 - gap].map(|radius| Surface::Sphere(SphereRecord::new(target + aside, radius)));
        for hits in [straight, tilted, shells] {
            let hits = hits.each_ref();
            let lambdas = hits.map(|hit| hit.exact_lambda(&ray).ok().flatten().map_or(0.0, |exact| exact.rounded()));
            let order = compare(&ray, hits, lambdas);
            assert_eq!(order, compare_exactly(&ray, hits), "{ray:?}, {hits:?}");
            assert_eq!(order.map(Ordering::reverse), compare(&ray, [hits[1], hits[0]], [lambdas[1], lambdas[0]]));
            orders[(order.expect("all numbers are finite") as i8 + 1) as usize] += 1;
        }
    }
    assert!(orders.iter().all(|&count| count > 300), "{orders:?}");
}

#[test]
fn nested_shells_and_tubes_have_the_order_of_the_exact_lambdas() {
    let mut draws = Uniform::new(7);
    let (mut orders, mut decided) = ([0; 3], 0);
    for number in 0..4000 {
        let mut vector = || Vec3::from([(); 3].map(|()| draws.draw(-1.0, 1.0)));
        let (center, offset, target) = (vector() * 5.0, vector(), vector());
        let gap = [0.0, 4.5e-16, 1e-15, 1e-9, 0.3][number % 5] * if number % 2 == 0 { 1.0 } else { -1.0 };
        // Every third ray starts inside both surfaces, and leaves them.
        let origin = center + offset * if number % 3 == 0 { 0.5 } else { 9.0 };
        let ray = Ray { origin, direction: center + target - origin };
        let along = [Vec3::new(0.0, 8.0, 0.0), Vec3::new(2.0, -7.0, 4.0)][number / 5 % 2];
        let tube = |center: Vec3, radius: f64, axis: Vec3| {
            Surface::Cylinder(CylinderRecord::new(center, radius, axis), axis, CylinderPart::Side)
        };
        let shells = [2.0, 2.0 - gap].map(|radius| Surface::Sphere(SphereRecord::new(center, radius)));
        let nested = [tube(center, 2.0, along), tube(center, 2.0 - gap, -along)];
        let shifted = [tube(center, 2.0, along), tube(center + Vec3::new(0.0, 0.5, 0.0), 2.0 - gap, along)];
        for hits in [shells, nested, shifted] {
            let hits = hits.each_ref();
            let [Some(left), Some(right)] = hits.map(|hit| hit.exact_lambda(&ray).ok().flatten()) else { continue };
            let lambdas = [left.rounded(), right.rounded()];
            let order = compare(&ray, hits, lambdas);
            assert_eq!(order, Some(left.compare(&right)), "{ray:?}, {hits:?}");
            decided += usize::from(compare_nested(&ray, hits, lambdas).is_some_and(|nested| Some(nested) == order));
            orders[(left.compare(&right) as i8 + 1) as usize] += 1;
        }
    }
    assert!(orders.iter().all(|&count| count > 1000) && decided > 6000, "{orders:?}, {decided}");
}

#[test]
fn a_dot_product_that_underflows_tells_no_exit() {
    let direction = Vec3::new(1e-170, 0.0, 0.0);
    let ray = Ray { origin: Vec3::ZERO, direction };
    let [inner, outer] = [1e-170, 1.5e-170].map(|radius| Surface::Sphere(SphereRecord::new(Vec3::ZERO, radius)));
    assert_eq!(inner.is_left_at(1.0, &ray), None);
    assert_eq!(compare(&ray, [&inner, &outer], [1.0, 1.5]), Some(Ordering::Less));
}
