//! The shared code of the benchmarks.
//!
//! [`kernels`] are pieces of work that are small enough to be measured alone, by their time or their instructions.
//! [`nearest`] compares nearest hits with Embree's. [`programs`] times two programs in turn, and [`families`] has the
//! scenes on which the renderer may be slow.

pub mod families;
pub mod kernels;
pub mod nearest;
pub mod programs;

use std::process::ExitCode;

use clap::Parser;

/// Parses the command line of a program and runs it. The exit status is 0 if `run` returns true, 1 if it returns false,
/// and 2 for an error, whose message is printed. It is an error if `RENDER_INSTRUCTION_SET` names no set of this
/// machine: the evaluated programs would ignore the name, and another set would be measured.
pub fn main<O: Parser>(run: impl FnOnce(&O) -> Result<bool, String>) -> ExitCode {
    let options = O::parse();
    match cpu::internals::InstructionSet::named().and_then(|_| run(&options)) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(message) => {
            eprintln!("Error: {message}");
            ExitCode::from(2)
        }
    }
}

/// Returns the instruction set that the renderer uses. If `RENDER_INSTRUCTION_SET` names none of this machine, prints a
/// message and ends the program with status 2, so that no other set is measured.
#[must_use]
pub fn instruction_set() -> cpu::internals::InstructionSet {
    cpu::internals::InstructionSet::named().unwrap_or_else(|message| {
        eprintln!("Error: {message}");
        std::process::exit(2)
    })
}
