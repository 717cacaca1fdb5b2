//! Runs another program once, under limits of time, memory and output, and returns how it ended and what it took.
//!
//! [`run`] starts the program through a second process of `render-lab`, its hidden command `supervise`, which calls
//! [`Limits::watch`]. This second process starts no other program, so the time that the system reports about its
//! children is that of the program alone.

use std::ffi::OsString;
use std::fs::{self, File};
use std::io::{self, Read};
use std::os::unix::process::{CommandExt, ExitStatusExt, parent_id};
use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::mpsc;
use std::time::{Duration, Instant};

use measure::clock::{peak_memory, peak_memory_of_children, seconds_of_children};
use measure::energy::Meter;
use nix::sys::resource::{Resource, getrlimit, setrlimit};
use nix::sys::signal::{Signal, kill, killpg};
use nix::sys::wait::{WaitPidFlag, WaitStatus, waitpid};
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

/// Limits that no run reaches.
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
}

/// Names of the files in the folder of a run that get what the program prints on standard output and standard error.
pub const PRINTED: [&str; 2] = ["stdout.txt", "stderr.txt"];

/// Most bytes that a program with a limit of memory may write into one file. A P3 file of the course's largest picture
/// has 25 MB.
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
    interrupt::listen();
    let mut command = Command::new(std::env::current_exe()?);
    command.args(["supervise", "--seconds", &limits.seconds.to_string(), "--memory", &limits.memory.to_string()]);
    command.arg("--printed").arg(std::path::absolute(printed)?).arg("--").args(words).current_dir(place);
    let output = command.stdin(Stdio::null()).output();
    let output = output.map_err(|error| format!("{}: {error}", crate::terminal::name(place)))?;
    interrupt::check()?;
    if output.status.code() == Some(i32::from(Failure::Interrupted.status())) {
        return Err(Failure::Interrupted);
    }
    serde_json::from_slice(&output.stdout).map_err(|_| {
        let said = String::from_utf8_lossy(&output.stderr);
        let message = said.trim_start_matches("Error: ").trim_end();
        let killed = "the process that watched the program was ended".to_owned();
        Failure::from(if message.is_empty() { killed } else { message.to_owned() })
    })
}

/// Returns the first bytes of a file, or nothing if it cannot be read. A program may print without end.
pub fn start_of(path: &Path) -> Vec<u8> {
    let mut bytes = Vec::new();
    // Opening a pipe might never return.
    if !path.symlink_metadata().is_ok_and(|metadata| metadata.is_file()) {
        return bytes;
    }
    let _ = File::open(path).and_then(|file| file.take(1 << 12).read_to_end(&mut bytes));
    bytes
}

impl Limits {
    /// Runs the command `words` as [`run`] does. This process must not have started another one before.
    ///
    /// # Errors
    /// The errors of [`run`].
    pub fn watch(&self, words: &[OsString], printed: &Path) -> Result<Run, Failure> {
        interrupt::listen();
        // The program inherits the limits of this process. Without core files, a crash takes no time and no disk.
        let file_bytes = (self.memory < NONE.memory).then_some((Resource::RLIMIT_FSIZE, FILE_BYTES));
        for (resource, limit) in file_bytes.into_iter().chain([(Resource::RLIMIT_CORE, 0)]) {
            let most = getrlimit(resource).map_err(io::Error::from)?.1;
            setrlimit(resource, limit.min(most), limit.min(most)).map_err(io::Error::from)?;
        }
        // A process that the program leaves behind becomes a child of this one, so it is ended, and its time counts.
        #[cfg(target_os = "linux")]
        nix::sys::prctl::set_child_subreaper(true).map_err(io::Error::from)?;
        let create = |name| {
            // An earlier run may have replaced the file, such as by a pipe.
            let _ = fs::remove_file(printed.join(name));
            File::create_new(printed.join(name))
        };
        let (stdout, stderr) = (create(PRINTED[0])?, create(PRINTED[1])?);
        let (first, rest) = words.split_first().ok_or("a command is needed")?;
        let mut command = Command::new(first);
        command
            .args(rest)
            .stdin(Stdio::null())
            .stdout(stdout.try_clone()?)
            .stderr(stderr.try_clone()?)
            .process_group(0);
        let meter = Meter::open();
        let energy = meter.as_ref().and_then(|meter| Some((meter, meter.read()?)));
        let start = Instant::now();
        let unknown = |error| {
            let here = Path::new(".").join(first);
            let [name, path] = [first.as_os_str(), here.as_os_str()].map(|word| crate::terminal::quoted([word]));
            let is_here = Path::new(first).components().count() == 1 && here.is_file();
            format!("{name}: {error}{}", if is_here { format!("; name the program {path}") } else { String::new() })
        };
        let own_memory = peak_memory();
        let mut child = command.spawn().map_err(unknown)?;
        let group = Pid::from_raw(child.id().cast_signed());
        let (send, ended) = mpsc::channel();
        std::thread::spawn(move || send.send((child.wait(), start.elapsed().as_secs_f64())));
        let (parent, mut broken, mut seen) = (parent_id(), None, 0.0);
        let (status, wall) = loop {
            if let Ok(ended) = ended.recv_timeout(TICK) {
                break ended;
            }
            seen = memory_below(Pid::this()).max(seen);
            let limits =
                [(start.elapsed().as_secs_f64() > self.seconds, End::TimeOut), (seen > self.memory, End::OverMemory)];
            broken = broken.or(limits.into_iter().find(|(is_broken, _)| *is_broken).map(|(_, end)| end));
            if broken.is_some() || interrupt::flow().is_break() || parent_id() != parent {
                // The program may have left its group.
                let _ = kill(group, Signal::SIGKILL);
                let _ = killpg(group, Signal::SIGKILL);
            }
        };
        let _ = killpg(group, Signal::SIGKILL);
        end_all();
        let joules = energy.and_then(|(meter, before)| meter.joules_since(&before));
        interrupt::check()?;
        let status = status?;
        for file in [stdout, stderr] {
            // A program that printed without end would fill the disk, one case after the other.
            file.set_len(file.metadata()?.len().min(KEPT_BYTES))?;
        }
        // The system counts the memory of this process as the program's until the program has replaced it.
        let counted = peak_memory_of_children();
        let memory = if counted > own_memory + (1 << 18) || seen == 0.0 { counted as f64 * 1e-6 } else { seen };
        let by_itself = || status.code().map_or_else(|| End::Signal(status.signal().unwrap_or(0)), End::Status);
        let end = broken.or((memory > self.memory).then_some(End::OverMemory)).unwrap_or_else(by_itself);
        Ok(Run { end, user: seconds_of_children(), wall, memory, joules })
    }
}

/// Returns the processes that the process `id` has started or adopted, where the system tells them.
fn children(id: Pid) -> Vec<Pid> {
    let threads = fs::read_dir(format!("/proc/{id}/task")).into_iter().flatten().flatten();
    let lists = threads.filter_map(|thread| fs::read_to_string(thread.path().join("children")).ok());
    lists
        .flat_map(|list| list.split(' ').filter_map(|id| id.parse().ok().map(Pid::from_raw)).collect::<Vec<_>>())
        .collect()
}

/// Returns the resident memory of all processes below the process `id`, in MB.
fn memory_below(id: Pid) -> f64 {
    let memory = |id: Pid| {
        let text = fs::read_to_string(format!("/proc/{id}/status")).unwrap_or_default();
        let own = text.lines().find_map(|line| line.strip_prefix("VmRSS:")?.strip_suffix("kB")?.trim().parse().ok());
        own.map_or(0.0, |kilobytes: f64| kilobytes * 1024e-6) + memory_below(id)
    };
    children(id).into_iter().map(memory).sum()
}

/// Ends all processes below this one, and waits for them.
fn end_all() {
    while let Ok(status) = waitpid(None, Some(WaitPidFlag::WNOHANG)) {
        if status == WaitStatus::StillAlive {
            for id in children(Pid::this()) {
                let _ = kill(id, Signal::SIGKILL);
            }
            std::thread::sleep(Duration::from_millis(1));
        }
    }
}
