//! The fuzz target `render`: converts any bytes to a tiny scene, and renders it with every layout and instruction set.
//!
//! The bytes choose between hard numbers (0, the smallest, the largest, nearly 1) and arbitrary ones. Every input gives
//! a valid scene and a valid configuration, so libFuzzer spends its time on geometry and not on grammar.

mod choices;

use cpu::Scatter;
use test_support::agreement::{SCATTERS, equals_reference};

pub use choices::Choices;

/// Checks that both layouts give the bytes or the error of the reference, with every instruction set of this machine.
///
/// # Panics
/// If a result differs. The message has both input files.
pub fn check(bytes: &[u8]) {
    let mut choices = Choices::new(bytes);
    let scatter: Scatter = SCATTERS[choices.below(3)];
    // This choice is no longer used. It is still read, so that inputs of earlier runs give the same scenes.
    let _ = choices.below(2);
    let (config, scene) = (choices.config(), choices.scene());
    if let Err(difference) = equals_reference(&config, &scene, scatter) {
        panic!("{difference}");
    }
}
