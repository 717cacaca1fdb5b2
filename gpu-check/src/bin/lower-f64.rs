//! Rewrites a WGSL module into one without f64, which computes the same bits with integers.
//!
//!     lower-f64 MODULE > LOWERED

use std::ffi::OsString;
use std::io::{self, Read};
use std::path::Path;
use std::process::{Command, ExitCode};

use gpu_check::guard::{End, Limits, MAX_TEXT, REFUSED, limit_this_process};
use gpu_check::shader_lab::files::{read_text, shown};
use gpu_check::terminal;
use shaders::Error;
use shaders::lower::{Arithmetic, lower_text};

/// The first argument of the separate process, which lowers the text from its standard input.
const FLAG: &str = "--lower-standard-input";

const HELP: &str = "\
Writes a WGSL module without f64 to standard output. It computes the same bits with integers.

Usage: lower-f64 MODULE

Example:
  lower-f64 module.wgsl > lowered.wgsl

The status is 0, or 2 if the module cannot be read, is invalid, uses what cannot be lowered or takes too much to lower,
or if standard output cannot be written.
";

fn main() -> ExitCode {
    let mut arguments = std::env::args_os().skip(1).peekable();
    if arguments.next_if(|argument| argument == FLAG).is_some() {
        return in_separate_process(arguments);
    }
    let arguments: Vec<_> = arguments.collect();
    let result = match &arguments[..] {
        [only] if only == "--help" || only == "-h" => Ok(HELP.to_owned()),
        [path] if !path.as_encoded_bytes().starts_with(b"-") => lower(Path::new(path)),
        _ => Err("give the path of one WGSL file; see lower-f64 --help".to_owned()),
    };
    match result.and_then(|text| output::print(text.as_bytes()).map_err(|error| error.to_string())) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => terminal::failed(&message),
    }
}

/// Returns the lowered text of the module at `path`. Another process of this program lowers it, within limits on memory
/// and time.
fn lower(path: &Path) -> Result<String, String> {
    let shown = shown(path);
    let source = read_text(path).map_err(|error| format!("{shown}: {error}"))?;
    let mut command = Command::new(std::env::current_exe().map_err(|error| format!("this program: {error}"))?);
    command.arg(FLAG).args(Limits::STANDARD.arguments()).arg(&shown);
    match Limits::STANDARD.run(&mut command, &source).map_err(|error| format!("the process to lower in: {error}"))? {
        End::Success(text) => Ok(text),
        End::Refused(message) => Err(message),
        End::Excess(how) => Err(format!("{shown}: the module takes too much to lower: naga {how}; simplify it")),
    }
}

/// Does the work of the separate process: limits itself, and writes the lowered text or the message to standard output.
fn in_separate_process(arguments: impl Iterator<Item = OsString>) -> ExitCode {
    let mut arguments = arguments.map(|argument| argument.to_string_lossy().into_owned());
    let lowered = limit_this_process(&mut arguments).map_err(|error| error.to_string()).and_then(|()| {
        let path = arguments.next().unwrap_or_default();
        let mut source = String::new();
        io::stdin().take(MAX_TEXT).read_to_string(&mut source).map_err(|error| error.to_string())?;
        lower_text(&path, &source, &Arithmetic::standard()).map_err(|error| match error {
            Error::Invalid(place) | Error::CannotLower(place) => place.to_string(),
            other => format!("{path}: {other}"),
        })
    });
    let (text, status) = match lowered {
        Ok(text) => (text, ExitCode::SUCCESS),
        Err(message) => (message, ExitCode::from(REFUSED as u8)),
    };
    if output::print(text.as_bytes()).is_ok() { status } else { ExitCode::FAILURE }
}
