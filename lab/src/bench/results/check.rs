//! Checks results from a file before other figures are computed from them.

use std::path::Path;

use cpu::internals::input::reader;
use serde::de::DeserializeOwned;

use super::{Results, Timing};
use crate::format::unseen;
use crate::{Failure, sources, terminal};

/// Most bytes of one file of results, and of all files together. The full matrix takes 270,000.
pub const MAX_BYTES: u64 = 16 << 20;

/// Largest number of entries of a list. The limit is needed because the time to join and compare lists grows with the
/// square of their length. The longest list of the full matrix has 410 entries.
pub const MAX_ENTRIES: usize = 4096;

/// Largest number of JSON values (numbers, texts, lists, objects) in all files of results together. A file of
/// [`MAX_BYTES`] could hold eight million values, which take far more memory than the file. The full matrix has 9,000.
pub const MAX_VALUES: usize = 1 << 20;

/// Returns an upper bound on the number of values in `json`: one more than its commas and opening brackets. Commas and
/// brackets inside strings count too, so the function need not know where a string ends.
pub fn values(json: &[u8]) -> usize {
    json.iter().filter(|byte| b",[{".contains(byte)).count() + 1
}

/// The size of the files that were read so far.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Total {
    /// At most [`MAX_BYTES`].
    bytes: u64,
    /// At most [`MAX_VALUES`].
    values: usize,
}

impl Total {
    /// Reads the JSON file `path`; `-` is standard input. If all files together exceed [`MAX_BYTES`] or [`MAX_VALUES`],
    /// nothing is parsed.
    ///
    /// # Errors
    /// The file cannot be read, or is not such JSON.
    pub fn read<T: DeserializeOwned>(&mut self, path: &Path) -> Result<T, Failure> {
        let bytes = reader::read(&sources::input(path), MAX_BYTES).map_err(|error| error.to_string());
        Ok(bytes.and_then(|bytes| self.parse(&bytes)).map_err(|error| format!("{}: {error}", terminal::name(path)))?)
    }

    fn parse<T: DeserializeOwned>(&mut self, json: &[u8]) -> Result<T, String> {
        let others = if *self == Self::default() { "" } else { "with the files before it, " };
        self.bytes += json.len() as u64;
        self.values += values(json);
        let Self { bytes, values } = self;
        if *bytes > MAX_BYTES {
            return Err(format!("{others}it has {bytes} bytes, more than {MAX_BYTES}"));
        }
        if *values > MAX_VALUES {
            return Err(format!("{others}it has {values} values, more than {MAX_VALUES}"));
        }
        let explain = |error| match unseen::mark(json) {
            Some(mark) => format!("not JSON: it begins with {}; {}", mark.what[0], mark.remedy[0]),
            None => format!("not the JSON that `render-lab bench ... --out FILE` writes: {error}"),
        };
        serde_json::from_slice(json).map_err(explain)
    }
}

impl Results {
    /// Checks that no list has more than [`MAX_ENTRIES`] entries, and that every measurement has at least one time.
    ///
    /// # Errors
    /// The error as text.
    pub fn check(&self) -> Result<(), String> {
        let lists = [
            ("machines", self.machines.len()),
            ("timings", self.timings.len()),
            ("curves", self.curves.len()),
            ("points of curves", self.curves.iter().map(|curve| curve.points.len()).sum()),
            ("omitted", self.omitted.len()),
            ("growth", self.growth.len()),
            ("times_to_error", self.times_to_error.len()),
        ];
        if let Some((name, count)) = lists.iter().find(|(_, count)| *count > MAX_ENTRIES) {
            return Err(format!("the list \"{name}\" has {count} entries, more than {MAX_ENTRIES}"));
        }
        if let Some(Timing { setting, .. }) = self.timings.iter().find(|timing| timing.seconds.is_empty()) {
            let (scene, engine) = (&setting.scene, &setting.engine);
            return Err(format!("the list \"seconds\" of {engine} for {scene} is empty; measure it again"));
        }
        Ok(())
    }
}
