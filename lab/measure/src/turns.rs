//! Measures several pieces of work in turn.

use crate::clock::own_seconds;
use crate::statistics::Median;

/// The smallest user time of one measurement, in seconds. The system's clock of user time may be coarse.
pub const SHORTEST: f64 = 0.05;

/// Returns how many times to repeat work of `seconds` in one measurement, so that it takes at least [`SHORTEST`]; at
/// most 500.
#[must_use]
pub fn turns_of(seconds: f64) -> u32 {
    (SHORTEST / seconds.max(SHORTEST / 500.0)).ceil().max(1.0) as u32
}

/// Returns the order of measurements in turn: every index below `count` in each of `rounds` rounds. Each round starts
/// with a different index, so that a slow phase of the machine affects all of them.
pub fn order(rounds: usize, count: usize) -> impl Iterator<Item = usize> {
    (0..rounds).flat_map(move |round| (0..count).map(move |place| (place + round) % count))
}

/// Returns the seconds of `work(index)` for each index of `turns`, by `clock`, a function that returns the seconds
/// until now. Each index has `rounds` times, measured in the [`order`] of turns. Each time is the mean of
/// `turns[index]` calls.
///
/// # Errors
/// An error of `work`.
pub fn in_turn<E>(
    rounds: usize,
    turns: &[u32],
    clock: fn() -> f64,
    mut work: impl FnMut(usize) -> Result<(), E>,
) -> Result<Vec<Vec<f64>>, E> {
    let mut times: Vec<Vec<f64>> = vec![Vec::with_capacity(rounds); turns.len()];
    for index in order(rounds, turns.len()) {
        let before = clock();
        for _ in 0..turns[index] {
            work(index)?;
        }
        times[index].push((clock() - before) / f64::from(turns[index]));
    }
    Ok(times)
}

/// Returns the median of the rounds' ratios `one / other`, with its bounds. The times must come from the same rounds.
///
/// # Panics
/// If there is no round.
#[must_use]
pub fn ratio(one: &[f64], other: &[f64]) -> Median {
    Median::of(&one.iter().zip(other).map(|(one, other)| one / other).collect::<Vec<_>>())
}

/// Returns the mean user time of one call of `work`, in seconds. The work is repeated until it has taken [`SHORTEST`].
pub fn seconds_of(mut work: impl FnMut()) -> f64 {
    let before = own_seconds();
    let mut turns = 0.0;
    loop {
        work();
        turns += 1.0;
        let seconds = own_seconds() - before;
        if seconds >= SHORTEST {
            return seconds / turns;
        }
    }
}

/// Measures `one` and `other` in turn, `rounds` times. Returns the median seconds of `one`, the median seconds of
/// `other`, and the median of the rounds' ratios `other / one`.
pub fn compare(rounds: usize, mut one: impl FnMut(), mut other: impl FnMut()) -> [f64; 3] {
    let times: Vec<_> = (0..rounds).map(|_| [seconds_of(&mut one), seconds_of(&mut other)]).collect();
    let [one, other] = [0, 1].map(|place| times.iter().map(|times| times[place]).collect::<Vec<_>>());
    [Median::of(&one).median, Median::of(&other).median, ratio(&other, &one).median]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn work(steps: u64) {
        let sum = (0..steps).fold(1_u64, |sum, step| std::hint::black_box(sum.wrapping_mul(3) ^ step));
        std::hint::black_box(sum);
    }

    #[test]
    fn twice_the_work_takes_longer() {
        let [fast, slow, ratio] = compare(3, || work(20_000), || work(400_000));
        assert!(fast > 0.0 && slow > 4.0 * fast && ratio > 4.0, "{fast} {slow} {ratio}");
    }

    #[test]
    fn every_round_measures_all_and_begins_with_another() {
        let mut order = Vec::new();
        let times = in_turn(
            3,
            &[1, 2],
            || 0.0,
            |index| {
                order.push(index);
                Ok::<(), ()>(())
            },
        );
        assert_eq!(times.map(|times| times.iter().map(Vec::len).collect::<Vec<_>>()), Ok(vec![3, 3]));
        assert_eq!(order, [0, 1, 1, 1, 1, 0, 0, 1, 1]);
        assert_eq!(in_turn(1, &[1], || 0.0, |_| Err("it fails")), Err("it fails"));
    }

    #[test]
    fn short_work_is_repeated() {
        assert_eq!([turns_of(1.0), turns_of(0.05), turns_of(0.01), turns_of(0.0)], [1, 1, 5, 500]);
        let ratio = ratio(&[2.0, 6.0, 4.0], &[1.0, 2.0, 2.0]);
        assert_eq!((ratio.median, ratio.low, ratio.high), (2.0, 2.0, 3.0));
    }
}
