// The closest hit of a ray among all objects; twin of cpu/src/accel/every_object.rs.

// ClosestHit: the closest hit found so far.
struct ClosestHit {
    some: bool,
    lambda: real,
    order: u32,
    is_cylinder: bool,
    index: u32,
    part: u32,
}

// ClosestHit::update: returns whether a hit at `lambda` replaces the closest hit found so far.
fn is_closer(closest: ClosestHit, lambda: real, order: u32) -> bool {
    return !closest.some || tie_is_closer(lambda, order, closest.lambda, closest.order);
}

// The surface that a ray hits first, if `some` is true. Only steps.wgsl and debug views read `lambda`, `order` and
// `part`.
struct SurfaceHit {
    some: bool,
    hit: Hit,
    material: u32,
    lambda: real,
    order: u32,
    part: u32,
}

// intersect_every_object: returns the closest hit of the ray, found by a loop over all objects.
fn closest_hit(ray: Ray) -> SurfaceHit {
    var closest: ClosestHit;
    if has_spheres {
        for (var index = 0u; index < picture.sphere_count; index++) {
            let root = sphere_intersect(sphere_load(spheres[index]), ray);
            let order = spheres[index].order;
            if root.some && is_closer(closest, root.lambda, order) {
                closest = ClosestHit(true, root.lambda, order, false, index, SIDE);
            }
        }
    }
    if has_cylinders {
        for (var index = 0u; index < picture.cylinder_count; index++) {
            let root = cylinder_intersect(cylinder_load(cylinders[index]), ray);
            let order = cylinders[index].order;
            if root.some && is_closer(closest, root.lambda, order) {
                closest = ClosestHit(true, root.lambda, order, true, index, root.part);
            }
        }
    }
    var surface: SurfaceHit;
    if !closest.some {
        return surface;
    }
    let point = ray_at(ray, closest.lambda);
    if has_spheres && !closest.is_cylinder {
        let outward = sphere_outward(sphere_load(spheres[closest.index]), point);
        let hit = hit_facing(ray.direction, point, outward);
        let material = spheres[closest.index].material;
        surface = SurfaceHit(true, hit, material, closest.lambda, closest.order, closest.part);
    }
    if has_cylinders && closest.is_cylinder {
        let outward = cylinder_outward(cylinder_load(cylinders[closest.index]), closest.part, point);
        let hit = hit_facing(ray.direction, point, outward);
        let material = cylinders[closest.index].material;
        surface = SurfaceHit(true, hit, material, closest.lambda, closest.order, closest.part);
    }
    return surface;
}
