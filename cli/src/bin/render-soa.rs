//! `render-soa CONFIG SCENE OUT.ppm`: renders with structures of arrays.

use std::process::ExitCode;

fn main() -> ExitCode {
    cli::main::<cpu::Soa>()
}
