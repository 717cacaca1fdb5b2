//! The random generators: the one of the statement, and others that people take instead.

use cpu::internals::sampling::uniform;
use rand_mt::{Mt, Mt64};

use crate::rules::Rules;

/// A stream of random numbers, and the place in it. The generator is the one of the statement unless another is there.
#[derive(Clone, Debug)]
pub struct Stream {
    wide: Mt64,
    narrow: Mt,
    /// The state of `std::minstd_rand0`, which is `std::default_random_engine` of libstdc++.
    minimal: u64,
    /// The value of the deviation `generator`.
    form: f64,
    /// Number of random numbers that were drawn since the generator was seeded.
    pub drawn: u64,
}

impl Stream {
    /// Returns the stream that starts from `seed`.
    pub fn new(seed: u64, rules: &Rules) -> Self {
        let form = rules.or("generator", 0.0);
        let narrow = if form == 3.0 { Mt::new_with_key([seed as u32]) } else { Mt::new(seed as u32) };
        Self { wide: Mt64::new(seed), narrow, minimal: (seed % 0x7fff_ffff).max(1), form, drawn: 0 }
    }

    /// Returns the next random number, in `[low, high)`.
    pub fn draw(&mut self, low: f64, high: f64) -> f64 {
        self.drawn += 1;
        self.canonical() * (high - low) + low
    }

    /// Returns the next random number, in `[0, 1)`.
    fn canonical(&mut self) -> f64 {
        let range = if self.form == 5.0 { 2_147_483_646.0 } else { 2.0_f64.powi(32) };
        let mut word = || {
            if self.form == 5.0 {
                self.minimal = self.minimal * 16_807 % 0x7fff_ffff;
                return (self.minimal - 1) as f64;
            }
            f64::from(self.narrow.next_u32())
        };
        match self.form {
            0.0 => uniform::canonical(self.wide.next_u64()),
            2.0 => word() / range,
            // 27 bits of one word and 26 of the next, as Python and numpy combine them.
            3.0 | 4.0 => ((word() / 32.0).floor() * 2.0_f64.powi(26) + (word() / 64.0).floor()) / 2.0_f64.powi(53),
            // std::generate_canonical of libstdc++: the low word comes first.
            _ => ((word() + word() * range) / (range * range)).min(1.0_f64.next_down()),
        }
    }
}
