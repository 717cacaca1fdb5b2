//! The commands, a module each: its options, and what it does with them.

pub mod bench;
pub mod compare;
pub mod completions;
pub mod generate;
pub mod help;
pub mod inspect;
pub mod render;
pub mod report;

use serde::Serialize;

use crate::{Failure, terminal};

/// Writes a value as JSON to standard output.
///
/// # Errors
/// Standard output cannot be written.
pub fn print_json(value: &impl Serialize) -> Result<(), Failure> {
    terminal::print(&serde_json::to_string_pretty(value).map_err(|error| error.to_string())?)
}
