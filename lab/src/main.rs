//! The program `render-lab`. `render-lab --help` lists its commands.

use std::process::ExitCode;

fn main() -> ExitCode {
    lab::main()
}
