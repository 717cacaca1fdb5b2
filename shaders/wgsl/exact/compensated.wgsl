// The root of ray and sphere that does not cancel; twin of cpu/src/exact/sphere_compensated.rs.

// difference_of_squares: the difference of two squares with its error added, and their sum.
struct SquareTerms {
    difference: real,
    sum: real,
}

// difference_of_squares: returns `|C - O|^2 - r^2`, nearly as accurate as if it were rounded once, and
// `|C - O|^2 + r^2`.
fn exact_square_terms(sphere: SphereRecord, origin: vec3<real>) -> SquareTerms {
    let x = exact_two_sum(sphere.center.x, -origin.x);
    let y = exact_two_sum(sphere.center.y, -origin.y);
    let z = exact_two_sum(sphere.center.z, -origin.z);
    let xx = exact_two_product(x.sum, x.sum);
    let yy = exact_two_product(y.sum, y.sum);
    let zz = exact_two_product(z.sum, z.sum);
    let rr = exact_two_product(sphere.radius, sphere.radius);
    let first = exact_two_sum(xx.sum, yy.sum);
    let second = exact_two_sum(first.sum, zz.sum);
    let third = exact_two_sum(second.sum, -rr.sum);
    let across = exact_mul_add(x.sum, x.error, exact_mul_add(y.sum, y.error, z.sum * z.error));
    let sums = first.error + second.error + third.error;
    let products = (xx.error + yy.error) + (zz.error - rr.error);
    return SquareTerms(third.sum + (sums + products + (across + across)), second.sum + rr.sum);
}

// compensated: returns the hit of a ray that starts outside the sphere and goes towards the centre, or starts inside
// and goes away from it. For any other ray the result is uncertain; a miss is never certain.
fn exact_sphere_compensated(sphere: SphereRecord, ray: Ray) -> Decision {
    let a = vec3_dot(ray.direction, ray.direction);
    let quadratic = sphere_quadratic(sphere_seen_from(sphere, ray.origin), ray.direction, a);
    let root = sqrt(quadratic.discriminant);
    let terms = exact_square_terms(sphere, ray.origin);
    let denominator = abs(quadratic.h) + root;
    let lambda = abs(terms.difference) / denominator;
    let size = a * terms.sum;
    // The condition limit 4,096, and the least `c`, 64 times 2^-53 of the squares.
    let accurate = size + ERROR_UNDERFLOW < root * denominator * real(4096.0) && size < ERROR_OVERFLOW;
    let c_is_large = terms.sum * real(7.105427357601002e-15) + ERROR_UNDERFLOW < abs(terms.difference);
    let ahead = real(0.0) < quadratic.h * terms.difference;
    if exact_in_scale(a) && accurate && c_is_large && ahead && exact_sphere_limits().most <= lambda {
        return decision_hit(lambda, SIDE);
    }
    return decision_uncertain();
}
