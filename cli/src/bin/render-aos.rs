//! `render-aos CONFIG SCENE OUT.ppm`: renders with arrays of structures.

use std::process::ExitCode;

fn main() -> ExitCode {
    cli::main::<cpu::Aos>()
}
