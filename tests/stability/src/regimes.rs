//! Families of rays that are hard each for another reason.

mod cylinders;
mod extremes;
pub mod large;
mod spheres;

use crate::case::Case;
use crate::random::Random;

/// A family of cases.
#[derive(Clone, Copy, Debug)]
pub struct Regime {
    /// Its name in tables.
    pub name: &'static str,
    /// Draws one case.
    pub draw: fn(&mut Random) -> Case,
}

/// The regimes of spheres.
pub const SPHERES: [Regime; 9] = spheres::REGIMES;
/// The regimes of cylinders.
pub const CYLINDERS: [Regime; 10] = cylinders::REGIMES;
/// The regimes of both kinds that only f64 holds.
pub const EXTREMES: [Regime; 6] = extremes::REGIMES;

impl Regime {
    /// `count` cases, the same for the same seed.
    #[must_use]
    pub fn cases(&self, seed: u64, count: usize) -> Vec<Case> {
        // Every regime has its own stream: a new regime leaves the others as they are.
        let salt = self.name.bytes().fold(seed, |salt, byte| salt.wrapping_mul(0x100_0000_01b3) ^ u64::from(byte));
        let mut random = Random::new(salt | 1);
        (0..count).map(|_| (self.draw)(&mut random)).collect()
    }
}
