//! `one-kernel [NAME]`: runs one turn of a kernel in its own function, so that callgrind can count its instructions.
//! bench/instructions does that. bench/slopes measures the time of a turn, with `--turns`. docs/refresh gives no name,
//! to learn whether the machine has the set in `RENDER_INSTRUCTION_SET`.

use std::process::ExitCode;
use std::time::Instant;

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
    /// Prints the median time of this many turns, in nanoseconds
    #[arg(long, requires = "name", value_parser = clap::value_parser!(u32).range(1..))]
    turns: Option<u32>,
}

/// Runs one turn. bench/instructions counts the instructions of this function.
#[inline(never)]
fn counted_work(work: &mut dyn Work) {
    work.turn();
}

fn main() -> ExitCode {
    bench::main(|Options { name, turns }| {
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
        let mut times: Vec<_> = (0..turns.unwrap_or(1))
            .map(|_| {
                work.prepare();
                let start = Instant::now();
                counted_work(std::hint::black_box(&mut *work));
                start.elapsed().as_nanos()
            })
            .collect();
        times.sort_unstable();
        if turns.is_some() {
            println!("{}", times[times.len() / 2]);
        }
        Ok(true)
    })
}
