//! Tests of the oracle with hits that are known without a computation.

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
    assert_eq!(nearest(&ray(0.0, -1.0 - LAMBDA_MIN)).map(|hit| hit.0 < 1.0), Some(false), "1.001 is nearer than 1e-3");
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
