//! Compiles a shader in a separate process first. The memory and the time of that process are limited.
//!
//! A short module can make naga or the driver's compiler use any amount of memory or time, for example by comparing
//! arrays of 500,000,000 elements. Neither can be stopped from inside the process. So `shader-lab` starts itself again
//! with [`FLAG`], and sends the text to that process. Only if that process ends within the limits does `shader-lab`
//! compile the text itself.

use std::ffi::OsString;
use std::io::{self, Read, Write};
use std::path::Path;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::time::{Duration, Instant};

use shaders::{Composition, Precision};

use crate::{Error, Gpu, Pipeline};

/// The first argument of the separate process. With this argument the program only compiles.
pub const FLAG: &str = "--compile-standard-input";

/// The limits of the separate process that compiles a shader first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// Largest address space in bytes.
    pub memory: u64,
    /// Largest processor time in whole seconds, at least 1.
    pub seconds: u64,
    /// Largest wall-clock time. After it the process is killed.
    pub patience: Duration,
}

impl Limits {
    /// The limits that `shader-lab` uses. The largest shader of this project needs a quarter of the memory. The
    /// wall-clock limit is six times the limit on processor time, because the machine may be busy.
    pub const STANDARD: Self = Self { memory: 4 << 30, seconds: 20, patience: Duration::from_secs(120) };
}

/// Exit status of the separate process if the device had too little memory. The parent process has no limit on its
/// memory, so it must not compile the shader then.
const OUT_OF_MEMORY: i32 = 3;

/// Largest size in bytes of the text that the separate process reads: all modules of a composition.
const MAX_TEXT: u64 = 1 << 26;

/// Compiles `composition` in a separate process, within the limits [`Limits::STANDARD`].
///
/// # Errors
/// The errors of [`check_within`].
pub fn check(composition: &Composition, constants: &[(&str, f64)]) -> Result<(), Error> {
    let program = std::env::current_exe().map_err(failed)?;
    check_within(&program, Limits::STANDARD, composition, constants)
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
    composition: &Composition,
    constants: &[(&str, f64)],
) -> Result<(), Error> {
    let mut command = Command::new(program);
    command.arg(FLAG).args([limits.memory, limits.seconds].map(|limit| limit.to_string()));
    command.arg(composition.precision().to_string());
    command.args(constants.iter().map(|(name, value)| format!("{name}={value}")));
    command.stdin(Stdio::piped()).stdout(Stdio::null()).stderr(Stdio::null());
    let mut child = command.spawn().map_err(failed)?;
    if let Some(mut input) = child.stdin.take() {
        // An error is ignored: writing fails if the process has ended already, and its status tells why it ended.
        let _ = input.write_all(composition.source().as_bytes());
    }
    let status = wait(&mut child, limits.patience).map_err(failed)?;
    // Status 2 means that the process has printed an error message. A panic has another status.
    if status.is_some_and(|status| matches!(status.code(), Some(0 | 2))) {
        return Ok(());
    }
    let message = format!(
        "the shader takes too much to compile: naga or the driver {}; at most {} MiB of memory and {} s are \
         allowed; simplify the modules",
        status.map_or_else(|| "did not come to an end".to_owned(), |status| format!("ended by {status}")),
        limits.memory >> 20,
        limits.seconds,
    );
    Err(Error::Request { message })
}

/// Waits until the process ends, and returns its status. After the time `patience`, kills the process and returns
/// `None`.
fn wait(child: &mut Child, patience: Duration) -> io::Result<Option<ExitStatus>> {
    let start = Instant::now();
    while start.elapsed() < patience {
        if let Some(status) = child.try_wait()? {
            return Ok(Some(status));
        }
        std::thread::sleep(Duration::from_millis(5));
    }
    child.kill()?;
    child.wait()?;
    Ok(None)
}

/// Does the work of the separate process: sets its own limits, reads the text from standard input and compiles it.
///
/// # Errors
/// An error of naga or of the driver, or an error if `arguments` are not those that [`check`] passes.
pub fn compile(arguments: impl IntoIterator<Item = OsString>) -> Result<(), Error> {
    let wrong = |message: &str| Error::Request { message: message.to_owned() };
    let mut arguments = arguments.into_iter().map(|argument| argument.to_string_lossy().into_owned());
    let mut limit = || arguments.next().and_then(|text| text.parse().ok()).ok_or_else(|| wrong("a limit is missing"));
    limit_this_process(limit()?, limit()?)?;
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
        let gpu = Gpu::open()?;
        Pipeline::with_constants(&gpu, &composition, &constants)?.warm_up(&gpu)
    };
    match compiled() {
        Err(Error::OutOfMemory { .. }) => std::process::exit(OUT_OF_MEMORY),
        other => other,
    }
}

#[cfg(unix)]
fn limit_this_process(memory: u64, seconds: u64) -> Result<(), Error> {
    use nix::sys::resource::{Resource, getrlimit, setrlimit};

    for (resource, limit) in
        [(Resource::RLIMIT_AS, memory), (Resource::RLIMIT_CPU, seconds), (Resource::RLIMIT_CORE, 0)]
    {
        let lowered = getrlimit(resource).and_then(|(_, most)| setrlimit(resource, limit.min(most), most));
        lowered.map_err(|error| Error::Request { message: format!("limits cannot be set: {error}") })?;
    }
    Ok(())
}

/// Does nothing, because systems other than Unix have no such limits. On these systems only the wall-clock limit of the
/// parent ends the process.
#[cfg(not(unix))]
fn limit_this_process(_memory: u64, _seconds: u64) -> Result<(), Error> {
    Ok(())
}
