// The closest hit of a ray so far, and the surface there; twin of cpu/src/accel/closest_hit.rs.

// Whether a call of `closest_hit` ended early, because it took too many iterations. Only hierarchy.wgsl sets it. The
// kernels then write UNWRITTEN, and the program reports an error.
var<private> closest_hit_gave_up: bool;

// ClosestHit: the closest hit found so far.
struct ClosestHit {
    some: bool,
    lambda: real,
    order: u32,
    is_cylinder: bool,
    index: u32,
    part: u32,
}

// ClosestHit::update: returns whether a hit at `lambda` on `part` replaces the closest hit found so far.
fn is_closer(closest: ClosestHit, lambda: real, order: u32, part: u32) -> bool {
    let closest_rank = tie_rank(closest.order, closest.part != SIDE);
    let rank = tie_rank(order, part != SIDE);
    return !closest.some | tie_is_closer(lambda, rank, closest.lambda, closest_rank);
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

// Intersects the ray with the sphere at `index`, and updates `closest`.
fn intersect_sphere(closest: ClosestHit, ray: Ray, index: u32) -> ClosestHit {
    let placed = spheres[index];
    let root = sphere_intersect(sphere_load(placed), ray);
    let order = placed.order;
    var result = closest;
    if root.some & is_closer(closest, root.lambda, order, SIDE) {
        result = ClosestHit(true, root.lambda, order, false, index, SIDE);
    }
    return result;
}

// Intersects the ray with the cylinder at `index`, and updates `closest`.
fn intersect_cylinder(closest: ClosestHit, ray: Ray, index: u32) -> ClosestHit {
    let placed = cylinders[index];
    let root = cylinder_intersect(cylinder_load(placed), ray);
    let order = placed.order;
    var result = closest;
    if root.some & is_closer(closest, root.lambda, order, root.part) {
        result = ClosestHit(true, root.lambda, order, true, index, root.part);
    }
    return result;
}

// Returns the surface at the closest hit. After a miss `some` is false, and the other fields have no meaning.
fn surface_at(closest: ClosestHit, ray: Ray) -> SurfaceHit {
    let point = ray_at(ray, closest.lambda);
    var outward: vec3<real>;
    var material: u32;
    if has_spheres && !closest.is_cylinder {
        outward = sphere_outward(sphere_load(spheres[closest.index]), point);
        material = spheres[closest.index].material;
    }
    if has_cylinders && closest.is_cylinder {
        outward = cylinder_outward(cylinder_load(cylinders[closest.index]), closest.part, point);
        material = cylinders[closest.index].material;
    }
    let hit = hit_facing(ray.direction, point, outward);
    return SurfaceHit(closest.some, hit, material, closest.lambda, closest.order, closest.part);
}
