// The closest hit of a ray among all objects; twin of cpu/src/accel/every_object.rs.

// Returns the closest hit of the ray, found by a loop over all objects.
fn intersect_every_object(ray: Ray) -> ClosestHit {
    var closest: ClosestHit;
    if has_spheres {
        for (var index = 0u; index < picture.sphere_count; index++) {
            closest = intersect_sphere(closest, ray, index);
        }
    }
    if has_cylinders {
        for (var index = 0u; index < picture.cylinder_count; index++) {
            closest = intersect_cylinder(closest, ray, index);
        }
    }
    return closest;
}
