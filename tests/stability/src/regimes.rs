//! Regimes: families of rays, each hard for another reason.

mod cylinders;
mod extremes;
pub mod large;
mod spheres;

use crate::case::Case;
use crate::random::Random;

/// A family of cases.
#[derive(Clone, Copy, Debug)]
pub struct Regime {
    /// Name in tables.
    pub name: &'static str,
    /// Draws a case.
    pub draw: fn(&mut Random) -> Case,
}

/// The regimes of spheres.
pub const SPHERES: [Regime; 9] = spheres::REGIMES;
/// The regimes of cylinders.
pub const CYLINDERS: [Regime; 10] = cylinders::REGIMES;
/// The regimes of spheres and cylinders whose numbers are outside the range of f32.
pub const EXTREMES: [Regime; 6] = extremes::REGIMES;

impl Regime {
    /// Draws `count` cases. A seed always gives the same cases.
    #[must_use]
    pub fn cases(&self, seed: u64, count: usize) -> Vec<Case> {
        // The seed and the name give each regime its stream, so that a new regime does not change the cases of others.
        let salt = self.name.bytes().fold(seed, |salt, byte| salt.wrapping_mul(0x100_0000_01b3) ^ u64::from(byte));
        let mut random = Random::new(salt | 1);
        (0..count).map(|_| (self.draw)(&mut random)).collect()
    }
}
