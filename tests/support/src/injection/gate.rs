//! Runs a program that waits for an input, until `strace` watches the thread that reads this input.

use std::fs::{self, OpenOptions};
use std::io::Write;
use std::path::Path;
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};

use super::Job;
use crate::running::Running;

/// Time limit for each step of a program, long enough for a busy machine.
const PATIENCE: Duration = Duration::from_secs(120);

/// Runs the program of `job`, with the command `prefix` before it. The gate becomes a named pipe. When a thread of the
/// program waits for the pipe's content, `strace` attaches only to this thread. Then the content is written.
pub fn run(job: &Job, (gate, content): (&Path, &[u8]), prefix: &[&str], more: &[&str]) -> Result<Output, String> {
    let _ = fs::remove_file(gate);
    let made = Command::new("mkfifo").arg(gate).status();
    if !made.is_ok_and(|status| status.success()) {
        return Err("mkfifo failed".to_owned());
    }
    // On Linux, opening a pipe for reading and writing does not block. After that, the program's open does not block
    // either.
    let mut pipe = OpenOptions::new().read(true).write(true).open(gate).map_err(|error| error.to_string())?;
    let mut command = match prefix {
        [] => Command::new(&job.program),
        [first, rest @ ..] => {
            let mut command = Command::new(first);
            command.args(rest).arg(&job.program);
            command
        }
    };
    command.args(&job.arguments).stdout(Stdio::piped()).stderr(Stdio::piped());
    let failed = |error: std::io::Error| error.to_string();
    let program = Running::start(&mut command).map_err(failed)?;
    let first = program.id();
    let thread = until("the program reads the gate", || {
        let process = if prefix.is_empty() { first } else { only_child(first)? };
        waiting_thread(process, gate)
    })?;
    // strace writes the call in which the thread waits as soon as it watches the thread. So it watches when the log is
    // not empty.
    let log = job.log();
    fs::write(&log, "").map_err(|error| error.to_string())?;
    let mut strace = Command::new("strace");
    strace.args(["-y", "-qq", "-p", &thread.to_string(), "-o"]).arg(&log).args(more);
    let strace = Running::start(&mut strace).map_err(failed)?;
    until("strace watches", || fs::metadata(&log).ok().filter(|file| file.len() > 0))?;
    pipe.write_all(content).map_err(|error| error.to_string())?;
    drop(pipe);
    let output = program.output().map_err(failed)?;
    strace.output().map_err(failed)?;
    Ok(output)
}

/// Calls `ask` until it returns an answer, and returns the answer. Returns an error after the time [`PATIENCE`].
fn until<T>(what: &str, mut ask: impl FnMut() -> Option<T>) -> Result<T, String> {
    let start = Instant::now();
    while start.elapsed() < PATIENCE {
        if let Some(answer) = ask() {
            return Ok(answer);
        }
        std::thread::sleep(Duration::from_micros(500));
    }
    Err(format!("waited in vain until {what}"))
}

/// Returns the ID of the only child of a process with one thread, or `None` if it does not have exactly one child.
fn only_child(process: u32) -> Option<u32> {
    fs::read_to_string(format!("/proc/{process}/task/{process}/children")).ok()?.trim().parse().ok()
}

/// Returns the ID of the thread of `process` that waits for the content of the gate, if there is one.
fn waiting_thread(process: u32, gate: &Path) -> Option<u32> {
    let tasks = fs::read_dir(format!("/proc/{process}/task")).ok()?;
    let mut threads = tasks.filter_map(|entry| entry.ok()?.file_name().to_str()?.parse().ok());
    let gate = fs::canonicalize(gate).ok()?;
    threads.find(|&thread| is_waiting(process, thread, &gate).is_some_and(|is_waiting| is_waiting))
}

/// Whether a thread sleeps in a call whose first argument is a descriptor of `gate`. Returns `None` if that is not
/// known, for instance if the thread has ended.
fn is_waiting(process: u32, thread: u32, gate: &Path) -> Option<bool> {
    let state = fs::read_to_string(format!("/proc/{process}/task/{thread}/stat")).ok()?;
    // The state follows the program's name in parentheses. The name may contain parentheses too, so the last `)` is
    // used.
    if !state.rsplit_once(") ")?.1.starts_with('S') {
        return Some(false);
    }
    // The number of the call comes first, and then its arguments.
    let call = fs::read_to_string(format!("/proc/{process}/task/{thread}/syscall")).ok()?;
    let descriptor = u64::from_str_radix(call.split(' ').nth(1)?.strip_prefix("0x")?, 16).ok()?;
    Some(fs::read_link(format!("/proc/{process}/fd/{descriptor}")).ok()? == gate)
}
