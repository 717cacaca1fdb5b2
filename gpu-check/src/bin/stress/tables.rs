//! The files with tables that the program writes, and the check that no row of an older table gets lost.

use std::path::Path;

use output::{Options, Output};
use stability::report::quoted;

/// Writes `text` into the file `path`, and replaces an old file.
pub fn put(path: &Path, text: &str) -> Result<(), output::Error> {
    Output::open(path, Options { sync: true })?.fill(|file| file.write_all(text.as_bytes()))
}

/// Largest size of an older table that is read, in bytes. docs/accuracy/pictures.csv has less than 1,000.
const MAX_BYTES: u64 = 1 << 20;

/// Name of the row that counts all pictures of `tests/cases` together.
pub const CASES_OF_THE_TESTS: &str = "tests/cases, all";

/// Returns an error if the table at `path` has a row of a picture that this run will not write. `case` has the
/// arguments of `--case`, three for each picture. A file that does not exist has no rows.
pub fn check_that_no_row_goes(path: &Path, case: &[String]) -> Result<(), String> {
    if !path.exists() {
        return Ok(());
    }
    let text = cpu::internals::input::reader::read_text(path, MAX_BYTES).map_err(|error| error.to_string())?;
    let names = case.chunks_exact(3).map(|triple| triple[0].as_str()).chain([CASES_OF_THE_TESTS]);
    let begins: Vec<_> = names.map(|name| quoted(name) + ",").collect();
    // The first line is the head of the table.
    let rows = text.lines().skip(1).filter(|row| !begins.iter().any(|begin| row.starts_with(begin)));
    let lost: Vec<_> = rows.map(|row| row.split("\",").next().unwrap_or(row).trim_start_matches('"')).collect();
    if lost.is_empty() {
        return Ok(());
    }
    let lost = lost.join(", ");
    Err(format!("its rows for {lost} would go; give each as --case NAME CONFIG SCENE, or choose another --out"))
}
