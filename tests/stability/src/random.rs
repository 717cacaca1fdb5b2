//! Random numbers and vectors for the regimes, all from one seed.

use cpu::Vec3;
use cpu::internals::sampling::uniform::Uniform;

/// A stream of draws.
#[derive(Clone, Debug)]
pub struct Random(Uniform);

impl Random {
    /// The stream of a seed.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        Self(Uniform::new(seed))
    }

    /// Uniform in `[low, high)`.
    pub fn uniform(&mut self, low: f64, high: f64) -> f64 {
        self.0.draw(low, high)
    }

    /// `10^k`, with `k` uniform in `[low, high)`.
    pub fn decades(&mut self, low: f64, high: f64) -> f64 {
        10.0_f64.powf(self.uniform(low, high))
    }

    /// One of `count` numbers from 0, all equally likely.
    pub fn below(&mut self, count: usize) -> usize {
        (self.uniform(0.0, count as f64) as usize).min(count - 1)
    }

    /// 1 or -1.
    pub fn sign(&mut self) -> f64 {
        if self.uniform(-1.0, 1.0) < 0.0 { -1.0 } else { 1.0 }
    }

    /// A vector in the cube `[-extent, extent)`.
    pub fn cube(&mut self, extent: f64) -> Vec3 {
        Vec3::from([(); 3].map(|()| self.uniform(-extent, extent)))
    }

    /// A vector of length one, to rounding; all directions equally likely.
    pub fn unit(&mut self) -> Vec3 {
        loop {
            let vector = self.cube(1.0);
            let square = vector.dot(vector);
            if square <= 1.0 && square > 1e-4 {
                return vector.unit();
            }
        }
    }

    /// A vector of length one perpendicular to `axis`, to rounding.
    pub fn perpendicular(&mut self, axis: Vec3) -> Vec3 {
        loop {
            let across = axis.unit().cross(self.unit());
            if across.length() > 0.1 {
                return across.unit();
            }
        }
    }

    /// The vector with its components exchanged in one of the six ways, so that no axis is special.
    pub fn shuffled(&mut self, vector: Vec3) -> Vec3 {
        let mut components = vector.to_array();
        for last in (1..3).rev() {
            components.swap(last, self.below(last + 1));
        }
        components.into()
    }

    /// The number or one of its neighbours, up to `most` steps away. Beside zero steps are as wide as beside 2^-40.
    pub fn nudged(&mut self, value: f64, most: usize) -> f64 {
        let steps = self.below(2 * most + 1) as i64 - most as i64;
        if value == 0.0 {
            return steps as f64 * f64::EPSILON * 2.0_f64.powi(-40);
        }
        (0..steps.abs()).fold(value, |value, _| if steps < 0 { value.next_down() } else { value.next_up() })
    }
}
