//! Runs work on a WGSL text in a separate process. The memory and the time of that process are limited.
//!
//! A short module can make naga or the driver's compiler use any amount of memory or time, for example by comparing
//! arrays of 500,000,000 elements. Neither can be stopped from inside the process. So a program that reads WGSL of a
//! user starts itself again, and sends the text to that process.

use std::io::{self, Read, Write};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::time::{Duration, Instant};

use crate::Error;

/// The limits of the separate process.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// Largest address space in bytes.
    pub memory: u64,
    /// Largest processor time in whole seconds, at least 1.
    pub seconds: u64,
    /// Largest wall-clock time. After it the process is killed.
    pub patience: Duration,
}

/// Largest size in bytes of the text that the separate process reads, and of the text that it writes.
pub const MAX_TEXT: u64 = 1 << 26;

/// Exit status of the separate process if it has found an error in the text. A panic has another status.
pub const REFUSED: i32 = 2;

/// The end of the separate process.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum End {
    /// The process was successful and wrote this text to standard output.
    Success(String),
    /// The process found an error in the WGSL text, and wrote this message to standard output.
    Refused(String),
    /// A limit or a fault ended the process. The text says how it ended, and which limits it had.
    Excess(String),
}

impl Limits {
    /// The limits of all programs. The largest shader of this project needs a quarter of the memory. The wall-clock
    /// limit is thirty times the limit on processor time, because the machine may be busy.
    pub const STANDARD: Self = Self { memory: 4 << 30, seconds: 20, patience: Duration::from_secs(600) };

    /// Returns the limits as arguments for the separate process, which calls [`limit_this_process`].
    #[must_use]
    pub fn arguments(self) -> [String; 2] {
        [self.memory, self.seconds].map(|limit| limit.to_string())
    }

    /// Runs `command`, which must limit itself by [`Self::arguments`], with `input` as its standard input.
    ///
    /// # Errors
    /// The error of the system if the process cannot be started.
    pub fn run(self, command: &mut Command, input: &str) -> io::Result<End> {
        let mut child = command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::null()).spawn()?;
        let (stdin, stdout) = (child.stdin.take(), child.stdout.take());
        let (status, text) = std::thread::scope(|scope| {
            // Both pipes are served while the process runs, because it may read and write in any order. Errors are
            // ignored: a pipe fails if the process has ended, and its status tells why it ended.
            scope.spawn(move || stdin.map(|mut stdin| stdin.write_all(input.as_bytes())));
            let reader = scope.spawn(move || {
                let mut text = Vec::new();
                let _ = stdout.map(|stdout| stdout.take(MAX_TEXT + 1).read_to_end(&mut text));
                text
            });
            let status = wait(&mut child, self.patience);
            status.map(|status| (status, reader.join().unwrap_or_default()))
        })?;
        if text.len() as u64 > MAX_TEXT {
            return Ok(End::Excess(format!("wrote more than {MAX_TEXT} bytes")));
        }
        let text = String::from_utf8_lossy(&text).into_owned();
        Ok(match status.map(|status| status.code()) {
            Some(Some(0)) => End::Success(text),
            Some(Some(REFUSED)) => End::Refused(text),
            // An unmodified shader takes so long only if other programs keep the machine busy.
            None => End::Excess(format!(
                "did not end within {} s of elapsed time, perhaps because the machine is busy; try again",
                self.patience.as_secs()
            )),
            _ => End::Excess(format!(
                "{}; at most {} MiB of memory and {} s are allowed",
                status.map(|status| format!("ended by {status}")).unwrap_or_default(),
                self.memory >> 20,
                self.seconds,
            )),
        })
    }
}

/// Waits until the process ends, and returns its status. After the time `patience`, kills the process and returns
/// `None`.
pub(crate) fn wait(child: &mut Child, patience: Duration) -> io::Result<Option<ExitStatus>> {
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

/// Limits the memory and the processor time of this process. `arguments` begin with those of [`Limits::arguments`].
///
/// # Errors
/// [`Error::Request`] if a limit is missing or cannot be set.
pub fn limit_this_process(arguments: &mut impl Iterator<Item = String>) -> Result<(), Error> {
    let mut limit = || {
        let limit = arguments.next().and_then(|text| text.parse().ok());
        limit.ok_or_else(|| Error::Request { message: "a limit is missing".to_owned() })
    };
    set(limit()?, limit()?)
}

#[cfg(unix)]
fn set(memory: u64, seconds: u64) -> Result<(), Error> {
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
fn set(_memory: u64, _seconds: u64) -> Result<(), Error> {
    Ok(())
}
