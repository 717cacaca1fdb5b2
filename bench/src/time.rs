//! Measures user time, and compares two ways to do the same work.

use nix::sys::resource::{UsageWho, getrusage};

/// Shortest user time of one measurement, in seconds. Shorter work is repeated, because the system's clock may be
/// coarse.
const SHORTEST: f64 = 0.05;

/// Returns the user time of this process since its start, in seconds.
#[must_use]
pub fn user_seconds() -> f64 {
    // `getrusage` fails only for an unknown `who`.
    let time = getrusage(UsageWho::RUSAGE_SELF).expect("a process may ask about itself").user_time();
    time.tv_sec() as f64 + time.tv_usec() as f64 * 1e-6
}

/// Returns the mean user time of one call of `work`, in seconds. The work is repeated until it has taken `SHORTEST`.
pub fn seconds_of(mut work: impl FnMut()) -> f64 {
    let before = user_seconds();
    let mut turns = 0.0;
    loop {
        work();
        turns += 1.0;
        let seconds = user_seconds() - before;
        if seconds >= SHORTEST {
            return seconds / turns;
        }
    }
}

/// Measures `one` and `other` in turn, `rounds` times. Returns the median seconds of `one`, the median seconds of
/// `other`, and the median of the rounds' ratios `other / one`.
pub fn compare(rounds: usize, mut one: impl FnMut(), mut other: impl FnMut()) -> [f64; 3] {
    let times: Vec<_> = (0..rounds).map(|_| [seconds_of(&mut one), seconds_of(&mut other)]).collect();
    let of = |value: fn(&[f64; 2]) -> f64| median(times.iter().map(value).collect());
    [of(|times| times[0]), of(|times| times[1]), of(|times| times[1] / times[0])]
}

/// Returns the median of `values`, which must not be empty.
#[must_use]
pub fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    (values[(values.len() - 1) / 2] + values[values.len() / 2]) / 2.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_median_is_in_the_middle() {
        assert_eq!(median(vec![3.0, 1.0, 2.0]), 2.0);
        assert_eq!(median(vec![4.0, 1.0, 3.0, 2.0]), 2.5);
    }

    #[test]
    fn twice_the_work_takes_longer() {
        let work = |steps: u64| {
            let sum = (0..steps).fold(1_u64, |sum, step| std::hint::black_box(sum.wrapping_mul(3) ^ step));
            std::hint::black_box(sum);
        };
        let [fast, slow, ratio] = compare(3, || work(20_000), || work(400_000));
        assert!(fast > 0.0 && slow > 4.0 * fast && ratio > 4.0, "{fast} {slow} {ratio}");
    }
}
