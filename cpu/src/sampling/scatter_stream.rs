//! The stream of random triples that all materials share, made in bulk: with the widest instruction set, whatever their
//! taker is compiled for.

use crate::counters::{Counter, add};
use crate::math::vec3::Vec3;
use crate::sampling::block::BlockUniform;
use crate::sampling::scatter_vectors::Scatter;
use crate::simd::{Kernel, Simd, SimdF64};

/// Room before the new triples for those that are left over.
const SLACK: usize = 16;
/// Triples made at a time.
const TRIPLES: usize = 512;
/// Triples that there are at least after [`ScatterSamples::prepare`].
pub const RESERVE: usize = 12;
/// Places for them: those that are left over come before.
const PLACES: usize = SLACK + TRIPLES;

/// The triples, in order: draws in `[0, 1)` for the statement's convention, vectors of length one for the published
/// images', null vectors in deterministic mode. A [`PreparedMaterial`](crate::materials::prepared::PreparedMaterial)
/// makes a random vector of each.
#[derive(Debug)]
pub struct ScatterSamples {
    convention: Scatter,
    draws: BlockUniform,
    raw: [f64; 3 * TRIPLES],
    x: [f64; PLACES],
    y: [f64; PLACES],
    z: [f64; PLACES],
    next: usize,
    /// How many of the stream's triples came before the first place.
    before: u64,
}

impl ScatterSamples {
    /// Returns the stream of the given convention, whose generator starts from `seed`. No sample is made yet.
    pub fn new(convention: Scatter, seed: u64) -> Self {
        let (raw, empty) = ([0.0; 3 * TRIPLES], [0.0; PLACES]);
        Self { convention, draws: BlockUniform::new(seed), raw, x: empty, y: empty, z: empty, next: PLACES, before: 0 }
    }

    /// Makes triples unless there are [`RESERVE`].
    #[inline(always)]
    pub fn prepare<S: Simd>(&mut self, simd: S) {
        if self.next > PLACES - RESERVE {
            simd.run(Make(self));
        }
    }

    /// The next triple, which is used up. At most [`RESERVE`] are used between two calls of
    /// [`ScatterSamples::prepare`].
    #[inline(always)]
    pub fn next(&mut self) -> Vec3 {
        let triple = Vec3::new(self.x[self.next], self.y[self.next], self.z[self.next]);
        add(Counter::VectorsTaken, 1);
        self.next += 1;
        triple
    }

    /// Where in the stream the next triple stands, counted from anywhere.
    #[inline(always)]
    pub const fn position(&self) -> u64 {
        self.before.wrapping_add(self.next as u64)
    }

    /// The next triples, a lane each. None is used up.
    #[inline(always)]
    pub fn following<V: SimdF64>(&self) -> Vec3<V> {
        let at = self.next;
        Vec3::new(V::load(&self.x[at..]), V::load(&self.y[at..]), V::load(&self.z[at..]))
    }

    /// Uses up `count` triples.
    #[inline(always)]
    pub fn skip(&mut self, count: usize) {
        add(Counter::VectorsTaken, count as u64);
        self.next += count;
    }

    #[inline(always)]
    fn make(&mut self) {
        let kept = PLACES - self.next;
        for place in [&mut self.x, &mut self.y, &mut self.z] {
            place.copy_within(PLACES - kept.., SLACK - kept);
        }
        self.next = SLACK - kept;
        self.before = self.before.wrapping_add(TRIPLES as u64);
        match self.convention {
            Scatter::Statement => {
                add(Counter::MaterialDraws, self.raw.len() as u64);
                self.draws.fill(&mut self.raw);
            }
            Scatter::Published => {
                for place in self.raw.chunks_exact_mut(3) {
                    place.copy_from_slice(&unit_vector(&mut self.draws).to_array());
                }
            }
            Scatter::Deterministic => {}
        }
        for (at, triple) in self.raw.chunks_exact(3).enumerate() {
            self.x[SLACK + at] = triple[0];
            self.y[SLACK + at] = triple[1];
            self.z[SLACK + at] = triple[2];
        }
    }
}

/// Makes the next triples.
struct Make<'a>(&'a mut ScatterSamples);

impl Kernel for Make<'_> {
    type Output = ();

    #[inline(always)]
    fn call<S: Simd>(self, _: S) {
        self.0.make();
    }
}

/// See [`crate::sampling::scatter_vectors::ScatterVectors`]: the same rejection, from a stream in bulk.
#[inline(always)]
fn unit_vector(draws: &mut BlockUniform) -> Vec3 {
    loop {
        let mut triple = [0.0; 3];
        add(Counter::MaterialDraws, 3);
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
    use crate::sampling::scatter_vectors::ScatterVectors;
    use crate::simd::portable::Portable;

    #[test]
    fn triples_in_bulk_are_the_ones_drawn_singly() {
        for convention in [Scatter::Published, Scatter::Deterministic] {
            let (mut bulk, mut single) = (ScatterSamples::new(convention, 3), ScatterVectors::new(convention, 3));
            for _ in 0..3 * TRIPLES {
                bulk.prepare(Portable);
                assert_eq!(bulk.next(), single.next(1.0));
            }
        }
        let (mut bulk, mut single) =
            (ScatterSamples::new(Scatter::Statement, 3), ScatterVectors::new(Scatter::Statement, 3));
        for _ in 0..3 * TRIPLES {
            bulk.prepare(Portable);
            assert_eq!(bulk.next().map(|u| u * 2.0 - 1.0), single.next(1.0));
        }
    }

    #[test]
    fn lanes_see_the_triples_that_follow_and_use_none_up() {
        type V = <Portable as Simd>::F64;
        let (mut lanes, mut single) =
            (ScatterSamples::new(Scatter::Statement, 3), ScatterSamples::new(Scatter::Statement, 3));
        for round in 0..2 * TRIPLES {
            lanes.prepare(Portable);
            let mut seen = [0.0; V::LANES];
            lanes.following::<V>().y.store(&mut seen);
            let used = round % V::LANES;
            lanes.skip(used);
            for &y in &seen[..used] {
                single.prepare(Portable);
                assert_eq!(single.next().y, y);
            }
        }
    }
}
