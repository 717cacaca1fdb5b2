//! Hypotheses that several proofs share.

use super::super::bounded::{Bounded, Operation};
use super::super::row::U;
use super::{Script, dyadic, within};

/// Returns that a computed value has a relative error of at most `error u`.
pub(super) fn relative([computed, exact]: &[String; 2], error: f64) -> String {
    format!("|{computed} -/ {exact}| <= {}", dyadic(error * U))
}

/// Magnitudes for which no square overflows or underflows.
pub(super) const MODERATE: [f64; 2] = [f64::from_bits((1023 - 300) << 52), f64::from_bits((1023 + 300) << 52)];

/// Defines the three products of a dot product, of which the exact magnitudes are at most `w0`, `w1` and `w2`. These
/// add up to 1. `error` is the relative error of the second factors, in units of `u`. Returns the hypotheses.
pub(super) fn products(script: &mut Script, dot: Bounded, error: f64) -> Vec<String> {
    let Operation::Sum(two, third) = dot.operation() else { panic!("it is no sum") };
    let Operation::Sum(first, second) = two.operation() else { panic!("it is no sum of three") };
    script.definitions += "w0 = 1 - w1 - w2;\n";
    let mut hypotheses = Vec::new();
    for (index, product) in [first, second, third].into_iter().enumerate() {
        assert!(matches!(product.operation(), Operation::Product(..)), "a dot product adds products");
        let before = format!("p{index}");
        let rounded = script.round(&before);
        let [_, exact] = script.define(product, [&rounded, &format!("r{index} * w{index}")]);
        hypotheses.push(within(&format!("r{index}"), [-1.0, 1.0]));
        hypotheses.push(within(&format!("w{index}"), [0.0, 1.0]));
        hypotheses.push(relative(&[before, exact], error));
    }
    hypotheses
}
