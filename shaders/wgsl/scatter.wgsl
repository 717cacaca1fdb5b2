// The directions in which surfaces scatter rays; twin of scatter.rs, reflection.rs and refraction.rs in
// cpu/src/materials. The caller gives the random vectors.

// scatter::scatter_around for a matte surface: returns the sum of the normal and a random vector, or the normal alone
// if the sum is negligible.
fn scatter_matte(normal: vec3<real>, vector: vec3<real>) -> vec3<real> {
    let direction = normal + vector;
    return select(direction, normal, vec3_is_negligible(direction));
}

// reflection::reflect: returns the mirror image of `direction` in a surface with this normal.
fn scatter_reflect(direction: vec3<real>, normal: vec3<real>) -> vec3<real> {
    return direction - normal * (vec3_dot(direction, normal) * real(2.0));
}

// reflection::mirror: returns the direction, of length one, in which a metal without diffusion scatters a ray.
fn scatter_mirror(direction: vec3<real>, normal: vec3<real>) -> vec3<real> {
    return vec3_unit(scatter_reflect(direction, normal));
}

// Returns the sum of the mirror direction of a metal surface and a random vector.
fn scatter_metal(direction: vec3<real>, normal: vec3<real>, vector: vec3<real>) -> vec3<real> {
    return scatter_mirror(direction, normal) + vector;
}

// PreparedMaterial::index_ratios: returns the ratio of indices of a surface with this refractive index: `1 / index` if
// the ray comes from outside (`front`), and `index` otherwise.
fn scatter_index_ratio(index: real, front: bool) -> real {
    return select(index, real(1.0) / index, front);
}

// refraction::refract: returns the direction refracted by Snell's law, or reflected beyond the critical angle. `ratio`
// is the result of `scatter_index_ratio`.
fn scatter_refract(direction: vec3<real>, normal: vec3<real>, ratio: real) -> vec3<real> {
    let one = real(1.0);
    let u = vec3_unit(direction);
    let product = -vec3_dot(u, normal);
    let cos = select(one, product, product < one);
    let sin = sqrt(one - cos * cos);
    let reflected = scatter_reflect(u, normal);
    let p = (u + normal * cos) * ratio;
    let refracted = p - normal * sqrt(abs(one - vec3_dot(p, p)));
    let beyond = one < ratio * sin;
    return select(refracted, reflected, beyond);
}
