//! The random vectors with which surfaces scatter light, in three conventions (specification, section 11).

use crate::{math::vec3::Vec3, sampling::draw_order::DRAWS_OF_SCATTER_SAMPLE, sampling::uniform::Uniform};

/// The convention by which the random vectors of scattering are drawn (specification, section 11). It decides the bytes
/// of every picture with matte or rough metal surfaces. The programs use [`Scatter::Statement`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Scatter {
    /// The convention of the statement: a vector in a cube, from three random numbers. `render-aos` and `render-soa`
    /// use it.
    #[default]
    Statement,
    /// The convention of the published pictures: a vector of length one, drawn by rejection. For metal it is multiplied
    /// by the diffusion.
    Published,
    /// Deterministic mode, to compare implementations. Each pixel has one sample, through its middle, and all random
    /// vectors are null. `samples_per_pixel` is ignored, and no random number is drawn.
    Deterministic,
}

/// Returns a random vector of length one. `draw` gives random vectors in the cube around the unit ball. The first of
/// them that lies in the ball, with a squared length above 1e-160, is scaled to length one.
#[inline(always)]
pub(crate) fn unit_vector(mut draw: impl FnMut() -> Vec3) -> Vec3 {
    loop {
        let vector = draw();
        let length_squared = vector.dot(vector);
        if length_squared > 1e-160 && length_squared <= 1.0 {
            return vector / length_squared.sqrt();
        }
    }
}

/// The stream of random vectors that all materials share, drawn one at a time.
#[derive(Clone, Debug)]
pub struct ScatterVectors {
    convention: Scatter,
    draws: Uniform,
    words: u64,
}

impl ScatterVectors {
    /// Returns the stream of the given convention, with a generator that starts from `seed`.
    pub(crate) fn new(convention: Scatter, seed: u64) -> Self {
        Self { convention, draws: Uniform::new(seed), words: 0 }
    }

    /// Returns how many words of the generator all vectors so far have taken. A draw takes one word, so this is the
    /// place in the stream at which the next vector starts.
    pub(crate) const fn words(&self) -> u64 {
        self.words
    }

    /// Returns the next vector. `diffusion` is that of a metal surface, and 1 for a matte one. It is half the side of
    /// the cube in the statement's convention, and the vector's length in the published one.
    #[inline]
    pub(crate) fn next(&mut self, diffusion: f64) -> Vec3 {
        let mut in_cube = |half: f64| {
            self.words += DRAWS_OF_SCATTER_SAMPLE as u64;
            Vec3::from([(); DRAWS_OF_SCATTER_SAMPLE].map(|()| self.draws.draw(-half, half)))
        };
        match self.convention {
            Scatter::Statement => in_cube(diffusion),
            Scatter::Published => unit_vector(|| in_cube(1.0)) * diffusion,
            Scatter::Deterministic => Vec3::ZERO,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_statements_vectors_fill_a_cube_three_draws_each() {
        let mut vectors = ScatterVectors::new(Scatter::Statement, 13);
        let mut draws = Uniform::new(13);
        for diffusion in [1.0, 2.0, 0.0] {
            let expected = Vec3::from([(); 3].map(|()| draws.draw(-diffusion, diffusion)));
            assert_eq!(vectors.next(diffusion), expected);
        }
    }

    #[test]
    fn the_published_vectors_have_the_given_length() {
        let mut vectors = ScatterVectors::new(Scatter::Published, 13);
        for _ in 0..1000 {
            assert!((vectors.next(1.0).length() - 1.0).abs() < 1e-15);
            assert!((vectors.next(2.5).length() - 2.5).abs() < 1e-14);
        }
    }

    #[test]
    fn a_published_vector_is_the_first_draw_in_the_ball_scaled_to_the_given_length() {
        let (mut vectors, mut draws) = (ScatterVectors::new(Scatter::Published, 13), Uniform::new(13));
        let mut rejected = 0;
        for count in 1..=1000 {
            let expected = loop {
                let [x, y, z] = [(); 3].map(|()| draws.draw(-1.0, 1.0));
                let squared: f64 = x * x + y * y + z * z;
                if squared <= 1.0 {
                    break Vec3::new(x, y, z) / squared.sqrt() * 2.0;
                }
                rejected += 1;
            };
            assert_eq!(vectors.next(2.0), expected);
            assert_eq!(vectors.words(), 3 * (count + rejected), "three words for each vector, accepted or rejected");
        }
        assert!(rejected > 0, "the cube is larger than the ball");
    }

    #[test]
    fn deterministic_vectors_are_null() {
        assert_eq!(ScatterVectors::new(Scatter::Deterministic, 1).next(3.0), Vec3::ZERO);
    }
}
