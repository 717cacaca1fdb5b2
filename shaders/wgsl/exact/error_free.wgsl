// Products and differences with their rounding errors, and a multiply-add that rounds once; twin of
// cpu/src/math/error_free.rs and of `f64::mul_add`.
//
// WGSL's own `fma` may round twice, and does on lavapipe. So the product is split into four exact partial products
// (Dekker 1971), and the result is rounded once by comparisons (the idea of Boldo and Melquiond 2008, with a test for
// ties in the place of rounding to odd). A product below 2^-960 may lose its error to underflow, as the error is then
// smaller than the smallest number. The bounds of the exact intersections have a term for that.

// The two halves of a number, of at most 26 bits each: their sum is the number.
struct ExactHalves {
    high: real,
    low: real,
}

// Returns the halves of `a` (Veltkamp).
fn exact_halves(a: real) -> ExactHalves {
    let large = a * SPLITTER;
    let high = large - (large - a);
    return ExactHalves(high, a - high);
}

// two_product: returns the rounded product and its rounding error.
fn exact_two_product(a: real, b: real) -> ExactSum {
    let scales_a = SPLIT_LIMIT < abs(a);
    let scales_b = SPLIT_LIMIT < abs(b);
    let x = select(a, a * SPLIT_SCALE, scales_a);
    let y = select(b, b * SPLIT_SCALE, scales_b);
    let product = x * y;
    let xs = exact_halves(x);
    let ys = exact_halves(y);
    let error = ((xs.high * ys.high - product) + xs.high * ys.low + xs.low * ys.high) + xs.low * ys.low;
    let unscaled = select(error, error * SPLIT_UNSCALE, scales_a);
    return ExactSum(a * b, select(unscaled, unscaled * SPLIT_UNSCALE, scales_b));
}

// f64::mul_add: returns `a b + c`, rounded once.
//
// The exact value is `sum + rest + left`, where `sum` is rounded from the two largest terms, `rest` is the error of
// that rounding, and `left` is smaller than the last place of the second term. So `left` matters only if `rest` is
// exactly half a unit in the last place: then `sum` may have been rounded to the even neighbour on the wrong side.
fn exact_mul_add(a: real, b: real, c: real) -> real {
    let product = exact_two_product(a, b);
    let low = exact_two_sum(c, product.error);
    let high = exact_two_sum(product.sum, low.sum);
    let middle = exact_two_sum(low.error, high.error);
    let sum = exact_two_sum(high.sum, middle.sum);
    // The neighbour of the sum on the side of the rest, if the rest is more than a third of a unit.
    let neighbor = sum.sum + sum.error * real(1.5);
    let is_tie = sum.error + sum.error == neighbor - sum.sum;
    let zero = real(0.0);
    let same_side = (zero < sum.error && zero < middle.error) || (sum.error < zero && middle.error < zero);
    return select(sum.sum, neighbor, is_tie && same_side);
}

// A rounded vector, and its rounding error.
struct ExactVector {
    rounded: vec3<real>,
    error: vec3<real>,
}

// difference: returns `a - b`.
fn exact_difference(a: vec3<real>, b: vec3<real>) -> ExactVector {
    let x = exact_two_sum(a.x, -b.x);
    let y = exact_two_sum(a.y, -b.y);
    let z = exact_two_sum(a.z, -b.z);
    return ExactVector(vec3<real>(x.sum, y.sum, z.sum), vec3<real>(x.error, y.error, z.error));
}

// difference_of_products: returns `a b - c d` by Kahan's algorithm.
fn exact_difference_of_products(a: real, b: real, c: real, d: real) -> real {
    let product = c * d;
    let error = exact_mul_add(-c, d, product);
    return exact_mul_add(a, b, -product) + error;
}

// cross: returns the cross product with a small relative error of each component.
fn exact_cross(a: vec3<real>, b: vec3<real>) -> vec3<real> {
    return vec3<real>(
        exact_difference_of_products(a.y, b.z, a.z, b.y),
        exact_difference_of_products(a.z, b.x, a.x, b.z),
        exact_difference_of_products(a.x, b.y, a.y, b.x),
    );
}

// difference_with_error: returns `a b - c d + more` in two parts.
fn exact_difference_with_error(a: real, b: real, c: real, d: real, more: real) -> ExactSum {
    let left = exact_two_product(a, b);
    let right = exact_two_product(c, d);
    let difference = exact_two_sum(left.sum, -right.sum);
    return ExactSum(difference.sum, difference.error + (left.error - right.error) + more);
}

// cross_with_error: returns the cross product of `a` with its rounding error and `b`, in two parts.
fn exact_cross_with_error(a: ExactVector, b: vec3<real>) -> ExactVector {
    let v = a.rounded;
    let more = exact_cross(a.error, b);
    let x = exact_difference_with_error(v.y, b.z, v.z, b.y, more.x);
    let y = exact_difference_with_error(v.z, b.x, v.x, b.z, more.y);
    let z = exact_difference_with_error(v.x, b.y, v.y, b.x, more.z);
    return ExactVector(vec3<real>(x.sum, y.sum, z.sum), vec3<real>(x.error, y.error, z.error));
}
