//! The median of repeated measurements, with its bounds.

use serde::{Deserialize, Serialize};

/// The median of some measurements, and bounds for the true median, which is the median of infinitely many
/// measurements.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Median {
    /// The middle measurement, or the mean of the two middle ones.
    pub median: f64,
    /// Lower bound of the true median.
    pub low: f64,
    /// Upper bound of the true median.
    pub high: f64,
    /// Probability that the true median lies between the bounds, for any distribution. It is at least 0.95 with six or
    /// more measurements, and less with fewer.
    pub confidence: f64,
}

impl Median {
    /// Returns the median of `values` with bounds from order statistics. The true median lies between the k-th smallest
    /// and the k-th largest value, unless fewer than k values fall on one side of it.
    ///
    /// # Panics
    /// If `values` is empty.
    #[must_use]
    pub fn of(values: &[f64]) -> Self {
        let mut sorted = values.to_vec();
        sorted.sort_by(f64::total_cmp);
        let count = sorted.len();
        assert!(count > 0, "nothing was measured");
        // `chance` is the probability that exactly `index` of the values lie below the true median: binomial, with
        // probability 1/2 for each value.
        let mut chance = 0.5_f64.powi(i32::try_from(count).unwrap_or(i32::MAX));
        let (mut below, mut best) = (chance, (0, 1.0 - 2.0 * chance));
        for index in 1..count / 2 {
            chance *= (count - index + 1) as f64 / index as f64;
            below += chance;
            if 1.0 - 2.0 * below < 0.95 {
                break;
            }
            best = (index, 1.0 - 2.0 * below);
        }
        let (outside, confidence) = best;
        let median = (sorted[(count - 1) / 2] + sorted[count / 2]) / 2.0;
        Self { median, low: sorted[outside], high: sorted[count - 1 - outside], confidence }
    }

    /// Whether the bounds allow a conclusion: the true median lies between them with a probability of at least 0.75.
    /// That needs three measurements: the probability is 0 with one, and 0.5 with two.
    #[must_use]
    pub fn is_bounded(&self) -> bool {
        self.confidence >= 0.75
    }

    /// Returns the distance between the bounds, divided by the median.
    #[must_use]
    pub fn spread(&self) -> f64 {
        (self.high - self.low) / self.median
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn few_measurements_are_bounded_by_their_extremes() {
        let median = Median::of(&[3.0, 1.0, 2.0, 5.0, 4.0]);
        assert_eq!((median.median, median.low, median.high), (3.0, 1.0, 5.0));
        // The bounds fail if all five values lie on one side of the true median, which has a probability of 2 in 32.
        assert_eq!(median.confidence, 1.0 - 2.0 / 32.0);
        let one = Median::of(&[7.0]);
        assert_eq!((one.median, one.low, one.high, one.confidence), (7.0, 7.0, 7.0, 0.0));
        assert_eq!(Median::of(&[1.0, 3.0]).median, 2.0);
        assert!(!one.is_bounded() && !Median::of(&[1.0, 3.0]).is_bounded() && Median::of(&[1.0; 3]).is_bounded());
    }

    #[test]
    fn many_measurements_are_bounded_closer() {
        let values: Vec<f64> = (1..=20).map(f64::from).collect();
        // Tables of binomial confidence intervals give the 6th and the 15th of 20 values as bounds, with a probability
        // of 95.9 %.
        let median = Median::of(&values);
        assert_eq!((median.median, median.low, median.high), (10.5, 6.0, 15.0));
        assert!((median.confidence - 0.9586).abs() < 1e-4, "{}", median.confidence);
        assert!((median.spread() - 9.0 / 10.5).abs() < 1e-15);
    }
}
