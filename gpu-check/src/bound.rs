//! Compares a kernel's f32 results with f64, within the bound that [`crate::running`] derives for each case.

use std::fmt;

use crate::Kernel;
use crate::running::{self, Running};

/// How far f32 is from f64, and how far it may be.
#[derive(Clone, Copy, Debug, Default)]
pub struct Spread {
    /// Number of cases.
    pub cases: usize,
    /// Cases in which f32 certainly takes the decisions of f64.
    pub decided: usize,
    /// Numbers in the decided cases whose bound is finite: these are compared.
    pub compared: usize,
    /// Numbers farther from f64 than their bound.
    pub beyond: usize,
    /// The largest distance, as a share of its bound.
    pub closest: f64,
}

/// Compares the f32 `results` of `cases` with the formula in f64.
#[must_use]
pub fn spread(kernel: &Kernel, cases: &[f32], results: &[f32]) -> Spread {
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
    /// Counts one number, which should be `wide` and is `actual`.
    fn add(&mut self, wide: Running, actual: f64) {
        let distance = (wide.value - actual).abs();
        self.compared += 1;
        // NaN compares false, so it counts as beyond the bound.
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
