// The roots of a quadratic by formulas in which less cancels; twin of cpu/src/exact/compensated_roots.rs.

// difference_of_squares: `c` with its error added, and the size of its terms. They are the difference and the sum of
// the same squares.
struct SquareTerms {
    difference: real,
    sum: real,
}

// Quadratic: the coefficients of `a lambda^2 - 2 h lambda + c`, and the sizes of the terms of `c` and of `h`.
struct CompensatedQuadratic {
    a: real,
    h: real,
    c: real,
    size_of_c: real,
    size_of_h: real,
}

// Discriminant: the discriminant, and the size of its terms.
struct CompensatedDiscriminant {
    value: real,
    size: real,
}

// Roots: what is certain about the two roots. The magnitude of the large root is `w / a`, that of the small root is
// `|c| / w`.
struct CompensatedRoots {
    w: real,
    // The size of the terms of `w`, relative to `w`.
    condition: real,
    error_of_c: real,
    misses: bool,
    accurate: bool,
    small_is_ahead: bool,
    small_fails: bool,
    large_fails: bool,
}

// difference_of_squares: returns `|q|^2 - s`, nearly as accurate as if it were rounded once, and `|q|^2 + s`. `q` and
// `s` are given rounded, each with its error.
fn exact_difference_of_squares(q: ExactVector, s: ExactSum) -> SquareTerms {
    let v = q.rounded;
    let xx = exact_two_product(v.x, v.x);
    let yy = exact_two_product(v.y, v.y);
    let zz = exact_two_product(v.z, v.z);
    let first = exact_two_sum(xx.sum, yy.sum);
    let second = exact_two_sum(zz.sum, -s.sum);
    let difference = exact_two_sum(first.sum, second.sum);
    let across = exact_mul_add(v.x, q.error.x, exact_mul_add(v.y, q.error.y, v.z * q.error.z));
    let of_squares = (xx.error + yy.error) + (zz.error - s.error);
    let error = (first.error + second.error + difference.error) + of_squares + (across + across);
    return SquareTerms(difference.sum + error, (xx.sum + yy.sum) + (zz.sum + s.sum));
}

// Quadratic::near: returns `h^2 - a c`. The bound of the error of `c` is 64 times 2^-53 of its terms.
fn compensated_near(quadratic: CompensatedQuadratic) -> CompensatedDiscriminant {
    let lost = quadratic.size_of_c * real(7.105427357601002e-15);
    let size = abs(quadratic.h) * quadratic.size_of_h + quadratic.a * (abs(quadratic.c) + lost);
    return CompensatedDiscriminant(quadratic.h * quadratic.h - quadratic.a * quadratic.c, size);
}

// Quadratic::error_of_c: returns the bound of the error of `c` that is not relative to `c`. The factor is 64 * 2^-106.
fn compensated_error_of_c(quadratic: CompensatedQuadratic) -> real {
    return quadratic.size_of_c * real(7.888609052210118e-31) + ERROR_UNDERFLOW;
}

// Quadratic::leaves: returns whether both roots certainly are below LAMBDA_MIN, because the ray starts near the surface
// and moves away from the middle. The condition limit is 4,096.
fn compensated_leaves(quadratic: CompensatedQuadratic) -> bool {
    let size = abs(quadratic.h);
    let h_is_accurate = quadratic.size_of_h < size * real(4096.0);
    let c = abs(quadratic.c) + compensated_error_of_c(quadratic);
    return quadratic.h < real(0.0) && h_is_accurate && c < size * exact_sphere_limits().least;
}

// Quadratic::roots: returns what is certain about the roots with this discriminant. The constants are the condition
// limit 4,096, and the reciprocal of 4,096 times 2^-53.
fn compensated_roots(quadratic: CompensatedQuadratic, discriminant: CompensatedDiscriminant) -> CompensatedRoots {
    let limits = exact_sphere_limits();
    let zero = real(0.0);
    let h = quadratic.h;
    let c = abs(quadratic.c);
    let size = discriminant.size;
    let root = sqrt(discriminant.value);
    let w = abs(h) + root;
    let error = size * limits.error + ERROR_UNDERFLOW;
    let h_is_accurate = quadratic.size_of_h < w * real(4096.0);
    let root_is_accurate = error < discriminant.value && size < root * w * real(4096.0);
    let error_of_c = compensated_error_of_c(quadratic);
    let c_is_accurate = error_of_c * real(2199023255552.0) < c;
    // A zero `h` counts as positive: a ray from the middle has two roots of the same size.
    let backward = h < zero;
    let signed_c = select(quadratic.c, -quadratic.c, backward);
    return CompensatedRoots(
        w,
        (size / root + quadratic.size_of_h) / w,
        error_of_c,
        error < -discriminant.value,
        h_is_accurate && root_is_accurate && size < ERROR_OVERFLOW,
        c_is_accurate && zero < signed_c,
        (c_is_accurate && signed_c < zero) || c + error_of_c < w * limits.least,
        backward || w < quadratic.a * limits.least,
    );
}

// is_in_range: returns whether an accurate lambda certainly is in range, and has not overflowed.
fn compensated_is_in_range(lambda: real) -> bool {
    return exact_sphere_limits().most <= lambda && lambda < ERROR_OVERFLOW;
}
