//! The random numbers, vectors and choices of the generator.

use cpu::Vec3;
use cpu::internals::sampling::uniform::Uniform;

/// A stream of random choices.
pub(super) struct Draws(Uniform);

impl Draws {
    pub(super) fn new(seed: u64) -> Self {
        Self(Uniform::new(seed))
    }

    /// Returns a number in `[low, high)`.
    pub(super) fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0.draw(low, high)
    }

    /// Returns an integer below `count`, which must not be zero.
    pub(super) fn index(&mut self, count: usize) -> usize {
        // The draw is below 1, but the product may be rounded up to `count`.
        ((self.0.canonical() * count as f64) as usize).min(count - 1)
    }

    /// Returns true with this probability: never for 0, always for 1.
    pub(super) fn chance(&mut self, probability: f64) -> bool {
        self.0.canonical() < probability
    }

    /// Returns a rounded point in the cube around the origin with this half side.
    pub(super) fn point(&mut self, half_side: f64) -> Vec3 {
        Vec3::from([(); 3].map(|()| round(self.between(-half_side, half_side))))
    }

    /// Returns a rounded vector in a random direction, with a length from half of `radius` to `radius`.
    pub(super) fn direction(&mut self, radius: f64) -> Vec3 {
        loop {
            let vector = self.point(1.0);
            if (0.5..1.0).contains(&vector.length()) {
                return (vector * radius).map(round);
            }
        }
    }

    /// Returns a vector of this length along one of the three coordinate axes, with a random sign.
    pub(super) fn along_an_axis(&mut self, length: f64) -> Vec3 {
        let mut components = [0.0; 3];
        components[self.index(3)] = if self.chance(0.5) { length } else { -length };
        components.into()
    }

    /// Returns a colour whose channels have two decimals and are from `darkest` to 1.
    pub(super) fn color(&mut self, darkest: f64) -> Vec3 {
        Vec3::from([(); 3].map(|()| (self.between(darkest, 1.0) * 100.0).round() / 100.0))
    }
}

/// Rounds `value` to five significant digits, so that files stay short.
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
