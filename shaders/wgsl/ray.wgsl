// Rays, and their hits on surfaces; twin of cpu/src/geometry/ray.rs.

// Ray: a half-line from `origin` along `direction`, which need not have length one.
struct Ray {
    origin: vec3<real>,
    direction: vec3<real>,
}

// Ray::at: returns the point `origin + direction lambda`.
fn ray_at(ray: Ray, lambda: real) -> vec3<real> {
    return ray.origin + ray.direction * lambda;
}

// in_range: returns whether a hit at `lambda` counts: it is at least LAMBDA_MIN, which is 1e-3. NaN never counts.
fn in_range(lambda: real) -> bool {
    return real(1e-3) <= lambda;
}

// Option<T>: the lambda of a hit, if `some` is true. Otherwise `lambda` has no meaning.
struct Root {
    some: bool,
    lambda: real,
}

// Hit: a point where a ray hits a surface, and the normal on the side from which the ray comes. `front` tells whether
// that side is the outside.
struct Hit {
    point: vec3<real>,
    normal: vec3<real>,
    front: bool,
}

// Hit::facing: returns the hit at `point` of a ray along `direction`, given the normal that points `outward`.
fn hit_facing(direction: vec3<real>, point: vec3<real>, outward: vec3<real>) -> Hit {
    let front = vec3_dot(direction, outward) < real(0.0);
    return Hit(point, select(-outward, outward, front), front);
}
