//! Regimes: families of cases, each of which is hard for a different reason.

mod cylinders;
mod extremes;
mod limits;
pub mod near;
mod spheres;

pub use spheres::large;

use crate::case::Case;
use crate::random::Random;

/// A regime, which is a family of cases that are hard for one reason.
#[derive(Clone, Copy, Debug)]
pub struct Regime {
    /// Name of the regime in tables.
    pub name: &'static str,
    /// The function that returns a random case of the regime.
    pub draw: fn(&mut Random) -> Case,
}

/// The regimes in which the object is a sphere.
pub const SPHERES: [Regime; 9] = spheres::REGIMES;
/// The regimes in which the object is a cylinder.
pub const CYLINDERS: [Regime; 10] = cylinders::REGIMES;
/// The regimes of spheres and cylinders whose numbers are outside the range of f32.
pub const EXTREMES: [Regime; 6] = extremes::REGIMES;
/// The regimes of spheres and cylinders at the limits of lambda and of the slope, and of small whole numbers.
pub const LIMITS: [Regime; 6] = limits::REGIMES;

impl Regime {
    /// Returns `count` random cases. Equal seeds give equal cases.
    #[must_use]
    pub fn cases(&self, seed: u64, count: usize) -> Vec<Case> {
        // Each regime gets its own generator, from the seed and its name. So a new regime does not change the cases of
        // others.
        let salt = self.name.bytes().fold(seed, |salt, byte| salt.wrapping_mul(0x100_0000_01b3) ^ u64::from(byte));
        let mut random = Random::new(salt | 1);
        (0..count).map(|_| (self.draw)(&mut random)).collect()
    }
}
