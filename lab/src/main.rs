//! `render-lab`: see it, compare it, measure it. `render-lab --help` says how.

use std::process::ExitCode;

fn main() -> ExitCode {
    lab::main()
}
