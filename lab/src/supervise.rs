//! Runs another program once, under limits of time, memory and output, and returns how it ended and what it took.
//!
//! [`run`] starts the program through a second process of `render-lab`, its hidden command `supervise`. This process
//! starts no other program, so the time that the system reports about its children is that of the program alone.
//! [`confine`] keeps the program away from all other processes where the system allows it, and [`watch`] watches it.
//!
//! The program cannot forge the result. The watching process writes the answer when all processes of the program have
//! ended, and it first removes what they may have written to the same descriptor. The answer counts only if the
//! watching process has ended with status 0.

pub mod confine;
pub mod watch;

use std::ffi::OsString;
use std::fs::File;
use std::io::{Read, Seek};
use std::os::unix::fs::OpenOptionsExt;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::Mutex;
use std::time::{Duration, Instant};

use nix::fcntl::OFlag;
use nix::sys::signal::{Signal, kill};
use nix::sys::wait::waitpid;
use nix::unistd::Pid;
use serde::{Deserialize, Serialize};

use crate::numbers::above_zero;
use crate::{Failure, interrupt};

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

/// Limits that no run reaches. A program under them is not confined either.
pub const NONE: Limits = Limits { seconds: 1e9, memory: 1e9 };

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
    /// It ended or stopped the process that watches it.
    Unwatched,
}

impl std::fmt::Display for End {
    fn fmt(&self, out: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Status(status) => write!(out, "exit status {status}"),
            Self::Signal(signal) => write!(out, "ended by signal {}", signal_name(*signal)),
            Self::TimeOut => out.write_str("over the limit of time"),
            Self::OverMemory => out.write_str("over the limit of memory"),
            Self::Unwatched => out.write_str("it ended or stopped the process that watches it"),
        }
    }
}

/// Returns the name of a signal, such as `SIGSEGV`, or its number if it has no name.
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
    /// Largest resident memory in MB (10⁶ bytes) of the program or of all its processes together. Of a program that
    /// needs less than `render-lab` itself, which is about 7 MB, it is the largest sample of one every 5 ms.
    pub memory: f64,
    /// The energy that the machine used meanwhile, in joules, or `None` if there is no meter.
    pub joules: Option<f64>,
    /// The largest number of threads that one process of the program had in a sample.
    pub threads: u32,
}

/// How a run ended and what it took, or why the program could not be started.
type Outcome = Result<Run, String>;

/// Names of the files in the folder of a run that get what the program prints on standard output and standard error.
pub const PRINTED: [&str; 2] = ["stdout.txt", "stderr.txt"];

/// The program of this process. The system keeps it when another file gets its name, as `cargo build` does.
const OWN_PROGRAM: &str = "/proc/self/exe";

/// Time between two looks at the watching process.
const TICK: Duration = Duration::from_millis(2);

/// Time in which the watching process must end after a request to stop.
const PATIENCE: Duration = Duration::from_millis(60);

/// The watching processes that run. A process that is none of them, and a child of this one, belongs to a program.
static WATCHING: Mutex<Vec<Pid>> = Mutex::new(Vec::new());

/// Runs the command `words` once in the folder `place`, and waits until it has ended. What it prints is in the files
/// [`PRINTED`] of the folder `printed`. The program sees
/// `place` and `printed`, and nothing else in the folders `hidden`, where the system allows that.
///
/// # Errors
/// [`Failure::Program`] if the program cannot be started, [`Failure::Interrupted`], or another one if this program
/// cannot start itself.
pub fn run(
    words: &[OsString],
    place: &Path,
    printed: &Path,
    limits: &Limits,
    hidden: &[PathBuf],
) -> Result<Run, Failure> {
    // Without this, a request to stop would end this process at once, and leave its temporary folder.
    interrupt::listen();
    #[cfg(target_os = "linux")]
    nix::sys::prctl::set_child_subreaper(true).map_err(std::io::Error::from)?;
    let mut answer = tempfile::tempfile()?;
    let own = Path::new(OWN_PROGRAM);
    let mut command = Command::new(if own.exists() { own.to_owned() } else { std::env::current_exe()? });
    command.args(["supervise", "--seconds", &limits.seconds.to_string(), "--memory", &limits.memory.to_string()]);
    if limits.memory < NONE.memory {
        command.arg("--confined");
    }
    for folder in hidden {
        command.arg("--hidden").arg(folder);
    }
    command.arg("--place").arg(place).arg("--printed").arg(std::path::absolute(printed)?).arg("--").args(words);
    command.stdin(Stdio::null()).stdout(answer.try_clone()?).stderr(Stdio::null());
    // Under the lock, because another thread would end a child that it does not know.
    let spawned = with_watching(|all| {
        let watcher = command.spawn()?;
        all.push(Pid::from_raw(watcher.id().cast_signed()));
        Ok::<_, std::io::Error>(watcher)
    });
    let mut watcher = spawned.map_err(|error| format!("render-lab cannot start itself: {error}"))?;
    let id = Pid::from_raw(watcher.id().cast_signed());
    let ended = wait(&mut watcher, limits);
    with_watching(|all| all.retain(|other| *other != id));
    let status = ended?;
    if status.is_none_or(|status| !status.success()) {
        end_orphans();
    }
    interrupt::check()?;
    if status.is_some_and(|status| status.success()) {
        answer.rewind()?;
        let answer: Result<Outcome, String> = serde_json::from_reader(answer).map_err(|error| error.to_string())?;
        return answer?.map_err(Failure::Program);
    }
    Ok(Run { end: End::Unwatched, user: 0.0, wall: 0.0, memory: 0.0, joules: None, threads: 0 })
}

/// Waits until the watching process has ended, and returns its status, or `None` if it was stopped for longer than the
/// limit and has been ended.
fn wait(watcher: &mut Child, limits: &Limits) -> Result<Option<std::process::ExitStatus>, Failure> {
    let start = Instant::now();
    // The watching process keeps the limit of the program. A stopped one does not.
    let latest = 1.5 * limits.seconds + 5.0;
    let mut asked: Option<Instant> = None;
    loop {
        if let Some(status) = watcher.try_wait()? {
            return Ok(Some(status));
        }
        if asked.is_none() && interrupt::flow().is_break() {
            let _ = kill(Pid::from_raw(watcher.id().cast_signed()), Signal::SIGTERM);
            asked = Some(Instant::now());
        }
        if asked.is_some_and(|asked| asked.elapsed() > PATIENCE) || start.elapsed().as_secs_f64() > latest {
            watcher.kill()?;
            watcher.wait()?;
            return Ok(None);
        }
        std::thread::sleep(TICK);
    }
}

fn with_watching<T>(change: impl FnOnce(&mut Vec<Pid>) -> T) -> T {
    change(&mut WATCHING.lock().unwrap_or_else(std::sync::PoisonError::into_inner))
}

/// Ends the processes of a program whose watching process has ended before them: they became children of this process.
/// When such a process ends, its own children do so too.
fn end_orphans() {
    with_watching(|watching| {
        loop {
            let orphans = watch::children(Pid::this()).into_iter().filter(|id| !watching.contains(id));
            let orphans: Vec<_> = orphans.collect();
            if orphans.is_empty() {
                break;
            }
            for id in orphans {
                let _ = kill(id, Signal::SIGKILL);
                let _ = waitpid(id, None);
            }
        }
    });
}

/// Returns the content of a regular file of at most `limit` bytes that a program may have written. A link, a pipe, a
/// folder and a longer file give `None`: a pipe might never end, and a link lead to any file.
pub fn content(path: &Path, limit: u64) -> Option<Vec<u8>> {
    let flags = (OFlag::O_NOFOLLOW | OFlag::O_NONBLOCK).bits();
    let file = File::options().read(true).custom_flags(flags).open(path).ok()?;
    let metadata = file.metadata().ok()?;
    let mut bytes = Vec::new();
    bytes.try_reserve_exact(usize::try_from(metadata.len().min(limit)).ok()?).ok()?;
    (metadata.is_file() && metadata.len() <= limit).then_some(())?;
    file.take(limit).read_to_end(&mut bytes).ok()?;
    Some(bytes)
}

/// Returns the first bytes of a file that a program printed, or nothing if it cannot be read.
pub fn start_of(path: &Path) -> Vec<u8> {
    let mut bytes = content(path, watch::KEPT_BYTES).unwrap_or_default();
    bytes.truncate(1 << 12);
    bytes
}
