// Numbers of twice as many bits, each the unevaluated sum of two; twin of cpu/src/math/double_double.rs.

struct DoubleDouble {
    high: real,
    low: real,
}

// DoubleDouble::of: returns the number without a low part.
fn dd_of(high: real) -> DoubleDouble {
    return DoubleDouble(high, real(0.0));
}

// fast_two_sum: returns `a + b` without a rounding error, if `|a| >= |b|` or `a = 0` (Dekker).
fn dd_fast_two_sum(a: real, b: real) -> DoubleDouble {
    let high = a + b;
    return DoubleDouble(high, b - (high - a));
}

fn dd_add(a: DoubleDouble, b: DoubleDouble) -> DoubleDouble {
    let high = exact_two_sum(a.high, b.high);
    let low = exact_two_sum(a.low, b.low);
    let sum = dd_fast_two_sum(high.sum, high.error + low.sum);
    return dd_fast_two_sum(sum.high, sum.low + low.error);
}

fn dd_neg(a: DoubleDouble) -> DoubleDouble {
    return DoubleDouble(-a.high, -a.low);
}

fn dd_sub(a: DoubleDouble, b: DoubleDouble) -> DoubleDouble {
    return dd_add(a, dd_neg(b));
}

fn dd_mul(a: DoubleDouble, b: DoubleDouble) -> DoubleDouble {
    let product = exact_two_product(a.high, b.high);
    let across = exact_mul_add(a.low, b.high, exact_mul_add(a.high, b.low, a.low * b.low));
    return dd_fast_two_sum(product.sum, product.error + across);
}

fn dd_div(a: DoubleDouble, b: DoubleDouble) -> DoubleDouble {
    let high = a.high / b.high;
    let exact = exact_two_product(b.high, high);
    let product = dd_fast_two_sum(exact.sum, exact_mul_add(b.low, high, exact.error));
    let remainder = (a.high - product.high) + (a.low - product.low);
    return dd_fast_two_sum(high, remainder / b.high);
}

fn dd_sqrt(a: DoubleDouble) -> DoubleDouble {
    if a.high == real(0.0) {
        return a;
    }
    let high = sqrt(a.high);
    let remainder = exact_mul_add(-high, high, a.high) + a.low;
    return dd_fast_two_sum(high, remainder / (high + high));
}

fn dd_abs(a: DoubleDouble) -> DoubleDouble {
    if a.high < real(0.0) {
        return dd_neg(a);
    }
    return a;
}

fn dd_less(a: DoubleDouble, b: DoubleDouble) -> bool {
    return a.high < b.high || (a.high == b.high && a.low < b.low);
}

fn dd_less_equal(a: DoubleDouble, b: DoubleDouble) -> bool {
    return a.high < b.high || (a.high == b.high && a.low <= b.low);
}

// Vec3<DoubleDouble>
struct DoubleDouble3 {
    x: DoubleDouble,
    y: DoubleDouble,
    z: DoubleDouble,
}

fn dd3_of(v: vec3<real>) -> DoubleDouble3 {
    return DoubleDouble3(dd_of(v.x), dd_of(v.y), dd_of(v.z));
}

fn dd3_add(a: DoubleDouble3, b: DoubleDouble3) -> DoubleDouble3 {
    return DoubleDouble3(dd_add(a.x, b.x), dd_add(a.y, b.y), dd_add(a.z, b.z));
}

fn dd3_sub(a: DoubleDouble3, b: DoubleDouble3) -> DoubleDouble3 {
    return DoubleDouble3(dd_sub(a.x, b.x), dd_sub(a.y, b.y), dd_sub(a.z, b.z));
}

fn dd3_scaled(v: DoubleDouble3, factor: DoubleDouble) -> DoubleDouble3 {
    return DoubleDouble3(dd_mul(v.x, factor), dd_mul(v.y, factor), dd_mul(v.z, factor));
}

fn dd3_divided(v: DoubleDouble3, divisor: DoubleDouble) -> DoubleDouble3 {
    return DoubleDouble3(dd_div(v.x, divisor), dd_div(v.y, divisor), dd_div(v.z, divisor));
}

// Vec3::dot: returns the scalar product, summed from left to right.
fn dd3_dot(a: DoubleDouble3, b: DoubleDouble3) -> DoubleDouble {
    return dd_add(dd_add(dd_mul(a.x, b.x), dd_mul(a.y, b.y)), dd_mul(a.z, b.z));
}

// magnitude of cylinder_parts.rs: returns the sum of the components' magnitudes, which is at least the length.
fn dd3_magnitude(v: DoubleDouble3) -> DoubleDouble {
    return dd_add(dd_add(dd_abs(v.x), dd_abs(v.y)), dd_abs(v.z));
}

// Vec3::perpendicular_to: returns the component of `v` perpendicular to the unit vector `axis`.
fn dd3_perpendicular_to(v: DoubleDouble3, axis: DoubleDouble3) -> DoubleDouble3 {
    return dd3_sub(v, dd3_scaled(axis, dd3_dot(v, axis)));
}
