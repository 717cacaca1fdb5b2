//! `one-kernel [NAME]`: runs one turn of a kernel in its own function, so that callgrind can count its instructions.
//! bench/instructions runs it. Scripts that measure run it without a name, so that a wrong name in
//! `RENDER_INSTRUCTION_SET` is an error.

use std::process::ExitCode;

use bench::kernels::{self, Work};
use clap::Parser;

/// Does a kernel's work once, inside a function that callgrind can be told to count; prints all names without NAME.
#[derive(Parser)]
#[command(
    name = "one-kernel",
    after_help = "Example:\n  cargo run --release -p bench --bin one-kernel background-pixels"
)]
struct Options {
    /// The kernel
    name: Option<String>,
}

/// Runs one turn. bench/instructions counts the instructions of this function.
#[inline(never)]
fn counted_work(work: &mut dyn Work) {
    work.turn();
}

fn main() -> ExitCode {
    bench::main(|Options { name }| {
        let Some(name) = name else {
            kernels::all().iter().for_each(|kernel| println!("{}", kernel.name));
            return Ok(true);
        };
        let kernel = kernels::all().into_iter().find(|kernel| kernel.name == name);
        let missing = || format!("there is no kernel [{name}]; without a name all names are printed");
        let mut work = (kernel.ok_or_else(missing)?.new)();
        // The first turn detects the instruction sets of the machine and allocates memory. It is not counted.
        work.prepare();
        work.turn();
        work.prepare();
        counted_work(std::hint::black_box(&mut *work));
        Ok(true)
    })
}
