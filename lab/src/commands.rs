//! The commands. Each has its own module, with its options and its work.

pub mod animate;
pub mod bench;
pub mod check;
pub mod compare;
pub mod completions;
pub mod convert;
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

use serde::Serialize;

use crate::{Failure, terminal};

/// Writes `value` as JSON to standard output.
///
/// # Errors
/// An error if standard output cannot be written.
pub fn print_json(value: &impl Serialize) -> Result<(), Failure> {
    terminal::print(&serde_json::to_string_pretty(value).map_err(|error| error.to_string())?)
}

/// Writes `value` to standard output: as JSON if `json` is true, and otherwise as `text`.
///
/// # Errors
/// An error if standard output cannot be written.
pub fn print_as(json: bool, value: &impl Serialize, text: impl FnOnce() -> String) -> Result<(), Failure> {
    if json { print_json(value) } else { terminal::print(&text()) }
}
