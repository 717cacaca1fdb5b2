//! Random numbers and vectors for the regimes, all from one generator.

use cpu::Vec3;
use cpu::internals::sampling::uniform::Uniform;

/// A generator of random numbers and vectors.
#[derive(Clone, Debug)]
pub struct Random(Uniform);

impl Random {
    /// Returns the generator with this seed.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        Self(Uniform::new(seed))
    }

    /// Returns a random number from `low` to `high`. All are equally likely; `high` is excluded.
    pub fn uniform(&mut self, low: f64, high: f64) -> f64 {
        self.0.draw(low, high)
    }

    /// Returns `10^k`, in which `k` is uniform from `low` to `high`.
    pub fn decades(&mut self, low: f64, high: f64) -> f64 {
        10.0_f64.powf(self.uniform(low, high))
    }

    /// Returns a random integer from 0 to `count - 1`. All are equally likely.
    pub fn below(&mut self, count: usize) -> usize {
        (self.uniform(0.0, count as f64) as usize).min(count - 1)
    }

    /// Returns 1 or -1, with equal probabilities.
    pub fn sign(&mut self) -> f64 {
        if self.uniform(-1.0, 1.0) < 0.0 { -1.0 } else { 1.0 }
    }

    /// Returns a random vector whose components are from `-extent` to `extent`.
    pub fn cube(&mut self, extent: f64) -> Vec3 {
        Vec3::from([(); 3].map(|()| self.uniform(-extent, extent)))
    }

    /// Returns a random vector of length one, up to rounding. All directions are equally likely.
    pub fn unit(&mut self) -> Vec3 {
        loop {
            let vector = self.cube(1.0);
            let square = vector.dot(vector);
            if square <= 1.0 && square > 1e-4 {
                return vector.unit();
            }
        }
    }

    /// Returns a random vector of length one that is perpendicular to `axis`, up to rounding.
    pub fn perpendicular(&mut self, axis: Vec3) -> Vec3 {
        loop {
            let across = axis.unit().cross(self.unit());
            if across.length() > 0.1 {
                return across.unit();
            }
        }
    }

    /// Returns the vector with its components in a random order, so that no coordinate axis is special.
    pub fn shuffled(&mut self, vector: Vec3) -> Vec3 {
        let mut components = vector.to_array();
        for last in (1..3).rev() {
            components.swap(last, self.below(last + 1));
        }
        components.into()
    }

    /// Returns a number that is at most `most` steps from `value`. A step is one unit in the last place of `value`. If
    /// `value` is 0, a step is one unit in the last place of 2^-40.
    pub fn nudged(&mut self, value: f64, most: usize) -> f64 {
        let steps = self.below(2 * most + 1) as i64 - most as i64;
        if value == 0.0 {
            return steps as f64 * f64::EPSILON * 2.0_f64.powi(-40);
        }
        (0..steps.abs()).fold(value, |value, _| if steps < 0 { value.next_down() } else { value.next_up() })
    }
    /// Returns the vector with each component [`Self::nudged`].
    pub fn nudged_vector(&mut self, vector: Vec3, most: usize) -> Vec3 {
        vector.to_array().map(|component| self.nudged(component, most)).into()
    }

    /// Returns a length from 0.1 to 4, in every second case one with one decimal.
    pub fn length(&mut self) -> f64 {
        if self.below(2) == 0 { (self.below(40) + 1) as f64 / 10.0 } else { self.uniform(0.1, 4.0) }
    }
}
