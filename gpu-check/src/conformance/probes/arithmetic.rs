//! Sums, products, quotients and square roots.

use crate::conformance::draft::Draft;
use crate::conformance::inputs::{positive, random};
use crate::conformance::probe::Probe;
use crate::conformance::reading::Allowed;
use crate::conformance::ulp::{neighbours, ulp, within};
use crate::conformance::value::Number;

/// Text for sums and products.
const EXACT: &str = "IEEE 754: correctly rounded. WGSL 15.7.4: correctly rounded, up or down; f64: no rule";
/// Text for quotients.
const QUOTIENT: &str = "IEEE 754: correctly rounded. WGSL 15.7.4: 2.5 ulp if |b| is from 2^-126 to 2^126; f64: no rule";
/// Text for square roots.
const ROOT: &str = "IEEE 754: correctly rounded. WGSL 15.7.4: as accurate as 1 / inverseSqrt(a); f64: no rule";

pub fn probes() -> Vec<Probe> {
    let wide = |[a, b]: [f32; 2]| [a, b].map(f64::from);
    vec![
        sum::<f32>().error("rounded up or down", move |row| neighbours(wide(row)[0] + wide(row)[1])).done(),
        product::<f32>().error("rounded up or down", move |row| neighbours(wide(row)[0] * wide(row)[1])).done(),
        quotient::<f32>().error("2.5 ulp", move |row| within(wide(row)[0] / wide(row)[1], 2.5)).done(),
        root::<f32>().error("1 / inverseSqrt(a)", |[a]| root_by_inverse(a)).done(),
        sum::<f64>().done(),
        product::<f64>().done(),
        quotient::<f64>().done(),
        root::<f64>().done(),
    ]
}

fn sum<T: Number>() -> Draft<T, T, 2> {
    Draft::new("sum", "a + b", EXACT, random(-3.0, 3.0), |[a, b]: [T; 2]| a + b)
}

fn product<T: Number>() -> Draft<T, T, 2> {
    Draft::new("product", "a * b", EXACT, random(-3.0, 3.0), |[a, b]: [T; 2]| a * b)
}

fn quotient<T: Number>() -> Draft<T, T, 2> {
    Draft::new("divide", "a / b", QUOTIENT, random(-15.0, 15.0), |[a, b]: [T; 2]| a / b)
        .rewriting("a * (1 / b)", |[a, b]| a * (T::of(1.0) / b))
}

fn root<T: Number>() -> Draft<T, T, 1> {
    Draft::new("root", "sqrt(a)", ROOT, positive(-30.0, 30.0), |[a]: [T; 1]| a.sqrt())
}

/// Allows the results of `1 / inverseSqrt(a)`: the inverse root has an error of 2 ulp, and the quotient one of 2.5 ulp.
fn root_by_inverse(a: f32) -> Allowed {
    let inverse = 1.0 / f64::from(a).sqrt();
    let error = 2.0 * ulp(inverse);
    let [low, high] = [1.0 / (inverse + error), 1.0 / (inverse - error)];
    Allowed::Between(low - 2.6 * ulp(low), high + 2.6 * ulp(high))
}
