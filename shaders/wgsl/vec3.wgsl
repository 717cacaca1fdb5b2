// Three-component vectors, for points, directions and colours alike; twin of cpu/src/math/vec3.rs.
//
// The formulas are written out, because WGSL lets the driver choose the order of operations inside its own dot, cross
// and length. Here the bits of the result depend on that order.

// Vec3::dot: returns the scalar product, summed from left to right.
fn vec3_dot(a: vec3<real>, b: vec3<real>) -> real {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

// Vec3::length: returns the Euclidean length.
fn vec3_length(v: vec3<real>) -> real {
    return sqrt(vec3_dot(v, v));
}

// Vec3::unit: returns the vector of length one in the same direction.
fn vec3_unit(v: vec3<real>) -> vec3<real> {
    return v / vec3_length(v);
}

// Vec3::perpendicular_to: returns the component of `v` perpendicular to the unit vector `axis`.
fn vec3_perpendicular_to(v: vec3<real>, axis: vec3<real>) -> vec3<real> {
    return v - axis * vec3_dot(v, axis);
}

// Vec3::is_negligible: returns whether every component is smaller than 1e-8 in magnitude.
fn vec3_is_negligible(v: vec3<real>) -> bool {
    let limit = real(1e-8);
    return (abs(v.x) < limit) & (abs(v.y) < limit) & (abs(v.z) < limit);
}
