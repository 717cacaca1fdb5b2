//! `instruction-set`: prints the instruction set that the renderer uses on this machine. Scripts that measure run it,
//! so that a wrong name in `RENDER_INSTRUCTION_SET` is an error.

use std::process::ExitCode;

const USAGE: &str = "\
instruction-set
Prints the instruction set that RENDER_INSTRUCTION_SET names, or else the fastest one of this machine. The status is 2
if this machine has no set with that name.

Example:
  RENDER_INSTRUCTION_SET=avx2 cargo run --release -p bench --bin instruction-set";

fn main() -> ExitCode {
    match std::env::args().nth(1).as_deref() {
        None => {
            println!("{}", bench::instruction_set().name());
            ExitCode::SUCCESS
        }
        Some("--help") => {
            println!("{USAGE}");
            ExitCode::SUCCESS
        }
        Some(argument) => {
            eprintln!("Error: [{argument}] is one argument too many; see --help");
            ExitCode::from(2)
        }
    }
}
