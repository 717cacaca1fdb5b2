//! Hypotheses that several proofs share.

use super::super::row::U;
use super::dyadic;

/// Returns that a computed value has a relative error of at most `error u`.
pub(super) fn relative([computed, exact]: &[String; 2], error: f64) -> String {
    format!("|{computed} -/ {exact}| <= {}", dyadic(error * U))
}

/// Magnitudes for which no square overflows or underflows.
pub(super) const MODERATE: [f64; 2] = [f64::from_bits((1023 - 300) << 52), f64::from_bits((1023 + 300) << 52)];
