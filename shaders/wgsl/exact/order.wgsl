// Which of two hits is certainly closer, by lambdas with errors; twin of cpu/src/exact/order.rs.

// is_certainly_closer: returns whether a hit at `lambda` certainly is closer than one at `other`. The factor is
// 1 + 256 * 65,536 * 2^-53.
fn order_is_certainly_closer(lambda: real, other: real) -> bool {
    return lambda * real(1.000000001862645149230957) < other;
}
