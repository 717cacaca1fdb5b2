// The hit of ray and sphere by formulas in which less cancels; twin of cpu/src/exact/sphere_compensated.rs.

// difference_of_squares: the difference of two squares with its error added, and their sum.
struct SquareTerms {
    difference: real,
    sum: real,
}

// difference_of_squares: returns `|C - O|^2 - r^2`, nearly as accurate as if it were rounded once, and
// `|C - O|^2 + r^2`. `r_c` is `C - O` with its rounding error.
fn exact_square_terms(r_c: ExactDifference, radius: real) -> SquareTerms {
    let v = r_c.rounded;
    let xx = exact_two_product(v.x, v.x);
    let yy = exact_two_product(v.y, v.y);
    let zz = exact_two_product(v.z, v.z);
    let rr = exact_two_product(radius, radius);
    let first = exact_two_sum(xx.sum, yy.sum);
    let second = exact_two_sum(first.sum, zz.sum);
    let third = exact_two_sum(second.sum, -rr.sum);
    let across = exact_mul_add(v.x, r_c.error.x, exact_mul_add(v.y, r_c.error.y, v.z * r_c.error.z));
    let sums = first.error + second.error + third.error;
    let products = (xx.error + yy.error) + (zz.error - rr.error);
    return SquareTerms(third.sum + (sums + products + (across + across)), second.sum + rr.sum);
}

// Terms: the terms of a ray and a sphere from which both discriminants are computed.
struct ExactTerms {
    direction: vec3<real>,
    r_c: ExactDifference,
    radius_squared: real,
    a: real,
    h: real,
    c: real,
    squares: real,
    length: real,
}

// Terms::new: returns the terms.
fn exact_terms(sphere: SphereRecord, ray: Ray) -> ExactTerms {
    let a = vec3_dot(ray.direction, ray.direction);
    let r_c = exact_difference(sphere.center, ray.origin);
    let squares = exact_square_terms(r_c, sphere.radius);
    let h = vec3_dot(ray.direction, r_c.rounded);
    let length = sqrt(a * squares.sum);
    return ExactTerms(ray.direction, r_c, sphere.radius_squared, a, h, squares.difference, squares.sum, length);
}

// Discriminant: a discriminant, and the size of its terms.
struct ExactDiscriminant {
    value: real,
    size: real,
}

// Terms::near: returns `h^2 - a c`. The bound of the error of `c` is 64 times 2^-53 of the squares.
fn exact_near_discriminant(terms: ExactTerms) -> ExactDiscriminant {
    let error_of_c = terms.squares * real(7.105427357601002e-15);
    let size = abs(terms.h) * terms.length + terms.a * (abs(terms.c) + error_of_c);
    return ExactDiscriminant(terms.h * terms.h - terms.a * terms.c, size);
}

// Terms::far: returns `a r^2 - |(C - O) x d|^2`. The share is 2^-90.
fn exact_far_discriminant(terms: ExactTerms) -> ExactDiscriminant {
    let across = exact_cross(terms.r_c.rounded, terms.direction) + exact_cross(terms.r_c.error, terms.direction);
    let of_radius = terms.a * terms.radius_squared;
    let of_distance = vec3_dot(across, across);
    let size = of_radius + (of_distance + terms.a * terms.squares * real(8.077935669463161e-28));
    return ExactDiscriminant(of_radius - of_distance, size);
}

// Terms::hits: returns the hit with this discriminant, if rounding certainly has not changed it.
fn exact_terms_hit(terms: ExactTerms, discriminant: ExactDiscriminant) -> Decision {
    let limits = exact_sphere_limits();
    let size = discriminant.size;
    let root = sqrt(discriminant.value);
    let w = abs(terms.h) + root;
    if !exact_in_scale(terms.a) {
        return decision_uncertain();
    }
    let error = size * limits.error + ERROR_UNDERFLOW;
    if error < -discriminant.value {
        return decision_miss();
    }
    // The condition limit 4,096 of both, 64 times 2^-106 of the squares, and the reciprocal of 4,096 times 2^-53.
    let h_is_accurate = terms.length < w * real(4096.0);
    let root_is_accurate = error < discriminant.value && size < root * w * real(4096.0);
    let accurate = h_is_accurate && root_is_accurate && size < ERROR_OVERFLOW;
    let c = abs(terms.c);
    let small = c / w;
    let large = w / terms.a;
    let error_of_c = terms.squares * real(7.888609052210118e-31) + ERROR_UNDERFLOW;
    let c_is_accurate = error_of_c * real(2199023255552.0) < c;
    let zero = real(0.0);
    let sign = terms.h * terms.c;
    let small_hits = c_is_accurate && zero < sign && limits.most <= small && small < ERROR_OVERFLOW;
    let small_fails = (c_is_accurate && sign < zero) || c + error_of_c < w * limits.least;
    if accurate && small_fails && (terms.h < zero || w < terms.a * limits.least) {
        return decision_miss();
    }
    if accurate && small_hits {
        return decision_hit(small, SIDE);
    }
    if accurate && small_fails && zero < terms.h && limits.most <= large && large < ERROR_OVERFLOW {
        return decision_hit(large, SIDE);
    }
    return decision_uncertain();
}

// compensated: returns the hit, if rounding certainly has not changed it.
fn exact_sphere_compensated(sphere: SphereRecord, ray: Ray) -> Decision {
    let terms = exact_terms(sphere, ray);
    let near = exact_terms_hit(terms, exact_near_discriminant(terms));
    if near.certain {
        return near;
    }
    return exact_terms_hit(terms, exact_far_discriminant(terms));
}
