//! Runs another program once, under limits of time, memory and output, and returns how it ended and what it took.
//!
//! [`run`] starts the program through a second process of `render-lab`, its hidden command `supervise`, which calls
//! [`Limits::watch`]. This second process starts no other program, so the time that the system reports about its
//! children is that of the program alone.

use std::ffi::OsString;
use std::fs::File;
use std::io::Read;
use std::os::unix::process::{CommandExt, ExitStatusExt, parent_id};
use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::time::{Duration, Instant};

use measure::clock::{peak_memory, peak_memory_of_children, seconds_of_children};
use measure::energy::Meter;
use nix::sys::resource::{Resource, setrlimit};
use nix::sys::signal::{Signal, killpg};
use nix::unistd::Pid;
use serde::{Deserialize, Serialize};

use crate::Failure;
use crate::interrupt::Interrupt;

/// The limits of one run.
#[derive(Clone, Copy, Debug, PartialEq, clap::Args)]
pub struct Limits {
    /// Longest time of a run, in seconds
    #[arg(long, default_value_t = 10.0, value_parser = above_zero)]
    pub seconds: f64,
    /// Largest resident memory of a run, in MB
    #[arg(long, value_name = "MB", default_value_t = 2048.0, value_parser = above_zero)]
    pub memory: f64,
}

/// Limits that no run reaches.
pub const NONE: Limits = Limits { seconds: 1e9, memory: 1e9 };

/// Returns the number in `text`.
///
/// # Errors
/// It is not a number above 0, or above a thousand millions.
pub fn above_zero(text: &str) -> Result<f64, String> {
    let number = text.parse().ok().filter(|&number: &f64| number > 0.0 && number <= NONE.seconds);
    number.ok_or_else(|| "a number above 0 is needed".to_owned())
}

/// How a run ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum End {
    /// With this exit status.
    Status(i32),
    /// By this signal, as after a crash.
    Signal(i32),
    /// It took longer than [`Limits::seconds`] and was ended.
    TimeOut,
    /// It needed more than [`Limits::memory`] and was ended.
    OverMemory,
}

impl std::fmt::Display for End {
    fn fmt(&self, out: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Status(status) => write!(out, "exit status {status}"),
            Self::Signal(signal) => write!(out, "ended by signal {}", signal_name(*signal)),
            Self::TimeOut => out.write_str("over the limit of time"),
            Self::OverMemory => out.write_str("over the limit of memory"),
        }
    }
}

/// Returns the name of a signal, such as `SIGSEGV`, or its number if it has no name.
#[must_use]
pub fn signal_name(signal: i32) -> String {
    Signal::try_from(signal).map_or_else(|_| signal.to_string(), |signal| signal.to_string())
}

/// How a run ended, and what it took.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Run {
    /// How it ended.
    pub end: End,
    /// User time in seconds.
    pub user: f64,
    /// Elapsed time in seconds.
    pub wall: f64,
    /// Largest resident memory in MB (10⁶ bytes). Below the 5 MB of `render-lab` itself, it is what was seen when the
    /// program was last looked at.
    pub memory: f64,
    /// The energy that the machine used meanwhile, in joules, or `None` if there is no meter.
    pub joules: Option<f64>,
}

/// Names of the files in the folder of a run that get what the program prints on standard output and standard error.
pub const PRINTED: [&str; 2] = ["stdout.txt", "stderr.txt"];

/// Most bytes that the program may write into one file. A P3 file of the course's largest picture has 25 MB.
const FILE_BYTES: u64 = 1 << 28;

/// Most bytes that are kept of what the program prints.
const KEPT_BYTES: u64 = 1 << 16;

/// Time between two looks at the memory of the program.
const TICK: Duration = Duration::from_millis(5);

/// Runs the command `words` once in the folder `place`, and waits until it has ended. What it prints is in the files
/// [`PRINTED`] of the folder `printed`.
///
/// # Errors
/// The command cannot be started, or [`Failure::Interrupted`].
pub fn run(words: &[OsString], place: &Path, printed: &Path, limits: &Limits) -> Result<Run, Failure> {
    // Without this, a request to stop would end this process at once, and leave its temporary folder.
    let interrupt = Interrupt::listen();
    let mut command = Command::new(std::env::current_exe()?);
    command.args(["supervise", "--seconds", &limits.seconds.to_string(), "--memory", &limits.memory.to_string()]);
    command.arg("--printed").arg(std::path::absolute(printed)?).arg("--").args(words).current_dir(place);
    let output = command.stdin(Stdio::null()).output();
    let output = output.map_err(|error| format!("{}: {error}", crate::terminal::name(place)))?;
    interrupt.check()?;
    if output.status.code() == Some(i32::from(Failure::Interrupted.status())) {
        return Err(Failure::Interrupted);
    }
    let message = || String::from_utf8_lossy(&output.stderr).trim_start_matches("Error: ").trim_end().to_owned();
    serde_json::from_slice(&output.stdout).map_err(|_| message().into())
}

/// Returns the first bytes of a file, or nothing if it cannot be read. A program may print without end.
#[must_use]
pub fn start_of(path: &Path) -> Vec<u8> {
    let mut bytes = Vec::new();
    let _ = File::open(path).and_then(|file| file.take(1 << 12).read_to_end(&mut bytes));
    bytes
}

impl Limits {
    /// Runs the command `words` as [`run`] does. This process must not have started another one before.
    ///
    /// # Errors
    /// The errors of [`run`].
    pub fn watch(&self, words: &[OsString], printed: &Path) -> Result<Run, Failure> {
        let interrupt = Interrupt::listen();
        // The program inherits the limits of this process. Without core files, a crash takes no time and no disk.
        for (resource, limit) in [(Resource::RLIMIT_FSIZE, FILE_BYTES), (Resource::RLIMIT_CORE, 0)] {
            setrlimit(resource, limit, limit).map_err(|error| error.to_string())?;
        }
        let [stdout, stderr] = PRINTED.map(|name| File::create(printed.join(name)));
        let (first, rest) = words.split_first().ok_or("a command is needed")?;
        let mut command = Command::new(first);
        command.args(rest).stdin(Stdio::null()).stdout(stdout?).stderr(stderr?).process_group(0);
        let meter = Meter::open();
        let energy = meter.as_ref().and_then(|meter| Some((meter, meter.read()?)));
        let start = Instant::now();
        let unknown = |error| format!("{}: {error}", crate::terminal::quoted([first.as_os_str()]));
        let own_memory = peak_memory();
        let mut child = command.spawn().map_err(unknown)?;
        let group = Pid::from_raw(child.id().cast_signed());
        let (ended, end) = mpsc::channel();
        let (status, wall, (broken, seen)) = std::thread::scope(|scope| {
            let interrupt = &interrupt;
            let watcher = scope.spawn(move || {
                let broken = self.broken(group, start, interrupt, &end);
                // Ends also the processes that the program has started and left.
                let _ = killpg(group, Signal::SIGKILL);
                broken
            });
            let status = child.wait();
            let wall = start.elapsed().as_secs_f64();
            drop(ended);
            (status, wall, watcher.join().unwrap_or_default())
        });
        let joules = energy.and_then(|(meter, before)| meter.joules_since(&before));
        interrupt.check()?;
        let status = status?;
        for name in PRINTED {
            // A program that printed without end would fill the disk, one case after the other.
            let file = File::options().write(true).open(printed.join(name))?;
            file.set_len(file.metadata()?.len().min(KEPT_BYTES))?;
        }
        // The system counts the memory of this process as the program's until the program has replaced it.
        let counted = peak_memory_of_children();
        let memory = if counted > own_memory + (1 << 18) || seen == 0.0 { counted as f64 * 1e-6 } else { seen };
        let by_itself = || status.code().map_or_else(|| End::Signal(status.signal().unwrap_or(0)), End::Status);
        let end = broken.or((memory > self.memory).then_some(End::OverMemory)).unwrap_or_else(by_itself);
        Ok(Run { end, user: seconds_of_children(), wall, memory, joules })
    }

    /// Waits until the process `id` has ended, which the closing of `end` tells, or until it has to be ended. Returns
    /// the limit that it has broken, and the largest memory that was seen, in MB.
    fn broken(&self, id: Pid, start: Instant, interrupt: &Interrupt, end: &mpsc::Receiver<()>) -> (Option<End>, f64) {
        let (parent, status, mut seen) = (parent_id(), format!("/proc/{id}/status"), 0.0);
        while let Err(RecvTimeoutError::Timeout) = end.recv_timeout(TICK) {
            let text = std::fs::read_to_string(&status).unwrap_or_default();
            let peak =
                text.lines().find_map(|line| line.strip_prefix("VmHWM:")?.strip_suffix("kB")?.trim().parse().ok());
            seen = peak.map_or(seen, |kilobytes: f64| kilobytes * 1024e-6);
            if start.elapsed().as_secs_f64() > self.seconds {
                return (Some(End::TimeOut), seen);
            }
            if seen > self.memory {
                return (Some(End::OverMemory), seen);
            }
            if interrupt.flow().is_break() || parent_id() != parent {
                break;
            }
        }
        (None, seen)
    }
}
