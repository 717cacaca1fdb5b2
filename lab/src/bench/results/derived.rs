//! Computes the figures that are derived from the measured data.

use super::{Growth, Results, TARGETS, TimeToError};
use crate::bench::fit::{PowerLaw, reaches};

impl Results {
    /// Sorts `timings`, and computes `growth` and `times_to_error` from the measured data.
    pub fn complete(&mut self) {
        self.timings.sort_by(|a, b| a.setting.partial_cmp(&b.setting).unwrap_or(std::cmp::Ordering::Equal));
        let growth = self.lines("scale").filter_map(|([scene, parameter, engine], points)| {
            let [scene, parameter, engine] = [scene, parameter, engine].map(String::clone);
            Some(Growth { law: PowerLaw::through(&points)?, scene, parameter, engine })
        });
        self.growth = growth.collect();
        let mut times_to_error = Vec::new();
        for ([scene, _, engine], points) in self.lines("error") {
            let Some(curve) = self.curves.iter().find(|curve| curve.scene == *scene) else { continue };
            let error_at = |samples: f64| curve.points.iter().find(|point| point.samples as f64 == samples);
            let points: Vec<_> = points
                .iter()
                .filter_map(|&(samples, seconds)| Some((seconds, error_at(samples)?.linear.median)))
                .collect();
            times_to_error.extend(TARGETS.map(|error| {
                let (scene, engine, seconds) = (scene.clone(), engine.clone(), reaches(&points, error));
                TimeToError { scene, engine, error, seconds }
            }));
        }
        self.times_to_error = times_to_error;
    }
}

#[cfg(test)]
mod tests {
    use super::super::ErrorCurve;
    use super::super::tests::{results, timing};
    use super::*;
    use crate::bench::error::ErrorPoint;
    use measure::statistics::Median;

    #[test]
    fn the_time_to_an_error_lies_between_measured_points() {
        let error = |samples, rmse| ErrorPoint { samples, linear: Median::of(&[rmse]), course: Median::of(&[1.0]) };
        let points = vec![error(1, 0.08), error(4, 0.04), error(16, 0.02)];
        let curve = ErrorCurve { scene: "grid".to_owned(), reference_samples: 99, reference_error: 0.0, points };
        let mut timings: Vec<_> = [1, 4, 16].map(|value| timing("a", value, &[value as f64])).to_vec();
        timings.iter_mut().for_each(|timing| timing.setting.suite = "error".to_owned());
        let mut results = Results { curves: vec![curve], ..results(timings) };
        results.complete();
        let seconds: Vec<_> = results.times_to_error.iter().map(|time| time.seconds).collect();
        // The error halves when the time grows fourfold. So the error 0.05, which is 0.08 / 1.6, takes 1.6² = 2.56 s.
        // The smallest measured error is 0.02, so the error 0.01 was not reached.
        assert!((seconds[0].expect("measured") - 2.56).abs() < 1e-9, "{seconds:?}");
        assert!((seconds[1].expect("measured") - 16.0).abs() < 1e-9, "{seconds:?}");
        assert_eq!(seconds[2], None);
    }
}
