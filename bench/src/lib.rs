//! The shared code of the benchmarks.
//!
//! [`kernels`] are pieces of work that are small enough to be measured alone, by their time or their instructions.
//! [`nearest`] compares nearest hits with Embree's.

pub mod kernels;
pub mod nearest;

/// Returns the instruction set that the renderer uses. If `RENDER_INSTRUCTION_SET` names none of this machine, prints a
/// message and ends the program with status 2, so that no other set is measured.
#[must_use]
pub fn instruction_set() -> cpu::internals::InstructionSet {
    cpu::internals::InstructionSet::named().unwrap_or_else(|message| {
        eprintln!("Error: {message}");
        std::process::exit(2)
    })
}
