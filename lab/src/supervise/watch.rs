//! Watches a program while it runs: the second process of [`super::run`].

use std::collections::HashMap;
use std::ffi::OsString;
use std::fs::{self, File};
use std::io::{self, Seek, Write};
use std::os::fd::AsFd;
use std::os::unix::fs::PermissionsExt;
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

use super::{End, Limits, NONE, Outcome, PRINTED, Run};
use crate::{Failure, interrupt, terminal};

/// Most bytes that a program with a limit of memory may write into one file. A P3 file of the course's largest picture
/// has 25 MB.
const FILE_BYTES: u64 = 1 << 28;

/// Most bytes that are kept of what the program prints.
pub const KEPT_BYTES: u64 = 1 << 16;

/// Time between two samples of the program.
const TICK: Duration = Duration::from_millis(5);

/// Runs the command `words` under `limits` in the folder `place`, and writes the answer for [`super::run`] to standard
/// output. This process must not have started another one before.
///
/// # Errors
/// Standard output cannot be written, or [`Failure::Interrupted`].
pub fn answer(limits: &Limits, words: &[OsString], place: &Path, printed: &Path) -> Result<(), Failure> {
    let outcome = match watched(limits, words, place, printed) {
        Err(Failure::Interrupted) => return Err(Failure::Interrupted),
        outcome => outcome.map_err(|failure| failure.message().unwrap_or_default()),
    };
    let text = serde_json::to_vec(&outcome).map_err(|error| error.to_string())?;
    let mut out = File::from(io::stdout().as_fd().try_clone_to_owned()?);
    // All processes of the program have ended. What they wrote to this descriptor is removed.
    if out.metadata()?.is_file() {
        out.set_len(0)?;
        out.rewind()?;
    }
    Ok(out.write_all(&text)?)
}

fn watched(limits: &Limits, words: &[OsString], place: &Path, printed: &Path) -> Result<Outcome, Failure> {
    interrupt::listen();
    // The program inherits the limits of this process. Without core files, a crash takes no time and no disk.
    let file_bytes = (limits.memory < NONE.memory).then_some((Resource::RLIMIT_FSIZE, FILE_BYTES));
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
    command.args(rest).current_dir(place).stdin(Stdio::null());
    command.stdout(stdout.try_clone()?).stderr(stderr.try_clone()?).process_group(0);
    let meter = Meter::open();
    let energy = meter.as_ref().and_then(|meter| Some((meter, meter.read()?)));
    let start = Instant::now();
    let own_memory = peak_memory();
    let mut child = match command.spawn() {
        Ok(child) => child,
        Err(error) => return Ok(Err(not_started(Path::new(first), place, &error))),
    };
    let group = Pid::from_raw(child.id().cast_signed());
    let (send, ended) = mpsc::channel();
    std::thread::spawn(move || send.send((child.wait(), start.elapsed().as_secs_f64())));
    let (parent, mut broken, mut most, mut users) = (parent_id(), None, Sample::default(), HashMap::new());
    let (status, wall) = loop {
        if let Ok(ended) = ended.recv_timeout(TICK) {
            break ended;
        }
        let mut sample = Sample::default();
        sample.add_below(Pid::this(), &mut users);
        most.memory = sample.memory.max(most.memory);
        most.threads = sample.threads.max(most.threads);
        let kept = [
            (start.elapsed().as_secs_f64() > limits.seconds, End::TimeOut),
            (most.memory > limits.memory, End::OverMemory),
        ];
        broken = broken.or(kept.into_iter().find(|(is_broken, _)| *is_broken).map(|(_, end)| end));
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
    let is_counted = counted > own_memory + (1 << 18) || most.memory == 0.0;
    let memory = if is_counted { counted as f64 * 1e-6 } else { most.memory };
    let by_itself = || status.code().map_or_else(|| End::Signal(status.signal().unwrap_or(0)), End::Status);
    let end = broken.or((memory > limits.memory).then_some(End::OverMemory)).unwrap_or_else(by_itself);
    // The system does not count a process that its parent has refused to wait for. The samples do.
    let user = seconds_of_children().max(users.into_values().sum());
    Ok(Ok(Run { end, user, wall, memory, joules, threads: most.threads }))
}

/// Returns why the program `first` could not be started in the folder `place`, with the remedy.
fn not_started(first: &Path, place: &Path, error: &io::Error) -> String {
    let here = place.join(first);
    let name = terminal::quoted([first.as_os_str()]);
    if !place.is_dir() {
        return format!("{}: there is no such folder", terminal::name(place));
    }
    let text = super::content(&here.canonicalize().unwrap_or_else(|_| here.clone()), FILE_BYTES).unwrap_or_default();
    let line = text.split(|byte| *byte == b'\n').next().unwrap_or_default();
    let interpreter = line.strip_prefix(b"#!").map(|line| terminal::escape_lines(&String::from_utf8_lossy(line)));
    let is_one_name = first.components().count() == 1 && !first.as_os_str().as_encoded_bytes().contains(&b'/');
    let remedy = match (error.raw_os_error(), interpreter) {
        _ if is_one_name && here.is_file() => {
            format!("; name the program {}", terminal::quoted([Path::new(".").join(first).as_os_str()]))
        }
        (Some(2), _) if line.starts_with(b"#!") && line.ends_with(b"\r") => {
            "; its first line ends in CR LF, so its interpreter is not found: save it with LF".to_owned()
        }
        (Some(2), Some(interpreter)) => format!("; its interpreter [{}] is not found", interpreter.trim()),
        (Some(2), None) if here.is_file() => "; the file is there, but not the loader that it names".to_owned(),
        (Some(13), _) if here.metadata().is_ok_and(|it| it.is_file() && it.permissions().mode() & 0o111 == 0) => {
            format!("; it is not executable: chmod +x {name}")
        }
        (Some(8), _) => "; it is neither a program of this machine nor a script that begins with #!".to_owned(),
        _ => String::new(),
    };
    format!("{name}: {error}{remedy}")
}

/// What a look at the processes of the program has seen.
#[derive(Clone, Copy, Debug, Default)]
struct Sample {
    /// The resident memory of all processes, in MB.
    memory: f64,
    /// The largest number of threads of one process.
    threads: u32,
}

impl Sample {
    /// Adds all processes below the process `id`, and notes the user time of each in `users`, in seconds.
    fn add_below(&mut self, id: Pid, users: &mut HashMap<Pid, f64>) {
        /// The unit of the times in `/proc/PID/stat`, in seconds, on every Linux.
        const TICK_SECONDS: f64 = 0.01;
        for child in children(id) {
            let text = fs::read_to_string(format!("/proc/{child}/status")).unwrap_or_default();
            let field = |name: &str| {
                text.lines().find_map(|line| line.strip_prefix(name)?.split_whitespace().next()?.parse().ok())
            };
            self.memory += field("VmRSS:").map_or(0.0, |kilobytes: f64| kilobytes * 1024e-6);
            self.threads = self.threads.max(field("Threads:").unwrap_or(0.0) as u32);
            // The name in parentheses may have any characters. The user time is the twelfth field behind it.
            let stat = fs::read_to_string(format!("/proc/{child}/stat")).unwrap_or_default();
            let ticks = stat.rsplit_once(')').and_then(|(_, rest)| rest.split(' ').nth(12)?.parse::<f64>().ok());
            if let Some(ticks) = ticks {
                users.insert(child, ticks * TICK_SECONDS);
            }
            self.add_below(child, users);
        }
    }
}

/// Returns the processes that the process `id` has started or adopted, where the system tells them.
pub fn children(id: Pid) -> Vec<Pid> {
    let id = if id == Pid::this() { "self".to_owned() } else { id.to_string() };
    let threads = fs::read_dir(format!("/proc/{id}/task")).into_iter().flatten().flatten();
    let lists = threads.filter_map(|thread| fs::read_to_string(thread.path().join("children")).ok());
    lists
        .flat_map(|list| list.split(' ').filter_map(|id| id.parse().ok().map(Pid::from_raw)).collect::<Vec<_>>())
        .collect()
}

/// Ends all processes below this one, and waits for them.
fn end_all() {
    while let Ok(status) = waitpid(None, Some(WaitPidFlag::WNOHANG)) {
        if status == WaitStatus::StillAlive {
            if std::process::id() == 1 {
                // All other processes that the first process of its own table can see are the program's.
                let _ = kill(Pid::from_raw(-1), Signal::SIGKILL);
            }
            for id in children(Pid::this()).into_iter().filter(|_| std::process::id() != 1) {
                let _ = kill(id, Signal::SIGKILL);
            }
            std::thread::sleep(Duration::from_millis(1));
        }
    }
}
