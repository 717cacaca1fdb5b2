//! The stream of random triples that all materials share, made in bulk.

use crate::rng::BlockUniform;
use crate::scatter::Scatter;
use crate::vec3::Vec3;

/// Triples made at a time.
const TRIPLES: usize = 512;

/// The triples, in order: draws in `[0, 1)` for the statement's convention, vectors of length one for the published
/// images', null vectors in deterministic mode. A [`Finish`](crate::prepare::Finish) makes a random vector of each.
#[derive(Debug)]
pub struct Triples {
    convention: Scatter,
    draws: BlockUniform,
    made: Box<[f64; 3 * TRIPLES]>,
    used: usize,
}

impl Triples {
    /// The stream of `convention` from a seed.
    pub fn new(convention: Scatter, seed: u64) -> Self {
        let made = Box::new([0.0; 3 * TRIPLES]);
        Self { convention, draws: BlockUniform::new(seed), made, used: 3 * TRIPLES }
    }

    /// The next triple.
    #[inline(always)]
    pub fn next(&mut self) -> Vec3 {
        if self.used == 3 * TRIPLES {
            self.make();
        }
        let triple = Vec3::new(self.made[self.used], self.made[self.used + 1], self.made[self.used + 2]);
        self.used += 3;
        triple
    }

    #[inline(always)]
    fn make(&mut self) {
        self.used = 0;
        match self.convention {
            Scatter::Statement => self.draws.fill(&mut self.made[..]),
            Scatter::Published => {
                for place in self.made.chunks_exact_mut(3) {
                    place.copy_from_slice(&unit_vector(&mut self.draws).to_array());
                }
            }
            Scatter::Deterministic => {}
        }
    }
}

/// See [`crate::scatter::ScatterVectors`]: the same rejection, from a stream in bulk.
#[inline(always)]
fn unit_vector(draws: &mut BlockUniform) -> Vec3 {
    loop {
        let mut triple = [0.0; 3];
        draws.fill(&mut triple);
        let vector = Vec3::from(triple).map(|u| u * 2.0 + -1.0);
        let length_squared = vector.dot(vector);
        if length_squared > 1e-160 && length_squared <= 1.0 {
            return vector / length_squared.sqrt();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scatter::ScatterVectors;

    #[test]
    fn triples_in_bulk_are_the_ones_drawn_singly() {
        for convention in [Scatter::Published, Scatter::Deterministic] {
            let (mut bulk, mut single) = (Triples::new(convention, 3), ScatterVectors::new(convention, 3));
            for _ in 0..3 * TRIPLES {
                assert_eq!(bulk.next(), single.next(1.0));
            }
        }
        let (mut bulk, mut single) = (Triples::new(Scatter::Statement, 3), ScatterVectors::new(Scatter::Statement, 3));
        for _ in 0..3 * TRIPLES {
            assert_eq!(bulk.next().map(|u| u * 2.0 - 1.0), single.next(1.0));
        }
    }
}
