//! A program whose system calls fail one after the other, and which signals meet in each of them.
//!
//! `strace` runs the program once to list the calls on the way of its output. Then the program runs again for each of
//! them, which fails once or is met by a signal. After each run every file of the output is the old one or the new one,
//! the status says which, and nothing else is in the folder.
//!
//! `strace` counts the calls of each thread, and disturbs the n-th of a name in every thread. So a program that works
//! on a thread of its own is given a [gate](Job::gate): there it waits until `strace` watches that thread alone.

mod calls;
mod check;
mod gate;
mod runs;

use std::collections::BTreeMap;
use std::ffi::OsString;
use std::fs;
use std::os::unix::process::ExitStatusExt;
use std::path::PathBuf;
use std::process::{Command, Output};

use calls::Call;
pub use runs::{Runs, most, total};

/// What each call fails with.
const ERRORS: [&str; 4] = ["EIO", "ENOSPC", "EPERM", "EINTR"];

/// The signal that meets each call.
const SIGNAL: &str = "TERM";
const SIGNAL_NUMBER: i32 = 15;

/// A program that makes the files in `folder`.
#[derive(Clone, Debug)]
pub struct Job {
    /// The program.
    pub program: PathBuf,
    /// Its arguments, of which one names `folder` or a file in it.
    pub arguments: Vec<OsString>,
    /// A folder of the job's own, in which the program writes and nothing else does. Its name is in no other path.
    pub folder: PathBuf,
    /// What every file of the output holds before, if anything.
    pub old: Option<Vec<u8>>,
    /// Whether the program may go on to a good end after a request to stop. Else it ends by the signal at once.
    pub graceful: bool,
    /// An input of the program and its content. Calls before the program reads this input are not disturbed. Without a
    /// gate, calls whose name and number more than one thread makes are not disturbed.
    pub gate: Option<(PathBuf, Vec<u8>)>,
    /// Whether only calls are disturbed that name `folder` or use a file in it. Else every call about files is, from
    /// the first on that names `folder`.
    pub only_folder: bool,
    /// How many calls of each name are disturbed at most: the first, the last, and others evenly between them. See
    /// [`most`].
    pub most: usize,
}

/// How a call is disturbed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Disturbance {
    /// Each call fails with each error.
    Errors,
    /// A request to stop comes in each call.
    Signal,
    /// The same where the program is process 1, which no signal ends by itself.
    SignalAsProcessOne,
    /// As [`Disturbance::Errors`] and [`Disturbance::Signal`], on a file system that makes no files without a name.
    Named,
}

/// Why nothing can be disturbed here, if so.
#[must_use]
pub fn unavailable(disturbance: Disturbance) -> Option<&'static str> {
    let strace = ["strace", "-qq", "-o", "/dev/null", "-e", "inject=close:error=EIO:when=1000", "true"];
    let attach = ["bash", "-c", "sleep 1 & strace -qq -o /dev/null -p $!"];
    let unshare = ["unshare", "-pf", "strace", "-D", "-qq", "-o", "/dev/null", "true"];
    let runs =
        |command: &[&str]| Command::new(command[0]).args(&command[1..]).output().is_ok_and(|run| run.status.success());
    if !runs(&strace) || !runs(&attach) {
        return Some("needs strace and the right to trace");
    }
    (disturbance == Disturbance::SignalAsProcessOne && !runs(&unshare)).then_some("needs the right to be process 1")
}

/// What the files of the output hold when the program has succeeded.
type Files = BTreeMap<PathBuf, Vec<u8>>;

impl Job {
    /// Disturbs one call after the other. Returns how many runs were made, which is not 0.
    ///
    /// # Errors
    /// The first run after which a file is neither the old nor the new one, with what the program said.
    pub fn disturb(&self, disturbance: Disturbance) -> Result<Runs, String> {
        self.prepare(&Files::new()).map_err(|error| error.to_string())?;
        let output = self.run(&Files::new(), false, &[])?;
        let new = check::files(&self.folder).map_err(|error| error.to_string())?;
        if !output.status.success() || new.is_empty() {
            return Err(format!("undisturbed: {new:?}, {output:?}"));
        }
        let calls = self.calls(&new, &[])?;
        let runs = match disturbance {
            Disturbance::Errors => self.each(calls, |calls| self.fail(&new, calls, &[]))?,
            Disturbance::Signal => self.each(calls, |calls| self.signal(&new, calls, &[], false))?,
            Disturbance::SignalAsProcessOne => self.each(calls, |calls| self.signal(&new, calls, &[], true))?,
            Disturbance::Named => {
                let unnamed = calls.iter().find(|call| call.text.contains("O_TMPFILE"));
                let unnamed = unnamed.ok_or("no file without a name was made")?;
                let inject = format!("inject=openat:error=EOPNOTSUPP:when={}", unnamed.number);
                let first = ["-e", &inject[..]];
                // strace disturbs a call by one rule only.
                let mut calls = self.calls(&new, &first)?;
                if !calls.iter().any(|call| call.text.contains("O_EXCL")) {
                    return Err("no file with a name was made".to_owned());
                }
                calls.retain(|call| call.name != "openat");
                self.each(
                    calls,
                    |calls| Ok(self.fail(&new, calls, &first)? + self.signal(&new, calls, &first, false)?),
                )?
            }
        };
        runs::add(runs);
        if runs.made == 0 { Err("nothing was disturbed".to_owned()) } else { Ok(runs) }
    }

    /// Does `disturb` for the calls that are chosen. It makes as many runs for each call.
    fn each(&self, calls: Vec<Call>, disturb: impl Fn(&[Call]) -> Result<usize, String>) -> Result<Runs, String> {
        let all = calls.len();
        let chosen = calls::spread(calls, self.most);
        let made = disturb(&chosen)?;
        Ok(Runs { made, all: made * all / chosen.len().max(1) })
    }

    fn fail(&self, new: &Files, calls: &[Call], more: &[&str]) -> Result<usize, String> {
        let mut runs = 0;
        for (call, error) in calls.iter().flat_map(|call| ERRORS.map(|error| (call, error))) {
            let inject = format!("inject={}:error={error}:when={}", call.name, call.number);
            let output = self.run(new, false, &[more, &["-e", &inject]].concat())?;
            self.check(new, &output, false).map_err(|error| format!("{inject}: {error}"))?;
            // Permissions that cannot be set are no reason to lose the picture.
            if call.name == "fchmod" && !output.status.success() {
                return Err(format!("{inject}: {output:?}"));
            }
            runs += 1;
        }
        Ok(runs)
    }

    fn signal(&self, new: &Files, calls: &[Call], more: &[&str], as_process_one: bool) -> Result<usize, String> {
        let mut runs = 0;
        for call in calls {
            let inject = format!("inject={}:signal={SIGNAL}:when={}", call.name, call.number);
            let output = self.run(new, as_process_one, &[more, &["-e", &inject]].concat())?;
            // strace ends as the program did.
            let ended = if as_process_one {
                output.status.code() == Some(128 + SIGNAL_NUMBER)
            } else {
                output.status.signal() == Some(SIGNAL_NUMBER)
            };
            let checked = if ended || self.graceful {
                self.check(new, &output, ended)
            } else {
                Err(format!("the signal did not end it: {output:?}"))
            };
            checked.map_err(|error| format!("{inject}: {error}"))?;
            runs += 1;
        }
        Ok(runs)
    }

    /// The calls to disturb, from a run that succeeds.
    fn calls(&self, new: &Files, more: &[&str]) -> Result<Vec<Call>, String> {
        let output = self.run(new, false, more)?;
        if !output.status.success() {
            return Err(format!("undisturbed: {output:?}"));
        }
        let text = fs::read(self.log()).map_err(|error| error.to_string())?;
        let text = String::from_utf8_lossy(&text);
        let calls = calls::calls(&text, &self.folder.to_string_lossy(), self.only_folder);
        if calls.len() < 10 { Err(format!("only {} calls in {text}", calls.len())) } else { Ok(calls) }
    }

    /// Where strace writes: beside the folder, in which only the program writes.
    fn log(&self) -> PathBuf {
        self.folder.with_file_name("strace.log")
    }

    /// Runs the program with the old files in their places.
    fn run(&self, new: &Files, as_process_one: bool, more: &[&str]) -> Result<Output, String> {
        self.prepare(new).map_err(|error| error.to_string())?;
        let unshare: &[&str] = if as_process_one { &["unshare", "-pf"] } else { &[] };
        if let Some((gate, content)) = &self.gate {
            return gate::run(self, (gate, content), unshare, more);
        }
        // As process 1 the program is the parent of strace, not its child.
        let strace: &[&str] = if as_process_one { &["strace", "-D"] } else { &["strace"] };
        let tracer = [unshare, strace].concat();
        let mut command = Command::new(tracer[0]);
        command.args(&tracer[1..]).args(["-f", "-y", "-qq", "-o"]).arg(self.log()).args(more);
        command.arg(&self.program).args(&self.arguments).output().map_err(|error| error.to_string())
    }
}

#[cfg(test)]
mod tests;
