// Intersects a ray with a sphere; twin of cpu/src/geometry/sphere.rs, which has the equations.
//
// The functions have one exit and use select, & and |. Drivers that calculate on the CPU execute both sides of a
// branch, and with early returns a frame took 1.5 times as long on SwiftShader.

// SphereRecord: a sphere, and the square of its radius, computed once.
struct SphereRecord {
    center: vec3<real>,
    radius: real,
    radius_squared: real,
}

// SphereRecord::new: returns the record of a sphere.
fn sphere_new(center: vec3<real>, radius: real) -> SphereRecord {
    return SphereRecord(center, radius, radius * radius);
}

// SphereView: the values that all rays from one origin share.
struct SphereView {
    // The vector from the origin to the centre.
    r_c: vec3<real>,
    // `r_c.r_c - r^2`: negative inside the sphere.
    c: real,
}

// SphereRecord::seen_from: returns the view of the sphere for rays from `origin`.
fn sphere_seen_from(sphere: SphereRecord, origin: vec3<real>) -> SphereView {
    let r_c = sphere.center - origin;
    return SphereView(r_c, vec3_dot(r_c, r_c) - sphere.radius_squared);
}

struct SphereQuadratic {
    h: real,
    discriminant: real,
}

// SphereView::quadratic: returns half of `-b`, and a quarter of the discriminant; `a` is `direction . direction`.
fn sphere_quadratic(view: SphereView, direction: vec3<real>, a: real) -> SphereQuadratic {
    let h = vec3_dot(direction, view.r_c);
    return SphereQuadratic(h, h * h - a * view.c);
}

// The end of SphereRecord::intersect: the smaller root in range, else the larger root, and whether that one is in
// range. For a negative discriminant the result has no meaning, and the caller discards it.
fn sphere_first_root(a: real, h: real, discriminant: real) -> Root {
    let root = sqrt(discriminant);
    let near = (h - root) / a;
    let far = (h + root) / a;
    let lambda = select(far, near, in_range(near));
    return Root(in_range(lambda), lambda);
}

// SphereRecord::outward: returns the outward normal at `point`, of length one.
fn sphere_outward(sphere: SphereRecord, point: vec3<real>) -> vec3<real> {
    return (point - sphere.center) / sphere.radius;
}

// SphereRecord::intersect: returns the lambda at which the ray hits the sphere, if it does.
fn sphere_intersect(sphere: SphereRecord, ray: Ray) -> Root {
    let a = vec3_dot(ray.direction, ray.direction);
    let quadratic = sphere_quadratic(sphere_seen_from(sphere, ray.origin), ray.direction, a);
    let root = sphere_first_root(a, quadratic.h, quadratic.discriminant);
    return Root(!(quadratic.discriminant < real(0.0)) & root.some, root.lambda);
}
