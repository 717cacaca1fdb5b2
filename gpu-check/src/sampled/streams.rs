//! The words of the two random generators, in the form of the buffer `words` of `scatter_vectors.wgsl`.

use std::collections::VecDeque;

use rand_mt::Mt64;

use super::Recording;

/// Number of entries of the buffer for each sample: two words for the position in the pixel, and the index of the first
/// word of the scatter vectors.
pub const ENTRIES_OF_SAMPLE: u64 = 3;

/// A stream of words: given ones first, if there are any, and then those of a generator.
#[derive(Clone, Debug)]
pub struct Words {
    given: VecDeque<u64>,
    generator: Mt64,
}

impl Words {
    /// Returns the stream of the generator `std::mt19937_64(seed)`, with the words `given` before it.
    #[must_use]
    pub fn new(given: impl IntoIterator<Item = u64>, seed: u64) -> Self {
        Self { given: given.into_iter().collect(), generator: Mt64::new(seed) }
    }

    /// Returns the next word.
    pub fn next_word(&mut self) -> u64 {
        self.given.pop_front().unwrap_or_else(|| self.generator.next_u64())
    }
}

/// Both streams of a picture, at the places where the next run starts.
#[derive(Clone, Debug)]
pub struct Streams {
    /// The stream of positions in pixels.
    pub jitter: Words,
    /// The stream of scatter vectors.
    pub scatter: Words,
}

impl Streams {
    /// Returns the streams of a recording, at their beginning.
    #[must_use]
    pub fn new(recording: &Recording) -> Self {
        let [jitter, scatter] = [recording.ray_rng_seed, recording.material_rng_seed].map(|seed| Words::new([], seed));
        Self { jitter, scatter }
    }

    /// Returns the buffer of a run whose samples take `counts` words from the stream of scatter vectors. `spare` more
    /// words of this stream follow, for paths that take more than that. The next run starts without the spare words.
    pub fn next_run(&mut self, counts: &[u32], spare: u64) -> Vec<[u32; 2]> {
        let mut entries = Vec::new();
        // An index fits in 32 bits, because a device binds less than 2^35 bytes.
        let mut index = ENTRIES_OF_SAMPLE as u32 * counts.len() as u32;
        for count in counts {
            entries.extend([halves(self.jitter.next_word()), halves(self.jitter.next_word()), [index, 0]]);
            index = index.saturating_add(*count);
        }
        let taken = counts.iter().map(|count| u64::from(*count)).sum();
        entries.extend((0..taken).map(|_| halves(self.scatter.next_word())));
        let mut ahead = self.scatter.clone();
        entries.extend((0..spare).map(|_| halves(ahead.next_word())));
        entries
    }
}

/// Returns the lower and the upper half of a word.
pub(crate) const fn halves(word: u64) -> [u32; 2] {
    [word as u32, (word >> 32) as u32]
}

/// The limits of one run.
#[derive(Clone, Copy, Debug)]
pub(super) struct Limits {
    /// Largest number of samples.
    pub samples: u64,
    /// Largest number of entries of the buffer `words`, without the spare ones.
    pub entries: u64,
}

/// Returns how many of the next samples one run traces, at least one. `counts` has the numbers of words that these
/// samples take from the stream of scatter vectors.
pub(super) fn samples_of_a_run(counts: &[u32], limits: Limits) -> usize {
    let mut entries = 0;
    let fits = |count: &&u32| {
        entries += ENTRIES_OF_SAMPLE + u64::from(**count);
        entries <= limits.entries
    };
    let most = usize::try_from(limits.samples).unwrap_or(usize::MAX);
    counts.iter().take(most).take_while(fits).count().max(1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sampled::Convention;
    use std::time::Duration;

    #[test]
    fn a_run_continues_the_streams_and_repeats_the_spare_words() {
        let recording = Recording {
            convention: Convention::Statement,
            samples_per_pixel: 2,
            ray_rng_seed: 19,
            material_rng_seed: 13,
            means: Vec::new(),
            words: vec![3, 0, 6],
            time: Duration::ZERO,
        };
        let mut streams = Streams::new(&recording);
        let (first, second) = (streams.next_run(&[3, 0], 2), streams.next_run(&[6], 1));
        let (mut jitter, mut scatter) = (Mt64::new(19), Mt64::new(13));
        let mut place = || halves(jitter.next_u64());
        let mut vector = || halves(scatter.next_u64());
        let places = [place(), place(), [6, 0], place(), place(), [9, 0]];
        let vectors: Vec<_> = (0..10).map(|_| vector()).collect();
        assert_eq!(first, [&places[..], &vectors[..5]].concat());
        assert_eq!(second, [&[place(), place(), [3, 0]], &vectors[3..]].concat());
        assert_eq!(halves(0x0123_4567_89AB_CDEF), [0x89AB_CDEF, 0x0123_4567]);
    }

    #[test]
    fn a_run_ends_at_either_limit_and_has_at_least_one_sample() {
        let counts = [3, 0, 6, 3, 3];
        let taken = |samples, entries| samples_of_a_run(&counts, Limits { samples, entries });
        assert_eq!(taken(4, 1000), 4);
        assert_eq!(taken(9, 1000), 5);
        assert_eq!((taken(9, 9), taken(9, 17), taken(9, 18)), (2, 2, 3));
        assert_eq!(taken(9, 1), 1);
    }
}
