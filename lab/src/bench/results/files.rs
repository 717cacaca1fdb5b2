//! Results as files: JSON that holds everything, CSV for other programs.

use std::io::Write;
use std::path::Path;

use cpu::output::Output;

use super::{Intersection, Results, Setting, Timing, Trial};
use crate::Failure;
use crate::bench::error::ErrorPoint;
use crate::bench::statistics::Median;

impl Results {
    /// Results from a JSON file; `-` is standard input.
    ///
    /// # Errors
    /// It cannot be read, or is something else.
    pub fn read(path: &Path) -> Result<Self, Failure> {
        let explain = |error: &dyn std::fmt::Display| format!("{}: {error}", path.display());
        let text = std::fs::read(crate::sources::input(path)).map_err(|error| explain(&error))?;
        Ok(serde_json::from_slice(&text).map_err(|error| explain(&error))?)
    }

    /// Writes the JSON file `path`, standard output for `-`, and beside it the times as `NAME.csv`, the errors as `NAME-error.csv` and the
    /// intersections as `NAME-intersections.csv`.
    ///
    /// # Errors
    /// A file cannot be written.
    pub fn write(&self, path: &Path) -> Result<(), Failure> {
        let json = serde_json::to_string_pretty(self).map_err(|error| error.to_string())?;
        if path == Path::new("-") {
            return Ok(writeln!(std::io::stdout(), "{json}")?);
        }
        let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let beside = |ending: &str, csv: csv::Result<Vec<u8>>| {
            csv.map(|bytes| (path.with_file_name(format!("{stem}{ending}.csv")), bytes)).map_err(|e| e.to_string())
        };
        let files = [
            (path.to_owned(), format!("{json}\n").into_bytes()),
            beside("", self.times_as_csv())?,
            beside("-error", self.errors_as_csv())?,
            beside("-intersections", self.intersections_as_csv())?,
        ];
        for (path, bytes) in files {
            Output::open(&path)?.write(|file| file.write_all(&bytes))?;
        }
        Ok(())
    }

    fn times_as_csv(&self) -> csv::Result<Vec<u8>> {
        let mut out = csv::Writer::from_writer(Vec::new());
        out.write_record([
            "suite",
            "scene",
            "parameter",
            "value",
            "engine",
            "median_s",
            "low_s",
            "high_s",
            "confidence",
            "repeats",
        ])?;
        for Timing { setting, seconds, median, .. } in &self.timings {
            let Setting { suite, scene, parameter, value, engine } = setting;
            let Median { median, low, high, confidence } = median;
            out.serialize((suite, scene, parameter, value, engine, median, low, high, confidence, seconds.len()))?;
        }
        out.into_inner().map_err(|error| error.into_error().into())
    }

    fn errors_as_csv(&self) -> csv::Result<Vec<u8>> {
        let mut out = csv::Writer::from_writer(Vec::new());
        out.write_record(["scene", "samples", "rmse_linear", "low", "high", "rmse_course", "low", "high"])?;
        for curve in &self.curves {
            for ErrorPoint { samples, linear: a, course: b } in &curve.points {
                out.serialize((&curve.scene, samples, a.median, a.low, a.high, b.median, b.low, b.high))?;
            }
        }
        out.into_inner().map_err(|error| error.into_error().into())
    }

    fn intersections_as_csv(&self) -> csv::Result<Vec<u8>> {
        let mut out = csv::Writer::from_writer(Vec::new());
        let keys = ["object", "rays", "seed", "implementation", "cases", "wrong"];
        let errors = ["lambda_p50", "lambda_p999", "lambda_max"];
        let costs = ["median_ns", "low_ns", "high_ns", "confidence", "repeats"];
        out.write_record(keys.iter().chain(&errors).chain(&costs))?;
        for Intersection { trial, cases, wrong, lambda_error, nanoseconds, median } in &self.intersections {
            let Trial { object, rays, implementation, seed } = trial;
            let Median { median, low, high, confidence } = median;
            out.serialize((
                (object, rays, seed, implementation, cases, wrong),
                lambda_error,
                (median, low, high, confidence, nanoseconds.len()),
            ))?;
        }
        out.into_inner().map_err(|error| error.into_error().into())
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{results, timing};
    use super::*;

    #[test]
    fn files_hold_what_was_measured() {
        let folder = tempfile::tempdir().expect("the temporary folder is writable");
        let path = folder.path().join("bench.json");
        let mut results = results(vec![timing("a", 4, &[4.0, 5.0]), timing("a", 1, &[1.0])]);
        results.complete();
        results.write(&path).expect("the folder is writable");
        assert_eq!(Results::read(&path).expect("it was written"), results);
        let csv = std::fs::read_to_string(folder.path().join("bench.csv")).expect("it was written");
        assert_eq!(csv.lines().nth(2), Some("scale,grid,samples,4,a,4.5,4.0,5.0,0.5,2"));
    }
}
