//! Binary logarithms of magnitudes.

/// The binary logarithm of the largest magnitude of a number.
pub type Log = f64;

/// A corner of a domain: the largest magnitudes of the numbers and vectors of some families.
pub type Corner<'a> = &'a [(u8, Log)];

/// Returns the logarithm of the sum of two numbers.
pub fn sum(a: Log, b: Log) -> Log {
    let (least, most) = (a.min(b), a.max(b));
    if least == f64::NEG_INFINITY || most.is_infinite() {
        most
    } else {
        most + (least - most).exp2().ln_1p() / std::f64::consts::LN_2
    }
}
