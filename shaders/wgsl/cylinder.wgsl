// Intersects a ray with a closed cylinder; twin of cpu/src/geometry/cylinder.rs, which has the equations.
//
// As in sphere.wgsl, the functions have one exit and use select, & and |.

// CylinderRecord: a cylinder, and the values that every intersection with it needs, computed once.
struct CylinderRecord {
    center: vec3<real>,
    axis: vec3<real>,
    top: vec3<real>,
    bottom: vec3<real>,
    radius: real,
    radius_squared: real,
    half_height: real,
}

// CylinderPart: the part of a cylinder that a ray hits.
const SIDE: u32 = 0u;
const TOP: u32 = 1u;
const BOTTOM: u32 = 2u;

// CylinderRecord::new: returns the record of a cylinder. The length of `axis` is the height.
fn cylinder_new(center: vec3<real>, radius: real, axis: vec3<real>) -> CylinderRecord {
    let unit = vec3_unit_and_length(axis);
    return cylinder_with_unit_axis(center, radius, unit.direction, unit.length / real(2.0));
}

// CylinderRecord::with_unit_axis: returns the record of a cylinder, for an `axis` of length one.
fn cylinder_with_unit_axis(center: vec3<real>, radius: real, axis: vec3<real>, half_height: real) -> CylinderRecord {
    let to_cap = axis * half_height;
    return CylinderRecord(center, axis, center + to_cap, center - to_cap, radius, radius * radius, half_height);
}

// CylinderView: the values that all rays from one origin share.
struct CylinderView {
    // The vector from the centre to the origin, perpendicular to the axis.
    r_c: vec3<real>,
    // `r_c.r_c - r^2`: negative inside the infinite cylinder.
    c: real,
}

// CylinderRecord::seen_from: returns the view of the cylinder for rays from `origin`.
fn cylinder_seen_from(cylinder: CylinderRecord, origin: vec3<real>) -> CylinderView {
    let r_c = vec3_perpendicular_to(origin - cylinder.center, cylinder.axis);
    return CylinderView(r_c, vec3_dot(r_c, r_c) - cylinder.radius_squared);
}

struct CylinderQuadratic {
    a: real,
    h: real,
    discriminant: real,
}

// CylinderRecord::quadratic: returns `a`, half of `b` and a quarter of the discriminant for the infinite cylinder.
fn cylinder_quadratic(cylinder: CylinderRecord, view: CylinderView, along: vec3<real>) -> CylinderQuadratic {
    let direction = vec3_perpendicular_to(along, cylinder.axis);
    let a = vec3_dot(direction, direction);
    let h = vec3_dot(view.r_c, direction);
    return CylinderQuadratic(a, h, h * h - a * view.c);
}

// CylinderRecord::within_height: returns whether the side's point at `lambda` lies between the caps.
fn cylinder_within_height(cylinder: CylinderRecord, ray: Ray, lambda: real) -> bool {
    return abs(vec3_dot(ray_at(ray, lambda) - cylinder.center, cylinder.axis)) <= cylinder.half_height;
}

// The part of CylinderRecord::intersect for the side. Returns the smaller root that is in range and between the caps,
// or otherwise the larger root. `some` tells whether one of the two roots counts. For a negative discriminant the
// result has no meaning, and the caller discards it.
fn cylinder_side(cylinder: CylinderRecord, ray: Ray, quadratic: CylinderQuadratic) -> Root {
    let root = sqrt(quadratic.discriminant);
    let near = (-quadratic.h - root) / quadratic.a;
    let far = (-quadratic.h + root) / quadratic.a;
    let near_counts = in_range(near) & cylinder_within_height(cylinder, ray, near);
    let far_counts = in_range(far) & cylinder_within_height(cylinder, ray, far);
    return Root(near_counts | far_counts, select(far, near, near_counts));
}

// cap::intersect: returns the lambda at which the ray hits the cap around `center`, if it does. The limit 1e-8 is
// PARALLEL.
fn cylinder_cap(cylinder: CylinderRecord, ray: Ray, center: vec3<real>) -> Root {
    let slope = vec3_dot(ray.direction, cylinder.axis);
    let lambda = vec3_dot(center - ray.origin, cylinder.axis) / slope;
    let on_disc = vec3_length(ray_at(ray, lambda) - center) <= cylinder.radius;
    return Root(!(abs(slope) < real(1e-8)) & in_range(lambda) & on_disc, lambda);
}

// CylinderRecord::outward: returns the outward normal of `part` at `point`. Its length is the radius on the side, 1 on
// a cap.
fn cylinder_outward(cylinder: CylinderRecord, part: u32, point: vec3<real>) -> vec3<real> {
    let side = vec3_perpendicular_to(point - cylinder.center, cylinder.axis);
    let cap = select(-cylinder.axis, cylinder.axis, part == TOP);
    return select(cap, side, part == SIDE);
}

// Option<(T, CylinderPart)>: the lambda and the part of a hit, if there is one.
struct CylinderRoot {
    some: bool,
    lambda: real,
    part: u32,
}

// CylinderRecord::intersect: returns the closest hit of the side, the top cap and the bottom cap.
fn cylinder_intersect(cylinder: CylinderRecord, ray: Ray) -> CylinderRoot {
    let view = cylinder_seen_from(cylinder, ray.origin);
    let quadratic = cylinder_quadratic(cylinder, view, ray.direction);
    let side = cylinder_side(cylinder, ray, quadratic);
    let some = !(quadratic.discriminant < real(0.0)) & side.some;
    return cylinder_with_caps(cylinder, ray, Root(some, side.lambda));
}

// The part of CylinderRecord::intersect after the side. Returns the closest hit of the side, the top cap and the bottom
// cap. Of hits at equal lambdas, the first in this order counts.
fn cylinder_with_caps(cylinder: CylinderRecord, ray: Ray, side: Root) -> CylinderRoot {
    let top = cylinder_cap(cylinder, ray, cylinder.top);
    let bottom = cylinder_cap(cylinder, ray, cylinder.bottom);
    let closest = cylinder_closer(CylinderRoot(side.some, side.lambda, SIDE), top, TOP);
    return cylinder_closer(closest, bottom, BOTTOM);
}

// A step of CylinderRecord::intersect: returns the closer of `closest` and the hit `later` on the cap `part`. Either
// may be missing. At equal lambdas `closest` counts.
fn cylinder_closer(closest: CylinderRoot, later: Root, part: u32) -> CylinderRoot {
    let replaces = later.some & (!closest.some | tie_later_cap_is_closer(later.lambda, closest.lambda));
    let lambda = select(closest.lambda, later.lambda, replaces);
    return CylinderRoot(closest.some | later.some, lambda, select(closest.part, part, replaces));
}
