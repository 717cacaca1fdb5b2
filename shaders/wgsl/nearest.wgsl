// The nearest hit of a ray over all objects; twin of cpu/src/accel/every_object.rs.

// Nearest: the nearest surface so far. Of two at the same lambda, the later object of the file counts.
struct Nearest {
    some: bool,
    lambda: real,
    order: u32,
    is_cylinder: bool,
    index: u32,
    part: u32,
}

// ClosestHit::update
fn nearest_is_beaten_by(nearest: Nearest, lambda: real, order: u32) -> bool {
    return !nearest.some || lambda < nearest.lambda || (lambda == nearest.lambda && order > nearest.order);
}

// Option<(Hit, MaterialId)>, and how it was found, which only the debug views read.
struct SurfaceHit {
    some: bool,
    hit: Hit,
    material: u32,
    lambda: real,
    order: u32,
    part: u32,
}

// nearest: where the ray first meets an object, and of what material.
fn nearest_hit(ray: Ray) -> SurfaceHit {
    var nearest: Nearest;
    if has_spheres {
        for (var index = 0u; index < picture.sphere_count; index++) {
            let root = sphere_intersect(sphere_load(spheres[index]), ray);
            let order = spheres[index].order;
            if root.some && nearest_is_beaten_by(nearest, root.lambda, order) {
                nearest = Nearest(true, root.lambda, order, false, index, SIDE);
            }
        }
    }
    if has_cylinders {
        for (var index = 0u; index < picture.cylinder_count; index++) {
            let root = cylinder_intersect(cylinder_load(cylinders[index]), ray);
            let order = cylinders[index].order;
            if root.some && nearest_is_beaten_by(nearest, root.lambda, order) {
                nearest = Nearest(true, root.lambda, order, true, index, root.part);
            }
        }
    }
    var surface: SurfaceHit;
    if !nearest.some {
        return surface;
    }
    let point = ray_at(ray, nearest.lambda);
    if has_spheres && !nearest.is_cylinder {
        let outward = sphere_outward(sphere_load(spheres[nearest.index]), point);
        let hit = hit_facing(ray.direction, point, outward);
        let material = spheres[nearest.index].material;
        surface = SurfaceHit(true, hit, material, nearest.lambda, nearest.order, nearest.part);
    }
    if has_cylinders && nearest.is_cylinder {
        let outward = cylinder_outward(cylinder_load(cylinders[nearest.index]), nearest.part, point);
        let hit = hit_facing(ray.direction, point, outward);
        let material = cylinders[nearest.index].material;
        surface = SurfaceHit(true, hit, material, nearest.lambda, nearest.order, nearest.part);
    }
    return surface;
}
