//! The document with the tables that the program writes: its marks, and the check that no row gets lost.

use std::path::Path;

use output::{Options, Output};

/// Writes `text` into the file `path`, and replaces an old file.
pub fn put(path: &Path, text: &str) -> Result<(), output::Error> {
    Output::open(path, Options { sync: true })?.fill(|file| file.write_all(text.as_bytes()))
}

/// Largest size of a document that is read, in bytes. docs/accuracy/tables.md has less than 20,000.
const MAX_BYTES: u64 = 1 << 22;

/// Returns the text of the document at `path`. If the file does not exist, returns a new document with all marks and
/// without tables.
pub fn text(path: &Path) -> Result<String, String> {
    if path.exists() {
        return cpu::internals::input::reader::read_text(path, MAX_BYTES)
            .map_err(|error| format!("{}: {error}", path.display()));
    }
    let mut text = "# Accuracy of the intersections\n".to_owned();
    for mark in ["command", "spheres", "cylinders", "costs", "large", "pictures"] {
        text += &format!("\n## {mark}\n\n<!-- begin: {mark} -->\n<!-- end: {mark} -->\n");
    }
    Ok(text)
}

/// Returns an error if the document has a row of a picture that this run will not write. `case` has the arguments of
/// `--case`, three for each picture.
pub fn check_that_no_row_goes(text: &str, case: &[String]) -> Result<(), String> {
    let (_, rest) = text.split_once("<!-- begin: pictures -->\n").ok_or("it lacks the mark pictures")?;
    let block = rest.split_once("<!-- end: pictures -->").map_or(rest, |(block, _)| block);
    // A row is `| NAME | ...`. The first two lines are the head of the table.
    let rows = block.lines().skip(2).filter_map(|line| line.split('|').nth(1)).map(str::trim);
    let is_rendered = |row: &&str| *row == CASES_OF_THE_TESTS || case.chunks_exact(3).any(|triple| triple[0] == **row);
    let lost: Vec<_> = rows.filter(|row| !is_rendered(row)).collect();
    if lost.is_empty() {
        return Ok(());
    }
    let lost = lost.join(", ");
    Err(format!("its rows for {lost} would go; give each as --case NAME CONFIG SCENE, or choose another --out"))
}

/// Name of the row that counts all pictures of `tests/cases` together.
pub const CASES_OF_THE_TESTS: &str = "tests/cases, all";

/// Returns `text` in which `block` replaces the part between the two comments of `mark`. Returns an error if a comment
/// is missing.
pub fn replaced(text: &str, mark: &str, block: &str) -> Result<String, String> {
    let (begin, end) = (format!("<!-- begin: {mark} -->\n"), format!("<!-- end: {mark} -->"));
    let missing = || format!("the document lacks the mark {mark}");
    let (before, rest) = text.split_once(&begin).ok_or_else(missing)?;
    let (_, after) = rest.split_once(&end).ok_or_else(missing)?;
    Ok(format!("{before}{begin}{block}{end}{after}"))
}
