//! Any bytes as a tiny scene, rendered every way there is.
//!
//! The bytes choose: a menu of hard numbers (0, the smallest and the largest, what is nearly 1), or any number at all.
//! So every input is a valid scene and a valid configuration, and libFuzzer spends its time on geometry and not on
//! grammar.

mod choices;

use cpu::Scatter;
use test_support::agreement::{SCATTERS, equals_reference};

pub use choices::Choices;

/// Both layouts give the reference's bytes with every instruction set of the machine, or the reference's refusal.
///
/// # Panics
/// When they do not; the message has both files.
pub fn check(bytes: &[u8]) {
    let mut choices = Choices::new(bytes);
    let scatter: Scatter = SCATTERS[choices.below(3)];
    // A choice that is no longer there; read on, so that inputs kept from earlier runs make the same scenes.
    let _ = choices.below(2);
    let (config, scene) = (choices.config(), choices.scene());
    if let Err(difference) = equals_reference(&config, &scene, scatter) {
        panic!("{difference}");
    }
}
