//! Reads and writes results, as JSON.

use std::path::Path;

use output::{Options, Output};

use super::Results;
use super::check::Total;
use crate::{Failure, terminal};

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
        let json = serde_json::to_string_pretty(self).map_err(|error| error.to_string())?;
        if path == Path::new("-") {
            return terminal::print(&json);
        }
        Ok(Output::open(path, options)?.fill(|file| writeln!(file, "{json}"))?)
    }
}
