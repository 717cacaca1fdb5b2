//! A logarithmic axis with round ticks.

use plotters::coord::ranged1d::{KeyPointHint, Ranged, ValueFormatter};

/// Returns the range of `values`, extended at both ends by the factor `room`.
pub fn range(values: impl Iterator<Item = f64>, room: f64) -> std::ops::Range<f64> {
    let (low, high) = values.fold((f64::INFINITY, 0.0_f64), |(low, high), value| (low.min(value), high.max(value)));
    // The division may give 0 and the multiplication infinity, so the ends are limited to positive finite numbers.
    (low / room).max(f64::MIN_POSITIVE / 2.0_f64.powi(52))..(high * room).min(f64::MAX)
}

/// A logarithmic axis with round ticks. The ticks are 1, 2 and 5 in each decade. If these are fewer than two, they are
/// multiples of a tenth, a fifth, a half or the whole of the power of ten. If these are too many, they are 1 and 3,
/// then the powers of ten, then every second, third or fifth power of ten.
pub struct Logarithmic(pub std::ops::Range<f64>);

impl Ranged for Logarithmic {
    type FormatOption = plotters::coord::ranged1d::NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, (from, to): (i32, i32)) -> i32 {
        let share = (value.ln() - self.0.start.ln()) / (self.0.end.ln() - self.0.start.ln());
        from + (f64::from(to - from) * share).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, hint: Hint) -> Vec<f64> {
        ticks(&self.0, hint.max_num_points())
    }

    fn range(&self) -> std::ops::Range<f64> {
        self.0.clone()
    }
}

impl ValueFormatter<f64> for Logarithmic {}

fn ticks(range: &std::ops::Range<f64>, most: usize) -> Vec<f64> {
    // Limited to the powers of ten that an `f64` can hold, because the range may begin at 0 or end at infinity.
    let bounded = |decade: f64| (decade as i32).clamp(-323, 308);
    let decades = bounded(range.start.log10().floor())..=bounded(range.end.log10().ceil());
    let with = |steps: &[f64]| -> Vec<f64> {
        let all = decades.clone().flat_map(|decade| steps.iter().map(move |step| step * 10_f64.powi(decade)));
        all.filter(|tick| range.contains(tick)).collect()
    };
    let every = |count: i32| -> Vec<f64> {
        let powers = decades.clone().filter(|decade| decade % count == 0).map(|decade| 10_f64.powi(decade));
        powers.filter(|tick| range.contains(tick)).collect()
    };
    let few = with(&[1.0, 2.0, 5.0]);
    if few.len() < 2 {
        let tenths =
            |step: i32| (10..100).step_by(step as usize).map(|tenth| f64::from(tenth) / 10.0).collect::<Vec<_>>();
        let sets = [1, 2, 5, 10].map(|step| with(&tenths(step)));
        if let Some(fine) = sets.into_iter().find(|ticks| ticks.len() <= most && ticks.len() > 1) {
            return fine;
        }
    }
    let sets = [few, with(&[1.0, 3.0]), every(1), every(2), every(3)];
    sets.into_iter().find(|ticks| ticks.len() <= most).unwrap_or_else(|| every(5))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_range_from_zero_has_no_more_decades_than_there_are_numbers() {
        for range in [0.0..1.0, 1.0..f64::INFINITY, f64::NAN..1.0, range([5e-324, f64::MAX].into_iter(), 2.0)] {
            assert!(ticks(&range, 9).len() <= 640);
        }
    }

    #[test]
    fn ticks_are_round() {
        assert_eq!(ticks(&(0.9..60.0), 9), [1.0, 2.0, 5.0, 10.0, 20.0, 50.0]);
        assert_eq!(ticks(&(0.9..60.0), 4), [1.0, 3.0, 10.0, 30.0]);
        assert_eq!(ticks(&(3.4..4.8), 4), [3.5, 4.0, 4.5]);
        assert_eq!(ticks(&(0.9e-9..1.1), 4), [1e-9, 1e-6, 1e-3, 1.0]);
        assert_eq!(ticks(&(0.9..11000.0), 5), [1.0, 10.0, 100.0, 1000.0, 10000.0]);
    }
}
