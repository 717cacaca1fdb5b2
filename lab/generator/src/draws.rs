//! Random numbers, vectors and choices for the generator of scenes.

use cpu::Vec3;
use cpu::internals::sampling::uniform::Uniform;

/// A generator of random numbers, vectors and choices.
pub struct Draws(Uniform);

impl Draws {
    /// Returns the generator with this seed.
    pub fn new(seed: u64) -> Self {
        Self(Uniform::new(seed))
    }

    /// Returns a random number from `low` to `high`; `high` is excluded.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0.draw(low, high)
    }

    /// Returns `10^k`, in which `k` is uniform from `low` to `high`. Its last bits depend on the machine's library.
    pub fn decades(&mut self, low: f64, high: f64) -> f64 {
        10.0_f64.powf(self.between(low, high))
    }

    /// Returns a random integer below `count`, which must not be 0.
    pub fn index(&mut self, count: usize) -> usize {
        // The random number is below 1, but rounding may give the product the value `count`.
        ((self.0.canonical() * count as f64) as usize).min(count - 1)
    }

    /// Returns true with this probability: never for 0, always for 1.
    pub fn chance(&mut self, probability: f64) -> bool {
        self.0.canonical() < probability
    }

    /// Returns a random point in the cube around the origin whose half side is `half_side`. The coordinates are
    /// rounded.
    pub fn point(&mut self, half_side: f64) -> Vec3 {
        Vec3::from([(); 3].map(|()| round(self.between(-half_side, half_side))))
    }

    /// Returns a vector in a random direction. Its length is from half of `radius` to `radius`, and its components are
    /// rounded.
    pub fn direction(&mut self, radius: f64) -> Vec3 {
        loop {
            let vector = self.point(1.0);
            if (0.5..1.0).contains(&vector.length()) {
                return (vector * radius).map(round);
            }
        }
    }

    /// Returns a vector of this length along a random coordinate axis, with a random sign.
    pub fn along_an_axis(&mut self, length: f64) -> Vec3 {
        let mut components = [0.0; 3];
        components[self.index(3)] = if self.chance(0.5) { length } else { -length };
        components.into()
    }

    /// Returns a random colour. Its channels are from `darkest` to 1 and have two decimals.
    pub fn color(&mut self, darkest: f64) -> Vec3 {
        Vec3::from([(); 3].map(|()| (self.between(darkest, 1.0) * 100.0).round() / 100.0))
    }
}

/// Returns `value` rounded to five significant digits, so that files stay short.
pub(super) fn round(value: f64) -> f64 {
    format!("{value:.4e}").parse().expect("a finite number reads back")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_rounded_to_five_digits() {
        assert_eq!(round(1.234_567), 1.2346);
        assert_eq!(round(-1.234_567e-9), -1.2346e-9);
        assert_eq!(round(0.0), 0.0);
    }

    #[test]
    fn choices_cover_their_range_and_stay_in_it() {
        let mut draws = Draws::new(1);
        let mut seen = [0; 3];
        for _ in 0..300 {
            seen[draws.index(3)] += 1;
            assert!(!draws.chance(0.0) && draws.chance(1.0));
            assert!((0.999..2.001).contains(&draws.direction(2.0).length()));
            assert_eq!(draws.along_an_axis(3.0).length(), 3.0);
            let color = draws.color(0.5).to_array();
            assert!(color.iter().all(|channel| (0.5..=1.0).contains(channel)));
        }
        assert!(seen.iter().all(|&count| count > 50), "{seen:?}");
    }
}
