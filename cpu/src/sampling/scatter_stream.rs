//! The stream of scatter samples that all materials share, in the order of [`draw_order`](crate::sampling::draw_order).
//! The samples are made 512 at a time with the picture's instruction set. The path tracing loop may be compiled for a
//! narrower one ([`Simd::run_promptly`]).

use crate::sampling::{
    block::BlockUniform, draw_order::DRAWS_OF_SCATTER_SAMPLE, scatter_vectors::Scatter, scatter_vectors::unit_vector,
};
use crate::{
    counters::Counter, counters::add, math::vec3::Vec3, simd::Kernel, simd::Simd, simd::SimdF64,
    simd::columns::Columns, simd::instruction_set::InstructionSet,
};

/// Number of places at the front of the buffer that are kept free for samples left over from the last filling. Before
/// the buffer is filled again, the samples left over, fewer than [`RESERVE`], move to the end of these places. The new
/// samples follow them directly.
const PLACES_FOR_OLD: usize = 16;
/// Number of samples that are made at a time.
const MADE: usize = 512;
/// Number of samples that can always be taken after [`ScatterSamples::prepare`].
pub const RESERVE: usize = 12;
/// Number of places for samples: those for old samples, then those for new ones.
const HELD_SAMPLES: usize = PLACES_FOR_OLD + MADE;

/// The scatter samples, in order. In the statement's convention a sample is three random numbers in `[0, 1)`. In the
/// published convention it is a vector of length one, and in deterministic mode a null vector.
/// [`ScatterParams`](crate::materials::scatter::ScatterParams) turns a sample into a random vector.
#[derive(Debug)]
pub struct ScatterSamples {
    convention: Scatter,
    /// The instruction set that makes the samples: the one that renders the picture.
    set: InstructionSet,
    generator: BlockUniform,
    draws: [f64; DRAWS_OF_SCATTER_SAMPLE * MADE],
    samples: Columns<DRAWS_OF_SCATTER_SAMPLE, HELD_SAMPLES>,
    /// Index of the next sample.
    next: usize,
    /// Number of the stream's samples that came before index 0, plus a constant.
    before: u64,
}

impl ScatterSamples {
    /// Returns the stream of the given convention, with a generator that starts from `seed`. No sample is made yet.
    pub fn new(convention: Scatter, seed: u64, set: InstructionSet) -> Self {
        let (generator, draws) = (BlockUniform::new(seed), [0.0; DRAWS_OF_SCATTER_SAMPLE * MADE]);
        Self { convention, set, generator, draws, samples: Columns::ZERO, next: HELD_SAMPLES, before: 0 }
    }

    /// Calls `visit` with each word of the stream's state: of the generator, and of the samples that are made.
    pub(crate) fn visit(&mut self, visit: &mut impl FnMut(&mut u64)) {
        self.generator.visit(visit);
        let mut next = self.next as u64;
        visit(&mut next);
        self.next = HELD_SAMPLES.min(next as usize);
        for number in self.samples.0.as_flattened_mut() {
            let mut bits = number.to_bits();
            visit(&mut bits);
            *number = f64::from_bits(bits);
        }
    }

    /// Makes new samples if fewer than [`RESERVE`] are left.
    #[inline(always)]
    pub fn prepare(&mut self) {
        if self.next > HELD_SAMPLES - RESERVE {
            self.make();
        }
    }

    /// Makes new samples. This function is not inlined, so that the code that selects the instruction set exists once.
    #[cold]
    #[inline(never)]
    fn make(&mut self) {
        self.set.run(Make(self));
    }

    /// Takes the next sample. At most [`RESERVE`] samples may be taken between two calls of
    /// [`ScatterSamples::prepare`].
    #[inline(always)]
    #[cfg_attr(feature = "internals", expect(clippy::should_implement_trait, reason = "the stream has no end"))]
    pub fn next(&mut self) -> Vec3 {
        let sample = self.samples.get(self.next).into();
        self.skip(1);
        sample
    }

    /// Returns the position of the next sample in the stream, plus an unknown constant. Only differences of two
    /// positions have a meaning.
    #[inline(always)]
    pub(crate) const fn position(&self) -> u64 {
        self.before.wrapping_add(self.next as u64)
    }

    /// Returns the number of samples that were taken. It is right only for a stream that has not been
    /// [visited](ScatterSamples::visit) to replace its state.
    #[cfg(any(feature = "internals", test))]
    pub(crate) const fn taken(&self) -> u64 {
        self.position().wrapping_sub(HELD_SAMPLES as u64)
    }

    /// Returns the next samples, one in each lane. None of them is taken.
    #[inline(always)]
    pub(crate) fn peek<V: SimdF64>(&self) -> Vec3<V> {
        self.samples.load(self.next).into()
    }

    /// Takes `count` samples without returning them.
    #[inline(always)]
    pub(crate) fn skip(&mut self, count: usize) {
        add(Counter::ScatterSamples, count as u64);
        self.next += count;
    }
}

/// A kernel that makes the next [`MADE`] samples.
struct Make<'a>(&'a mut ScatterSamples);

impl Kernel for Make<'_> {
    type Output = ();

    #[inline(always)]
    fn call<S: Simd>(self, _: S) {
        let ScatterSamples { convention, generator, draws, samples, next, before, .. } = self.0;
        let kept = HELD_SAMPLES - *next;
        for column in &mut samples.0 {
            column.copy_within(HELD_SAMPLES - kept.., PLACES_FOR_OLD - kept);
        }
        *next = PLACES_FOR_OLD - kept;
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
            samples.set(PLACES_FOR_OLD + at, sample);
        }
    }
}

/// Returns a random vector in the cube `[-1, 1)^3`, which [`unit_vector`] scales or rejects.
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
    fn samples_in_bulk_are_the_vectors_drawn_singly_on_every_instruction_set() {
        for set in InstructionSet::available() {
            for convention in [Scatter::Statement, Scatter::Published, Scatter::Deterministic] {
                let (mut bulk, mut single) =
                    (ScatterSamples::new(convention, 3, set), ScatterVectors::new(convention, 3));
                for _ in 0..3 * MADE {
                    bulk.prepare();
                    let is_in_unit_cube = convention == Scatter::Statement;
                    let sample = bulk.next().map(|u| if is_in_unit_cube { u * 2.0 - 1.0 } else { u });
                    assert_eq!(sample, single.next(1.0), "{convention:?}, {}", set.name());
                }
            }
        }
    }

    #[test]
    fn lanes_see_the_next_samples_and_take_none() {
        type V = <Portable as Simd>::F64;
        let new = || ScatterSamples::new(Scatter::Statement, 3, InstructionSet::Portable);
        let (mut lanes, mut single) = (new(), new());
        for round in 0..2 * MADE {
            lanes.prepare();
            let mut seen = [0.0; V::LANES];
            lanes.peek::<V>().y.store(&mut seen);
            let used = round % V::LANES;
            lanes.skip(used);
            for &y in &seen[..used] {
                single.prepare();
                assert_eq!(single.next().y, y);
            }
        }
    }
}
