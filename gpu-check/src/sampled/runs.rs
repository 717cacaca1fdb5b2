//! How a picture with random numbers is divided into runs.

use super::streams::ENTRIES_OF_SAMPLE;

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
