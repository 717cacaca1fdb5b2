//! Tests hits with sides and caps, and their normals, at places where they are known.

use crate::geometry::cylinder::*;

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
    assert_eq!(CylinderRecord::with_unit_axis(Vec3::ONE, 3.0, Vec3::new(0.0, 0.0, -1.0), 2.0), record);
}

#[test]
fn the_quadratic_has_the_two_roots_of_the_infinite_cylinder_and_points_beyond_the_caps_are_known() {
    let upright = CylinderRecord::new(Vec3::ZERO, 1.0, Vec3::new(0.0, 4.0, 0.0));
    // `(3 + lambda)^2 = 1`: the roots are -4 and -2, or `-h -+ 1`.
    let view = upright.seen_from(Vec3::new(3.0, 5.0, 0.0));
    assert_eq!(upright.quadratic(&view, Vec3::new(1.0, 2.0, 0.0)), (1.0, 3.0, 1.0));
    let down = Ray { origin: Vec3::new(0.0, 5.0, 0.0), direction: Vec3::new(0.0, -1.0, 0.0) };
    let within = [2.9, 3.0, 5.0, 7.0, 7.1].map(|lambda| upright.within_height(&down, lambda));
    assert_eq!(within, [false, true, true, true, false]);
}

#[test]
fn rays_hit_sides_and_caps_where_they_should() {
    use CylinderPart::{Bottom, Side, Top};

    let upright = CylinderRecord::new(Vec3::ZERO, 1.0, Vec3::new(0.0, 4.0, 0.0));
    for (what, origin, direction, expected) in [
        ("the side from outside", [0.0, 0.0, -3.0], [0.0, 0.0, 1.0], Some((2.0, Side))),
        ("the side from inside", [0.0, 0.0, 0.0], [0.0, 0.0, 1.0], Some((1.0, Side))),
        ("the top from outside", [0.5, 5.0, 0.0], [0.0, -1.0, 0.0], Some((3.0, Top))),
        ("the bottom from outside", [0.5, -5.0, 0.0], [0.0, 1.0, 0.0], Some((3.0, Bottom))),
        ("the top from inside", [0.0, 0.0, 0.0], [0.1, 1.0, 0.0], Some((2.0, Top))),
        ("beyond the rim of the top", [1.1, 5.0, 0.0], [0.0, -1.0, 0.0], None),
        ("above the top", [0.0, 2.1, -3.0], [0.0, 0.0, 1.0], None),
        ("behind", [0.0, 0.0, 3.0], [0.0, 0.0, 1.0], None),
        ("on the rim the cap is not nearer than the side", [0.0, 4.0, -3.0], [0.0, -1.0, 1.0], Some((2.0, Side))),
        // The ray enters the infinite cylinder above the top cap. So the smaller root does not count.
        ("the top from above, at an angle", [0.0, 4.5, -3.0], [0.0, -1.0, 1.0], Some((2.5, Top))),
        // The roots for the side are 0 / 0, but the cap still counts.
        ("along the axis from outside", [0.0, 5.0, 0.0], [0.0, -2.0, 0.0], Some((1.5, Top))),
        ("along the axis from inside", [0.0, 1.0, 0.0], [0.0, 2.0, 0.0], Some((0.5, Top))),
        ("a null direction", [0.0, 1.0, 0.0], [0.0; 3], None),
        ("in the plane of the top", [0.0, 2.0, -3.0], [0.0, 0.0, 1.0], Some((2.0, Side))),
    ] {
        let ray = Ray { origin: origin.into(), direction: direction.into() };
        assert_eq!(upright.intersect(&ray), expected, "{what}");
    }
}
