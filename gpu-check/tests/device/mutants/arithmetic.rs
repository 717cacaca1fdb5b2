//! Deliberate errors of the arithmetic of f64 by integers, which the comparison of the operations must notice.

use gpu_check::{Error, Gpu};
use shaders::lower::Arithmetic;

use super::mutant::Mutant;
use crate::lowered::comparison::{Tally, compare, compile};
use crate::lowered::operands::{Operands, draw};
use crate::lowered::operations::BASIC;

/// Number of cases of each operation.
const CASES: u64 = 120_000;

/// Returns the arithmetic with the error of `mutant`, whose module is a file in `shaders/wgsl/f64`.
///
/// # Panics
/// If there is no such file, or if the text to replace does not occur exactly once in it.
pub fn of(mutant: &Mutant) -> Arithmetic {
    let mut arithmetic = Arithmetic::standard();
    let source = arithmetic.source(&mutant.module).unwrap_or_else(|| panic!("there is no {}", mutant.module));
    let changed = mutant.changed(source);
    arithmetic.replace(&mutant.module, changed);
    arithmetic
}

/// Returns the cases with which [`notice`] looks for errors.
pub fn cases() -> Vec<Operands> {
    (0..CASES).map(|index| draw(31, index)).collect()
}

/// Returns a description of the first operation whose results differ from Rust's with `arithmetic`, or `None` if no
/// operation notices an error.
///
/// # Errors
/// An error of the device, or of the text of the arithmetic.
pub fn notice(gpu: &Gpu, arithmetic: &Arithmetic, cases: &[Operands]) -> Result<Option<String>, Error> {
    for operation in &BASIC {
        let pipeline = compile(gpu, operation, Some(arithmetic))?;
        let mut tally = Tally::new(operation);
        compare(gpu, &pipeline, operation, cases, &mut tally)?;
        if tally.differing > 0 {
            return Ok(Some(format!("{}, {} of {} cases", tally.operation, tally.differing, tally.cases)));
        }
    }
    Ok(None)
}
