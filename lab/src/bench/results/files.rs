//! Reads and writes results. A JSON file holds everything; CSV files hold parts of it for other programs.

use std::path::{Path, PathBuf};

use output::{Options, Output};
use serde::Serialize;

use super::check::{MAX_BYTES, Total};
use super::{Results, Setting, Timing};
use crate::bench::error::ErrorPoint;
use crate::{Failure, sources, terminal};

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
        let explain = |error: &dyn std::fmt::Display| format!("{}: {error}", terminal::name(path));
        let text =
            cpu::internals::input::reader::read(&sources::input(path), MAX_BYTES).map_err(|error| explain(&error))?;
        let results: Self = total.parse(&text).map_err(|error| explain(&error))?;
        results.check().map_err(|error| explain(&error))?;
        Ok(results)
    }

    /// Writes the results into the JSON file `path`. Beside it, writes the times into `NAME.csv`, and the errors into
    /// `NAME-error.csv`. If `path` is `-`, writes only the JSON, to standard output.
    ///
    /// # Errors
    /// An error if a file cannot be written. If one of the three files cannot be opened, none is changed.
    pub fn write(&self, path: &Path, options: Options) -> Result<(), Failure> {
        let explain = |error: csv::Error| error.to_string();
        let mut json = serde_json::to_string_pretty(self).map_err(|error| error.to_string())?;
        if path == Path::new("-") {
            return terminal::print(&json);
        }
        json.push('\n');
        let contents =
            [json.into_bytes(), self.times_as_csv().map_err(explain)?, self.errors_as_csv().map_err(explain)?];
        let outputs: Result<Vec<_>, _> = Self::files(path).iter().map(|path| Output::open(path, options)).collect();
        for (output, bytes) in outputs?.into_iter().zip(contents) {
            output.fill(|file| file.write_all(&bytes))?;
        }
        Ok(())
    }

    /// Checks that [`Results::write`] can write its files for `path`. Changes no file.
    ///
    /// # Errors
    /// An error if one of the files cannot be written.
    pub fn check_writable(path: &Path, options: Options) -> Result<(), Failure> {
        if path == Path::new("-") {
            return Ok(Output::open(&sources::output(path), options).map(drop)?);
        }
        Ok(Self::files(path).iter().try_for_each(|path| Output::open(path, options).map(drop))?)
    }

    /// Returns the paths of the files that [`Results::write`] writes for `path`. The first is `path` itself.
    #[must_use]
    pub fn files(path: &Path) -> [PathBuf; 3] {
        let stem = path.file_stem().unwrap_or_default();
        let beside = |ending: &str| {
            let mut name = stem.to_owned();
            name.push(ending);
            path.with_file_name(name)
        };
        [path.to_owned(), beside(".csv"), beside("-error.csv")]
    }

    fn times_as_csv(&self) -> csv::Result<Vec<u8>> {
        let setting = ["suite", "scene", "parameter", "value", "engine"];
        let rows = self.timings.iter().map(|Timing { setting, seconds, median, .. }| {
            let Setting { suite, scene, parameter, value, engine } = setting;
            (suite, scene, parameter, value, engine, median, seconds.len())
        });
        table(&[&setting, &["median_s", "low_s", "high_s", "confidence", "repeats"]], rows)
    }

    fn errors_as_csv(&self) -> csv::Result<Vec<u8>> {
        let points = self.curves.iter().flat_map(|curve| curve.points.iter().map(move |point| (&curve.scene, point)));
        let rows = points.map(|(scene, ErrorPoint { samples, linear: a, course: b })| {
            (scene, samples, a.median, a.low, a.high, b.median, b.low, b.high)
        });
        table(&[&["scene", "samples", "rmse_linear", "low", "high", "rmse_course", "low", "high"]], rows)
    }
}

/// Returns a table as CSV. The columns have the names in all of `heads`, in their order.
fn table(heads: &[&[&str]], rows: impl Iterator<Item = impl Serialize>) -> csv::Result<Vec<u8>> {
    // The names of the fields of a row would be written as a second head.
    let mut out = csv::WriterBuilder::new().has_headers(false).from_writer(Vec::new());
    out.write_record(heads.concat())?;
    for row in rows {
        out.serialize(row)?;
    }
    out.into_inner().map_err(|error| error.into_error().into())
}

#[cfg(test)]
mod tests {
    use super::super::tests::{results, timing};
    use test_support::folder::Folder;

    use super::*;

    #[test]
    fn files_hold_what_was_measured() {
        let folder = Folder::new();
        let path = folder.file("bench.json");
        let mut results = results(vec![timing("a", 4, &[4.0, 5.0]), timing("a", 1, &[1.0])]);
        results.complete();
        results.write(&path, Options::default()).expect("the folder is writable");
        assert_eq!(Results::read(&path).expect("it was written"), results);
        assert!(Results::read(Path::new("/dev/zero")).is_err(), "it has no end");
        let csv = std::fs::read_to_string(folder.file("bench.csv")).expect("it was written");
        assert_eq!(csv.lines().nth(2), Some("scale,grid,samples,4,a,4.5,4.0,5.0,0.5,2"));
    }
}
