// Ray against sphere; twin of cpu/src/sphere.rs, which has the equations.

// SphereRecord: a sphere with what its rays need computed once.
struct SphereRecord {
    center: vec3<real>,
    radius: real,
    radius_squared: real,
}

// SphereRecord::new
fn sphere_new(center: vec3<real>, radius: real) -> SphereRecord {
    return SphereRecord(center, radius, radius * radius);
}

struct SphereQuadratic {
    h: real,
    discriminant: real,
}

// SphereRecord::quadratic: half of `-b`, and a quarter of the discriminant; `a` is `direction . direction`.
fn sphere_quadratic(sphere: SphereRecord, ray: Ray, a: real) -> SphereQuadratic {
    let r_c = sphere.center - ray.origin;
    let h = vec3_dot(ray.direction, r_c);
    let c = vec3_dot(r_c, r_c) - sphere.radius_squared;
    return SphereQuadratic(h, h * h - a * c);
}

// SphereRecord::outward: the normal at `point` that leaves the sphere, of length one.
fn sphere_outward(sphere: SphereRecord, point: vec3<real>) -> vec3<real> {
    return (point - sphere.center) / sphere.radius;
}

// SphereRecord::intersect: the smaller root that is in range, else the larger; none when neither is.
fn sphere_intersect(sphere: SphereRecord, ray: Ray) -> Root {
    let a = vec3_dot(ray.direction, ray.direction);
    let quadratic = sphere_quadratic(sphere, ray, a);
    if quadratic.discriminant < real(0.0) {
        return root_none();
    }
    let root = sqrt(quadratic.discriminant);
    let near = (quadratic.h - root) / a;
    if in_range(near) {
        return Root(true, near);
    }
    let far = (quadratic.h + root) / a;
    return root_when(in_range(far), far);
}
