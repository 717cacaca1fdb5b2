//! The measured data, and the figures that are derived from them.

pub mod check;

use std::path::Path;

use indexmap::IndexMap;
use output::{Options, Output};
use serde::{Deserialize, Serialize};

use super::error::ErrorCurve;
use super::fit::{PowerLaw, reaches};
use super::machine::Machine;
use crate::{Failure, terminal};
use check::Total;
use measure::statistics::Median;

/// Errors in linear light for which a [`TimeToError`] is computed.
pub const TARGETS: [f64; 3] = [0.05, 0.02, 0.01];

/// Identifies a measurement: what was rendered, by which implementation, and with which value of which parameter.
#[derive(Clone, Debug, PartialEq, PartialOrd, Serialize, Deserialize)]
pub struct Setting {
    /// The suite, which is the group of tasks: `scale` or `error`.
    pub suite: String,
    /// The scene's name.
    pub scene: String,
    /// The parameter that varies: `width`, `samples`, `depth`, `objects` or `density`.
    pub parameter: String,
    /// The value of the parameter.
    pub value: u64,
    /// The name of the implementation.
    pub engine: String,
}

/// The user time of one picture.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Timing {
    /// Identifies what was measured.
    #[serde(flatten)]
    pub setting: Setting,
    /// The time of every repeat in seconds, in the order measured.
    pub seconds: Vec<f64>,
    /// Median of the times of all repeats.
    pub median: Median,
    /// SHA-256 of the picture, in hexadecimal digits.
    pub digest: String,
}

/// A measurement that was left out, and the reason.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Omitted {
    /// Identifies what was not measured.
    #[serde(flatten)]
    pub setting: Setting,
    /// The reason why it was left out.
    pub reason: String,
}

/// The power law by which the time grows with a parameter.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Growth {
    /// The scene's name.
    pub scene: String,
    /// The parameter that varies.
    pub parameter: String,
    /// The name of the implementation.
    pub engine: String,
    /// The time in seconds as a power of the parameter.
    pub law: PowerLaw,
}

/// The time after which a picture has at most a given error against the converged picture.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct TimeToError {
    /// The scene's name.
    pub scene: String,
    /// The name of the implementation.
    pub engine: String,
    /// The given error, in linear light.
    pub error: f64,
    /// The time in seconds, interpolated between measured points; `null` if the error lies outside the measured range.
    pub seconds: Option<f64>,
}

/// A line of a chart: the times of one implementation for several values of a parameter. It has the names of the scene,
/// the parameter and the implementation, and pairs of a value and a time in seconds, ordered by rising value.
type Line<'a> = ([&'a String; 3], Vec<(f64, f64)>);

/// All measured data, and the figures derived from them.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Results {
    /// Whether the data are those of the small matrix, measured with `--quick`.
    pub quick: bool,
    /// The machines on which the data were measured.
    pub machines: Vec<Machine>,
    /// User times of pictures.
    pub timings: Vec<Timing>,
    /// Errors of pictures for each number of samples.
    pub curves: Vec<ErrorCurve>,
    /// Measurements that were left out.
    pub omitted: Vec<Omitted>,
    /// The growth of the times with each parameter, derived from `timings`.
    pub growth: Vec<Growth>,
    /// The times to reach given errors, derived from `timings` and `curves`.
    pub times_to_error: Vec<TimeToError>,
}

impl Results {
    /// Reads results from a JSON file; `-` is standard input.
    ///
    /// # Errors
    /// The file cannot be read, does not hold valid results, or is larger than [`Total`] allows.
    pub fn read(path: &Path) -> Result<Self, Failure> {
        Self::read_part(path, &mut Total::default())
    }

    /// Reads one of several files, and adds its size to `total`.
    ///
    /// # Errors
    /// As [`Results::read`]; the limits hold for all files together.
    pub fn read_part(path: &Path, total: &mut Total) -> Result<Self, Failure> {
        let results: Self = total.read(path)?;
        results.check().map_err(|error| format!("{}: {error}", terminal::name(path)))?;
        Ok(results)
    }

    /// Writes the results into the JSON file `path`; `-` is standard output.
    ///
    /// # Errors
    /// An error if the file cannot be written.
    pub fn write(&self, path: &Path, options: Options) -> Result<(), Failure> {
        if path == Path::new("-") {
            return terminal::print_json(self);
        }
        let json = serde_json::to_string_pretty(self).map_err(|error| error.to_string())?;
        Ok(Output::open(path, options)?.fill(|file| writeln!(file, "{json}"))?)
    }

    /// Joins the results of parts of one matrix. If two parts have times for one setting, the joined results have the
    /// repeats of both parts.
    ///
    /// # Errors
    /// The error as text, if the parts come from different matrices or commits, or have different pictures for one
    /// setting.
    pub fn merge(parts: impl IntoIterator<Item = Self>) -> Result<Self, String> {
        let mut all = Self::default();
        for (index, part) in parts.into_iter().enumerate() {
            if index == 0 {
                all.quick = part.quick;
            } else if part.quick != all.quick {
                return Err("quick and full measurements cannot be joined".to_owned());
            }
            for machine in part.machines {
                if all.machines.iter().any(|other| other.commit != machine.commit) {
                    return Err(format!("another part was measured at another commit than {}", machine.commit));
                }
                // Entries of one machine may differ only in the load, which changes from minute to minute.
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
            all.omitted.extend(part.omitted);
        }
        all.complete();
        Ok(all)
    }

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

    /// Returns the lines of the charts of the suite `suite`.
    fn lines(&self, suite: &str) -> impl Iterator<Item = Line<'_>> {
        let mut lines: IndexMap<_, Vec<_>> = IndexMap::new();
        for Timing { setting, median, .. } in self.timings.iter().filter(|timing| timing.setting.suite == suite) {
            let line = [&setting.scene, &setting.parameter, &setting.engine];
            lines.entry(line).or_default().push((setting.value as f64, median.median));
        }
        lines.into_iter().map(|(line, mut points)| {
            points.sort_by(|a, b| a.0.total_cmp(&b.0));
            (line, points)
        })
    }
}

#[cfg(test)]
pub(crate) mod tests;
