//! `one-kernel [NAME]`: runs one turn of a kernel in its own function, so that callgrind can count its instructions.
//! Without NAME it prints the names of all kernels. bench/instructions runs it.

use std::process::ExitCode;

use bench::kernels::{self, Work};

/// Runs one turn. bench/instructions counts the instructions of this function.
#[inline(never)]
fn counted_work(work: &mut dyn Work) {
    work.turn();
}

const USAGE: &str = "\
one-kernel [NAME]
Does a kernel's work once, inside a function that callgrind can be told to count; prints all names without NAME.

Example:
  cargo run --release -p bench --bin one-kernel sky";

fn main() -> ExitCode {
    let Some(name) = std::env::args().nth(1) else {
        kernels::all().iter().for_each(|kernel| println!("{}", kernel.name));
        return ExitCode::SUCCESS;
    };
    if name == "--help" {
        println!("{USAGE}");
        return ExitCode::SUCCESS;
    }
    let _ = bench::instruction_set();
    let Some(kernel) = kernels::all().into_iter().find(|kernel| kernel.name == name) else {
        eprintln!("Error: there is no kernel [{name}]; without a name all names are printed");
        return ExitCode::from(2);
    };
    let mut work = (kernel.new)();
    // The first turn detects the instruction sets of the machine and allocates memory. It is not counted.
    work.prepare();
    work.turn();
    work.prepare();
    counted_work(std::hint::black_box(&mut *work));
    ExitCode::SUCCESS
}
