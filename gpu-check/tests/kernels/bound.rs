//! Compares a kernel's f32 results with the formula in f64. The difference must stay within the bound that
//! [`running`] computes for each case.

use std::fmt;

use crate::common::Accuracy;
use crate::kernels::kernel::Kernel;
use crate::kernels::running::{self, Running};

/// The distances between f32 and f64 results, compared with their bounds.
#[derive(Clone, Copy, Debug, Default)]
pub struct Spread {
    /// Number of cases.
    pub cases: usize,
    /// Number of decided cases: f32 certainly takes the same decisions as f64.
    pub decided: usize,
    /// Number of compared results: those of decided cases whose bound is finite.
    pub compared: usize,
    /// Number of compared results whose distance from f64 exceeds the bound.
    pub beyond: usize,
    /// The largest quotient of a distance and its bound; at most 1 if no result exceeds its bound.
    pub closest: f64,
}

/// Compares the f32 `results` for `cases`, from a device of this `accuracy`, with the results of the formula in f64.
pub fn spread(accuracy: Accuracy, kernel: &Kernel, cases: &[f32], results: &[f32]) -> Spread {
    running::within(accuracy, || spread_within(kernel, cases, results))
}

fn spread_within(kernel: &Kernel, cases: &[f32], results: &[f32]) -> Spread {
    let mut spread = Spread::default();
    let mut wide = vec![Running::exact(0.0); kernel.outputs.len()];
    for (case, actual) in cases.chunks(kernel.inputs).zip(results.chunks(kernel.outputs.len())) {
        let case: Vec<_> = case.iter().map(|number| Running::exact(f64::from(*number))).collect();
        let ((), decided) = running::observe(|| (kernel.running)(&case, &mut wide));
        spread.cases += 1;
        if !decided {
            continue;
        }
        spread.decided += 1;
        for (wide, actual) in wide.iter().zip(actual) {
            if wide.bound.is_finite() {
                spread.add(*wide, f64::from(*actual));
            }
        }
    }
    spread
}

impl Spread {
    /// Compares one number: `wide` is the value in f64 with its bound, `actual` is the result in f32.
    fn add(&mut self, wide: Running, actual: f64) {
        let distance = (wide.value - actual).abs();
        self.compared += 1;
        // A comparison with NaN is false, so a NaN counts as beyond the bound.
        let within = distance <= wide.bound;
        self.beyond += usize::from(!within);
        if distance > 0.0 {
            self.closest = self.closest.max(distance / wide.bound);
        }
    }
}

impl fmt::Display for Spread {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { cases, decided, compared, beyond, closest } = self;
        write!(f, "{cases} cases, {decided} that f32 decides as f64 does, {compared} numbers compared, ")?;
        write!(f, "{beyond} beyond their bound; at most {closest:.3} of it")
    }
}
