//! Rewrites a WGSL module into one without f64, which computes the same bits with integers.
//!
//!     lower-f64 MODULE > LOWERED

use std::io::{Read, Write};
use std::process::ExitCode;

use shaders::lower::{Arithmetic, lower_text};

/// Largest length of a text in bytes. A module within the limits of [`shaders::limits`] is much shorter.
const MAX_LENGTH: u64 = 16 << 20;

const HELP: &str = "\
Writes a WGSL module without f64 to standard output. It computes the same bits with integers.

Usage: lower-f64 MODULE

Example:
  lower-f64 module.wgsl > lowered.wgsl

The status is 0, or 2 if the module cannot be read, is invalid or uses what cannot be lowered.
";

fn main() -> ExitCode {
    let arguments: Vec<_> = std::env::args_os().skip(1).collect();
    let result = match &arguments[..] {
        [only] if only == "--help" || only == "-h" => write(HELP),
        [path] if !path.to_string_lossy().starts_with('-') => run(path),
        _ => Err("give the path of one WGSL file; see lower-f64 --help".to_owned()),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::from(2)
        }
    }
}

fn write(text: &str) -> Result<(), String> {
    let mut output = std::io::stdout().lock();
    let written = output.write_all(text.as_bytes()).and_then(|()| output.flush());
    written.map_err(|error| format!("standard output: {error}"))
}

fn run(path: &std::ffi::OsStr) -> Result<(), String> {
    let shown = path.to_string_lossy();
    let mut source = String::new();
    let file = std::fs::File::open(path).map_err(|error| format!("{shown}: {error}"))?;
    let length = file.take(MAX_LENGTH + 1).read_to_string(&mut source).map_err(|error| format!("{shown}: {error}"))?;
    if length as u64 > MAX_LENGTH {
        return Err(format!("{shown}: more than {MAX_LENGTH} bytes are no module that could be lowered"));
    }
    let lowered = lower_text(&shown, &source, &Arithmetic::standard()).map_err(|error| error.to_string())?;
    write(&lowered)
}
