//! Compiles a shader in a separate process first, within the limits of [`crate::guard`].
//!
//! `shader-lab` starts itself again with [`FLAG`], and sends the text to that process. Only if that process ends within
//! the limits does `shader-lab` compile the text itself.

use std::ffi::OsString;
use std::io::{self, Read};
use std::path::Path;
use std::process::Command;

use shaders::{Composition, Precision};

use crate::guard::{End, Limits, MAX_TEXT, limit_this_process};
use crate::{Error, Form, Gpu, Pipeline};

/// The first argument of the separate process. With this argument the program only compiles.
pub const FLAG: &str = "--compile-standard-input";

/// Exit status of the separate process if the device had too little memory. The parent process has no limit on its
/// memory, so it must not compile the shader then.
const OUT_OF_MEMORY: i32 = 3;

/// Compiles `composition` in a separate process, in the form that `gpu` wants, within the limits [`Limits::STANDARD`].
///
/// # Errors
/// The errors of [`check_within`].
pub fn check(gpu: &Gpu, composition: &Composition, constants: &[(&str, f64)]) -> Result<(), Error> {
    let program = std::env::current_exe().map_err(failed)?;
    check_within(&program, Limits::STANDARD, gpu.wanted_form(), composition, constants)
}

fn failed(cause: io::Error) -> Error {
    Error::Request { message: format!("the process to compile in: {cause}") }
}

/// Compiles `composition` in a process of `program` (which is `shader-lab`), within `limits`.
///
/// An error in the text is not returned here, because the caller compiles the text again and then reports the error
/// with its place.
///
/// # Errors
/// [`Error::Request`] if a limit or a fault ended the process, or if it could not be started.
pub fn check_within(
    program: &Path,
    limits: Limits,
    form: Form,
    composition: &Composition,
    constants: &[(&str, f64)],
) -> Result<(), Error> {
    let mut command = Command::new(program);
    command.arg(FLAG).args(limits.arguments());
    command.arg(form.to_string()).arg(composition.precision().to_string());
    command.args(constants.iter().map(|(name, value)| format!("{name}={value}")));
    match limits.run(&mut command, composition.source()).map_err(failed)? {
        End::Success(_) | End::Refused(_) => Ok(()),
        End::Excess(how) => {
            let message =
                format!("the shader takes too much to compile: naga or the driver {how}; simplify the modules");
            Err(Error::Request { message })
        }
    }
}

/// Does the work of the separate process: sets its own limits, reads the text from standard input and compiles it.
///
/// # Errors
/// An error of naga or of the driver, or an error if `arguments` are not those that [`check`] passes.
pub fn compile(arguments: impl IntoIterator<Item = OsString>) -> Result<(), Error> {
    let wrong = |message: &str| Error::Request { message: message.to_owned() };
    let mut arguments = arguments.into_iter().map(|argument| argument.to_string_lossy().into_owned());
    limit_this_process(&mut arguments)?;
    let form = arguments.next().unwrap_or_default().parse::<Form>().map_err(|message| wrong(&message))?;
    let precision = arguments.next();
    let precision = Precision::ALL.into_iter().find(|known| Some(known.to_string()) == precision);
    let precision = precision.ok_or_else(|| wrong("the precision is missing"))?;
    let constants: Option<Vec<(String, f64)>> = arguments
        .map(|text| text.split_once('=').and_then(|(name, value)| Some((name.to_owned(), value.parse().ok()?))))
        .collect();
    let constants = constants.ok_or_else(|| wrong("a constant is not NAME=VALUE"))?;
    let constants: Vec<_> = constants.iter().map(|(name, value)| (name.as_str(), *value)).collect();
    let mut text = String::new();
    io::stdin().take(MAX_TEXT).read_to_string(&mut text).map_err(|error| wrong(&error.to_string()))?;
    let composition = Composition::of_text(text, precision);
    // The text is validated before the driver is loaded, so that the driver's memory does not count against the limit.
    composition.validate()?;
    let compiled = || {
        let gpu = Gpu::open()?.with_form(form);
        Pipeline::new(&gpu, &composition, &constants)?.warm_up(&gpu)
    };
    match compiled() {
        Err(Error::OutOfMemory { .. }) => std::process::exit(OUT_OF_MEMORY),
        other => other,
    }
}
