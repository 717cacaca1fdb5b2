//! Tests hits with sides and caps, and their normals, at places where they are known.

use crate::geometry::cylinder::*;

fn upright() -> CylinderRecord {
    CylinderRecord::new(Vec3::ZERO, 1.0, Vec3::new(0.0, 4.0, 0.0))
}

fn ray(origin: [f64; 3], direction: [f64; 3]) -> Ray {
    Ray { origin: origin.into(), direction: direction.into() }
}

#[test]
fn the_normal_of_the_side_starts_at_the_axis() {
    let record = CylinderRecord::new(Vec3::new(5.0, 6.0, 7.0), 2.0, Vec3::new(0.0, 4.0, 0.0));
    assert_eq!(record.outward(CylinderPart::Side, Vec3::new(7.0, 6.5, 7.0)), Vec3::new(2.0, 0.0, 0.0));
    assert_eq!(record.outward(CylinderPart::Top, Vec3::new(5.0, 8.0, 7.0)), Vec3::new(0.0, 1.0, 0.0));
    assert_eq!(record.outward(CylinderPart::Bottom, Vec3::new(5.0, 4.0, 7.0)), Vec3::new(0.0, -1.0, 0.0));
}

#[test]
fn the_record_holds_the_derived_values() {
    let record = CylinderRecord::new(Vec3::ONE, 3.0, Vec3::new(0.0, 0.0, -4.0));
    assert_eq!(record.axis, Vec3::new(0.0, 0.0, -1.0));
    assert_eq!((record.half_height, record.radius_squared), (2.0, 9.0));
    assert_eq!((record.top, record.bottom), (Vec3::new(1.0, 1.0, -1.0), Vec3::new(1.0, 1.0, 3.0)));
}

#[test]
fn the_side_is_met_from_outside_and_inside() {
    let hit = upright().intersect(&ray([0.0, 0.0, -3.0], [0.0, 0.0, 1.0]));
    assert_eq!(hit, Some((2.0, CylinderPart::Side)));
    let hit = upright().intersect(&ray([0.0, 0.0, 0.0], [0.0, 0.0, 1.0]));
    assert_eq!(hit, Some((1.0, CylinderPart::Side)));
}

#[test]
fn bases_are_met_from_outside_and_inside() {
    let hit = upright().intersect(&ray([0.5, 5.0, 0.0], [0.0, -1.0, 0.0]));
    assert_eq!(hit, Some((3.0, CylinderPart::Top)));
    let hit = upright().intersect(&ray([0.5, -5.0, 0.0], [0.0, 1.0, 0.0]));
    assert_eq!(hit, Some((3.0, CylinderPart::Bottom)));
    let hit = upright().intersect(&ray([0.0, 0.0, 0.0], [0.1, 1.0, 0.0]));
    assert_eq!(hit, Some((2.0, CylinderPart::Top)));
}

#[test]
fn beyond_the_rim_nothing_is_met() {
    assert_eq!(upright().intersect(&ray([1.1, 5.0, 0.0], [0.0, -1.0, 0.0])), None);
    assert_eq!(upright().intersect(&ray([0.0, 2.1, -3.0], [0.0, 0.0, 1.0])), None);
    assert_eq!(upright().intersect(&ray([0.0, 0.0, 3.0], [0.0, 0.0, 1.0])), None);
}

#[test]
fn a_ray_from_above_the_top_meets_the_base() {
    let hit = upright().intersect(&ray([0.0, 4.0, -3.0], [0.0, -1.0, 1.0]));
    assert_eq!(hit, Some((2.0, CylinderPart::Side)), "on the rim the cap is not nearer than the side");
    // The ray enters the infinite cylinder above the top cap. So the smaller root does not count, and the cap is hit.
    let hit = upright().intersect(&ray([0.0, 4.5, -3.0], [0.0, -1.0, 1.0]));
    assert_eq!(hit, Some((2.5, CylinderPart::Top)));
}

#[test]
fn a_ray_along_the_axis_meets_only_bases() {
    // The roots for the side are 0 / 0, but the cap still counts.
    let hit = upright().intersect(&ray([0.0, 5.0, 0.0], [0.0, -2.0, 0.0]));
    assert_eq!(hit, Some((1.5, CylinderPart::Top)));
    let hit = upright().intersect(&ray([0.0, 1.0, 0.0], [0.0, 2.0, 0.0]));
    assert_eq!(hit, Some((0.5, CylinderPart::Top)));
}

#[test]
fn a_null_direction_meets_nothing() {
    assert_eq!(upright().intersect(&ray([0.0, 1.0, 0.0], [0.0; 3])), None);
}

#[test]
fn a_ray_parallel_to_the_bases_skips_them() {
    let hit = upright().intersect(&ray([0.0, 2.0, -3.0], [0.0, 0.0, 1.0]));
    assert_eq!(hit, Some((2.0, CylinderPart::Side)));
}

#[test]
fn the_sides_normal_is_as_long_as_the_radius() {
    let record = CylinderRecord::new(Vec3::ZERO, 2.0, Vec3::new(0.0, 4.0, 0.0));
    assert_eq!(record.outward(CylinderPart::Side, Vec3::new(2.0, 1.5, 0.0)), Vec3::new(2.0, 0.0, 0.0));
    assert_eq!(record.outward(CylinderPart::Top, Vec3::ONE), Vec3::new(0.0, 1.0, 0.0));
    assert_eq!(record.outward(CylinderPart::Bottom, Vec3::ONE), Vec3::new(0.0, -1.0, 0.0));
}
