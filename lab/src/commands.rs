//! The commands. Each has its own module, with its options and its work.

pub mod animate;
pub mod bench;
pub mod check;
pub mod compare;
pub mod completions;
pub mod convert;
pub mod diagnose;
pub mod explain;
pub mod generate;
pub mod grade;
pub mod help;
pub mod inspect;
pub mod render;
pub mod report;
pub mod shader;
pub mod supervise;
pub mod time;
pub mod view;

use std::path::Path;

use serde::Serialize;

use crate::{Failure, sources, terminal};

/// Writes `value` to standard output: as JSON if `json` is true, and otherwise as `text`. If one of the outputs `outs`
/// is standard output, the text goes to standard error.
///
/// # Errors
/// An error if standard output cannot be written.
pub fn print_as(
    json: bool,
    outs: &[&Path],
    value: &impl Serialize,
    text: impl FnOnce() -> String,
) -> Result<(), Failure> {
    match (json, outs.iter().any(|out| sources::is_stdout(out))) {
        (true, _) => terminal::print_json(value),
        (false, true) => {
            terminal::note(&text());
            Ok(())
        }
        (false, false) => terminal::print(&text()),
    }
}
