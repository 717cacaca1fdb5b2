//! The stream of scatter samples that all materials share. The samples are made in bulk with the widest instruction
//! set, even if the path tracing loop is compiled for another one. The order is that of
//! [`draw_order`](crate::sampling::draw_order).

use crate::sampling::{
    block::BlockUniform, draw_order::DRAWS_OF_SCATTER_SAMPLE, scatter_vectors::Scatter, scatter_vectors::unit_vector,
};
use crate::{
    counters::Counter, counters::add, math::vec3::Vec3, simd::Kernel, simd::Simd, simd::SimdF64, simd::columns::Columns,
};

/// Room before the new samples for the old ones that are not taken yet.
const SLACK: usize = 16;
/// Samples made at a time.
const MADE: usize = 512;
/// Least number of samples that can be taken after [`ScatterSamples::prepare`].
pub const RESERVE: usize = 12;
/// Length of the arrays of samples.
const ROOM: usize = SLACK + MADE;

/// The scatter samples, in order: draws in `[0, 1)` for the statement's convention, vectors of length one for the
/// published images', null vectors in deterministic mode.
/// [`ScatterParams`](crate::materials::scatter::ScatterParams) turn one into a random vector.
#[derive(Debug)]
pub struct ScatterSamples {
    convention: Scatter,
    generator: BlockUniform,
    draws: [f64; DRAWS_OF_SCATTER_SAMPLE * MADE],
    samples: Columns<DRAWS_OF_SCATTER_SAMPLE, ROOM>,
    /// Index of the next sample.
    next: usize,
    /// How many of the stream's samples came before index 0.
    before: u64,
}

impl ScatterSamples {
    /// Returns the stream of the given convention, whose generator starts from `seed`. No sample is made yet.
    pub fn new(convention: Scatter, seed: u64) -> Self {
        let draws = [0.0; DRAWS_OF_SCATTER_SAMPLE * MADE];
        Self { convention, generator: BlockUniform::new(seed), draws, samples: Columns::ZERO, next: ROOM, before: 0 }
    }

    /// Makes samples if fewer than [`RESERVE`] are left.
    #[inline(always)]
    pub fn prepare<S: Simd>(&mut self, simd: S) {
        if self.next > ROOM - RESERVE {
            simd.run(Make(self));
        }
    }

    /// Takes the next sample. At most [`RESERVE`] may be taken between two calls of [`ScatterSamples::prepare`].
    #[inline(always)]
    pub fn next(&mut self) -> Vec3 {
        let sample = self.samples.get(self.next).into();
        self.skip(1);
        sample
    }

    /// The position of the next sample in the stream, plus a constant. It serves to compare positions.
    #[inline(always)]
    pub const fn position(&self) -> u64 {
        self.before.wrapping_add(self.next as u64)
    }

    /// The next samples, one in each lane. None of them is taken.
    #[inline(always)]
    pub fn peek<V: SimdF64>(&self) -> Vec3<V> {
        self.samples.load(self.next).into()
    }

    /// Takes `count` samples without returning them.
    #[inline(always)]
    pub fn skip(&mut self, count: usize) {
        add(Counter::ScatterSamples, count as u64);
        self.next += count;
    }
}

/// Makes the next samples.
struct Make<'a>(&'a mut ScatterSamples);

impl Kernel for Make<'_> {
    type Output = ();

    #[inline(always)]
    fn call<S: Simd>(self, _: S) {
        let ScatterSamples { convention, generator, draws, samples, next, before } = self.0;
        let kept = ROOM - *next;
        for column in &mut samples.0 {
            column.copy_within(ROOM - kept.., SLACK - kept);
        }
        *next = SLACK - kept;
        *before = before.wrapping_add(MADE as u64);
        match convention {
            Scatter::Statement => {
                add(Counter::MaterialDraws, draws.len() as u64);
                generator.fill(draws);
            }
            Scatter::Published => {
                for sample in draws.chunks_exact_mut(DRAWS_OF_SCATTER_SAMPLE) {
                    sample.copy_from_slice(&unit_vector(|| in_cube(generator)).to_array());
                }
            }
            Scatter::Deterministic => {}
        }
        for (at, &sample) in draws.as_chunks().0.iter().enumerate() {
            samples.set(SLACK + at, sample);
        }
    }
}

/// A vector in the cube that [`unit_vector`] scales or rejects.
#[inline(always)]
fn in_cube(generator: &mut BlockUniform) -> Vec3 {
    let mut draws = [0.0; DRAWS_OF_SCATTER_SAMPLE];
    add(Counter::MaterialDraws, draws.len() as u64);
    generator.fill(&mut draws);
    Vec3::from(draws).map(|u| u * 2.0 + -1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sampling::scatter_vectors::ScatterVectors;
    use crate::simd::portable::Portable;

    #[test]
    fn samples_in_bulk_are_the_vectors_drawn_singly() {
        for convention in [Scatter::Published, Scatter::Deterministic] {
            let (mut bulk, mut single) = (ScatterSamples::new(convention, 3), ScatterVectors::new(convention, 3));
            for _ in 0..3 * MADE {
                bulk.prepare(Portable);
                assert_eq!(bulk.next(), single.next(1.0));
            }
        }
        let (mut bulk, mut single) =
            (ScatterSamples::new(Scatter::Statement, 3), ScatterVectors::new(Scatter::Statement, 3));
        for _ in 0..3 * MADE {
            bulk.prepare(Portable);
            assert_eq!(bulk.next().map(|u| u * 2.0 - 1.0), single.next(1.0));
        }
    }

    #[test]
    fn lanes_see_the_next_samples_and_take_none() {
        type V = <Portable as Simd>::F64;
        let (mut lanes, mut single) =
            (ScatterSamples::new(Scatter::Statement, 3), ScatterSamples::new(Scatter::Statement, 3));
        for round in 0..2 * MADE {
            lanes.prepare(Portable);
            let mut seen = [0.0; V::LANES];
            lanes.peek::<V>().y.store(&mut seen);
            let used = round % V::LANES;
            lanes.skip(used);
            for &y in &seen[..used] {
                single.prepare(Portable);
                assert_eq!(single.next().y, y);
            }
        }
    }
}
