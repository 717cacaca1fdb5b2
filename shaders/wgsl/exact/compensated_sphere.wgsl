// The hit of ray and sphere by formulas in which less cancels; twin of cpu/src/exact/sphere_compensated.rs.

// Terms: the terms of a ray and a sphere from which both discriminants are computed.
struct ExactTerms {
    direction: vec3<real>,
    r_c: ExactVector,
    radius_squared: real,
    quadratic: CompensatedQuadratic,
}

// Terms::new: returns the terms.
fn exact_terms(sphere: SphereRecord, ray: Ray) -> ExactTerms {
    let a = vec3_dot(ray.direction, ray.direction);
    let r_c = exact_difference(sphere.center, ray.origin);
    let squares = exact_difference_of_squares(r_c, exact_two_product(sphere.radius, sphere.radius));
    let h = vec3_dot(ray.direction, r_c.rounded);
    let quadratic = CompensatedQuadratic(a, h, squares.difference, squares.sum, sqrt(a * squares.sum));
    return ExactTerms(ray.direction, r_c, sphere.radius_squared, quadratic);
}

// Terms::far: returns `a r^2 - |(C - O) x d|^2`. The share is 2^-90.
fn exact_far_discriminant(terms: ExactTerms) -> CompensatedDiscriminant {
    let a = terms.quadratic.a;
    let across = exact_cross(terms.r_c.rounded, terms.direction) + exact_cross(terms.r_c.error, terms.direction);
    let of_radius = a * terms.radius_squared;
    let of_distance = vec3_dot(across, across);
    let size = of_radius + (of_distance + a * terms.quadratic.size_of_c * real(8.077935669463161e-28));
    return CompensatedDiscriminant(of_radius - of_distance, size);
}

// Terms::hit: returns the hit with this discriminant, if rounding certainly has not changed it.
fn exact_terms_hit(terms: ExactTerms, discriminant: CompensatedDiscriminant) -> Decision {
    let quadratic = terms.quadratic;
    let roots = compensated_roots(quadratic, discriminant);
    if !exact_in_scale(quadratic.a) {
        return decision_uncertain();
    }
    if roots.misses || (roots.accurate && roots.small_fails && roots.large_fails) {
        return decision_miss();
    }
    let small = abs(quadratic.c) / roots.w;
    if roots.accurate && roots.small_is_ahead && compensated_is_in_range(small) {
        return decision_hit(small, SIDE);
    }
    let large = roots.w / quadratic.a;
    if roots.accurate && roots.small_fails && real(0.0) <= quadratic.h && compensated_is_in_range(large) {
        return decision_hit(large, SIDE);
    }
    return decision_uncertain();
}

// compensated: returns the hit, if rounding certainly has not changed it.
fn exact_sphere_compensated(sphere: SphereRecord, ray: Ray) -> Decision {
    let terms = exact_terms(sphere, ray);
    if exact_in_scale(terms.quadratic.a) && compensated_leaves(terms.quadratic) {
        return decision_miss();
    }
    let near = exact_terms_hit(terms, compensated_near(terms.quadratic));
    if near.certain {
        return near;
    }
    return exact_terms_hit(terms, exact_far_discriminant(terms));
}
