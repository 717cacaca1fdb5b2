//! `one-kernel [NAME]`: does a kernel's work once, inside a function that callgrind can be told to count; without a
//! name, prints all names. bench/instructions runs it.

use std::process::ExitCode;

use bench::kernels::{self, Work};

/// What is counted.
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
    let Some(kernel) = kernels::all().into_iter().find(|kernel| kernel.name == name) else {
        eprintln!("Error: there is no kernel [{name}]; without a name all names are printed");
        return ExitCode::from(2);
    };
    let mut work = (kernel.new)();
    // The first turn finds out what the machine has, and makes room.
    work.prepare();
    work.turn();
    work.prepare();
    counted_work(std::hint::black_box(&mut *work));
    ExitCode::SUCCESS
}
