// Which of two hits is certainly closer, by lambdas with errors; twin of cpu/src/exact/order.rs.

// is_certainly_closer: returns whether a hit at `lambda` certainly is closer than one at `other`. The factor is
// 1 + 256 * 65,536 * 2^-53.
fn order_is_certainly_closer(lambda: real, other: real) -> bool {
    return lambda * real(1.000000001862645149230957) < other;
}

// is_certainly_closer::<DoubleDouble>: the factor is 1 + 256 * 65,536 * 2^24 * 2^-102.
fn order_is_certainly_closer_precisely(lambda: DoubleDouble, other: DoubleDouble) -> bool {
    let factor = DoubleDouble(real(1.0), real(5.551115123125783e-17));
    return dd_less(dd_mul(lambda, factor), other);
}
