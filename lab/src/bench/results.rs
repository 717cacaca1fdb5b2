//! Measured data, as files keep it: JSON with everything, CSV with a line for each time and each error.

mod files;

use serde::{Deserialize, Serialize};

use super::energy::Energy;
use super::error::ErrorCurve;
use super::fit::{PowerLaw, reaches};
use super::machine::Machine;
use super::statistics::Median;
use crate::usage::Seconds;

/// Errors in linear light for which the time to get there is told.
pub const TARGETS: [f64; 3] = [0.05, 0.02, 0.01];

/// A measurement's place: what was rendered, and with which value of which parameter.
#[derive(Clone, Debug, PartialEq, PartialOrd, Serialize, Deserialize)]
pub struct Setting {
    /// What it was measured for: `scale` or `error`.
    pub suite: String,
    /// The scene's name.
    pub scene: String,
    /// What varies: `width`, `samples`, `depth` or `objects`.
    pub parameter: String,
    /// Its value.
    pub value: u64,
    /// The implementation.
    pub engine: String,
}

/// User time of one picture.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Timing {
    /// What was measured.
    #[serde(flatten)]
    pub setting: Setting,
    /// Every repeat, in the order measured.
    pub seconds: Vec<Seconds>,
    /// Their middle.
    pub median: Median,
    /// SHA-256 of the picture.
    pub digest: String,
}

/// What was left out of the matrix, and why.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Omitted {
    /// What was not measured.
    #[serde(flatten)]
    pub setting: Setting,
    /// Why.
    pub reason: String,
}

/// How the time grows with a parameter.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Growth {
    /// The scene's name.
    pub scene: String,
    /// What varies.
    pub parameter: String,
    /// The implementation.
    pub engine: String,
    /// Time as a power of it.
    pub law: PowerLaw,
}

/// Time until a picture is as near to the converged one as wanted.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct TimeToError {
    /// The scene's name.
    pub scene: String,
    /// The implementation.
    pub engine: String,
    /// The error wanted, in linear light.
    pub error: f64,
    /// Between measured points; `null` outside them.
    pub seconds: Option<Seconds>,
}

/// A line of a chart: one implementation's times against a parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// The scene's name.
    pub scene: String,
    /// What varies.
    pub parameter: String,
    /// The implementation.
    pub engine: String,
    /// Values and seconds, by rising value.
    pub points: Vec<(f64, f64)>,
}

/// Everything that was measured, and what follows from it.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Results {
    /// Whether it is the small matrix, to try things out.
    pub quick: bool,
    /// Where it was measured.
    pub machines: Vec<Machine>,
    /// User times.
    pub timings: Vec<Timing>,
    /// Errors.
    pub curves: Vec<ErrorCurve>,
    /// Energy.
    pub energy: Vec<Energy>,
    /// What was left out.
    pub omitted: Vec<Omitted>,
    /// Follows from the times.
    pub growth: Vec<Growth>,
    /// Follows from times and errors.
    pub times_to_error: Vec<TimeToError>,
}

impl Results {
    /// What follows from what was measured, computed anew.
    pub fn complete(&mut self) {
        self.timings.sort_by(|a, b| a.setting.partial_cmp(&b.setting).unwrap_or(std::cmp::Ordering::Equal));
        self.growth = self
            .lines("scale")
            .into_iter()
            .filter_map(|Line { scene, parameter, engine, points }| {
                Some(Growth { law: PowerLaw::through(&points)?, scene, parameter, engine })
            })
            .collect();
        self.times_to_error = Vec::new();
        for Line { scene, engine, points, .. } in self.lines("error") {
            let Some(curve) = self.curves.iter().find(|curve| curve.scene == scene) else { continue };
            let error_at = |samples: f64| curve.points.iter().find(|point| point.samples as f64 == samples);
            let points: Vec<_> = points
                .iter()
                .filter_map(|&(samples, seconds)| Some((seconds, error_at(samples)?.linear.median)))
                .collect();
            for error in TARGETS {
                let (scene, engine, seconds) = (scene.clone(), engine.clone(), reaches(&points, error));
                self.times_to_error.push(TimeToError { scene, engine, error, seconds });
            }
        }
    }

    /// The lines of a suite's charts.
    #[must_use]
    pub fn lines(&self, suite: &str) -> Vec<Line> {
        let mut lines: Vec<Line> = Vec::new();
        for Timing { setting, median, .. } in self.timings.iter().filter(|timing| timing.setting.suite == suite) {
            let Setting { scene, parameter, engine, .. } = setting;
            let point = (setting.value as f64, median.median);
            let is_its = |line: &&mut Line| (&line.scene, &line.parameter, &line.engine) == (scene, parameter, engine);
            match lines.iter_mut().find(is_its) {
                Some(line) => line.points.push(point),
                None => {
                    let (scene, parameter, engine) = (scene.clone(), parameter.clone(), engine.clone());
                    lines.push(Line { scene, parameter, engine, points: vec![point] });
                }
            }
        }
        for line in &mut lines {
            line.points.sort_by(|a, b| a.0.total_cmp(&b.0));
        }
        lines
    }

    /// Joins results of parts of one matrix. Times of the same setting, measured twice, are pooled.
    ///
    /// # Errors
    /// Parts of different matrices or different programs, or different pictures at one setting.
    pub fn merge(parts: Vec<Self>) -> Result<Self, String> {
        let mut all = Self { quick: parts.first().ok_or("there is nothing to join")?.quick, ..Self::default() };
        for part in parts {
            if part.quick != all.quick {
                return Err("quick and full measurements cannot be joined".to_owned());
            }
            for machine in part.machines {
                if all.machines.iter().any(|other| other.commit != machine.commit) {
                    return Err(format!("another part was measured at another commit than {}", machine.commit));
                }
                // The load differs from one minute to the next; the machine does not.
                let same = |other: &&Machine| Machine { load: machine.load, ..(*other).clone() } == machine;
                if !all.machines.iter().any(|other| same(&other)) {
                    all.machines.push(machine);
                }
            }
            for timing in part.timings {
                match all.timings.iter_mut().find(|other| other.setting == timing.setting) {
                    Some(other) if other.digest != timing.digest => {
                        return Err(format!("different pictures for {:?}", timing.setting));
                    }
                    Some(other) => {
                        other.seconds.extend(timing.seconds);
                        other.median = Median::of(&other.seconds);
                    }
                    None => all.timings.push(timing),
                }
            }
            for curve in part.curves {
                if !all.curves.iter().any(|other| other.scene == curve.scene) {
                    all.curves.push(curve);
                }
            }
            all.energy.extend(part.energy);
            all.omitted.extend(part.omitted);
        }
        all.complete();
        Ok(all)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bench::error::ErrorPoint;

    pub fn timing(engine: &str, value: u64, seconds: &[f64]) -> Timing {
        let [suite, scene, parameter, engine] = ["scale", "grid", "samples", engine].map(str::to_owned);
        let setting = Setting { suite, scene, parameter, value, engine };
        Timing { setting, seconds: seconds.to_vec(), median: Median::of(seconds), digest: "d".to_owned() }
    }

    pub fn results(timings: Vec<Timing>) -> Results {
        Results { timings, machines: vec![Machine::here()], ..Results::default() }
    }

    #[test]
    fn parts_are_joined_and_what_follows_is_computed() {
        let first = results(vec![timing("a", 4, &[4.0]), timing("a", 1, &[1.0])]);
        let second = results(vec![timing("a", 16, &[16.0]), timing("a", 4, &[6.0])]);
        let joined = Results::merge(vec![first, second]).expect("they fit");
        assert_eq!(joined.machines.len(), 1);
        let medians: Vec<_> =
            joined.timings.iter().map(|timing| (timing.setting.value, timing.median.median)).collect();
        assert_eq!(medians, [(1, 1.0), (4, 5.0), (16, 16.0)], "pooled, and in order");
        assert!((joined.growth[0].law.exponent - 1.0).abs() < 1e-12, "{:?}", joined.growth);
    }

    #[test]
    fn what_does_not_belong_together_is_not_joined() {
        let part = || results(vec![timing("a", 1, &[1.0])]);
        let quick = Results { quick: true, ..part() };
        let mut other_picture = part();
        other_picture.timings[0].digest = "other".to_owned();
        let mut other_commit = part();
        other_commit.machines[0].commit = "other".to_owned();
        for other in [quick, other_picture, other_commit] {
            assert!(Results::merge(vec![part(), other]).is_err());
        }
        assert!(Results::merge(Vec::new()).is_err());
    }

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
        // A fifth of the error beyond 0.04 costs 1.6 times in error, squared in time; 0.01 was not reached.
        assert!((seconds[0].expect("measured") - 2.56).abs() < 1e-9, "{seconds:?}");
        assert!((seconds[1].expect("measured") - 16.0).abs() < 1e-9, "{seconds:?}");
        assert_eq!(seconds[2], None);
    }
}
