//! Lets one system call of a program fail, or sends a signal during the call, and checks the program's output files.
//!
//! `strace` runs the program once to list its calls about files. Then the program runs again for each call, which fails
//! or gets a signal. After each run, every output file must be the old one or the new one, the exit status must say
//! which, and no other file may be in the folder.
//!
//! `strace` counts calls by thread, and disturbs the n-th call of a name in every thread. So a program that does its
//! work in a second thread gets a [gate](Job::gate), at which it waits until `strace` watches that thread alone.

mod calls;
mod check;
mod gate;
mod runs;
mod syncs;

use std::collections::BTreeMap;
use std::ffi::OsString;
use std::fs;
use std::os::unix::process::ExitStatusExt;
use std::path::PathBuf;
use std::process::{Command, Output};

use calls::Call;
#[cfg(feature = "programs")]
pub use runs::run;
pub use runs::{Runs, most, total};
pub use syncs::check_syncs;

/// The errors with which each call fails, one after the other.
const ERRORS: [&str; 4] = ["EIO", "ENOSPC", "EPERM", "EINTR"];

/// The signal that is sent during each call.
const SIGNAL: &str = "TERM";
const SIGNAL_NUMBER: i32 = 15;

/// A program that makes the files in `folder`.
#[derive(Clone, Debug)]
pub struct Job {
    /// The program.
    pub program: PathBuf,
    /// The program's arguments. One of them names `folder` or a file in it.
    pub arguments: Vec<OsString>,
    /// The output folder. Only the program writes into it, and no other path contains its name.
    pub folder: PathBuf,
    /// The old content of every output file; `None` if the files do not exist before.
    pub old: Option<Vec<u8>>,
    /// Whether the program may finish its work after a signal. Otherwise the signal must end it at once.
    pub graceful: bool,
    /// An input of the program and its content. Calls before the program reads this input are not disturbed. Without a
    /// gate, calls whose name and number more than one thread makes are not disturbed.
    pub gate: Option<(PathBuf, Vec<u8>)>,
    /// If true, only calls that name `folder` or use a file in it are disturbed. Otherwise every call about files is
    /// disturbed, beginning with the first that names `folder`.
    pub only_folder: bool,
    /// Largest number of calls of each name that are disturbed: the first, the last, and others evenly between them.
    /// See [`most`].
    pub most: usize,
}

/// How a call is disturbed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Disturbance {
    /// Each call fails with each error.
    Errors,
    /// A signal is sent during each call.
    Signal,
    /// Like [`Disturbance::Signal`], but the program is process 1, which a signal does not end by default.
    SignalAsProcessOne,
    /// Both [`Disturbance::Errors`] and [`Disturbance::Signal`], as on a file system without `O_TMPFILE`, where the
    /// temporary file has a name.
    Named,
    /// [`Disturbance::SignalAsProcessOne`], on the same kind of file system.
    NamedAsProcessOne,
}

impl Disturbance {
    fn is_as_process_one(self) -> bool {
        matches!(self, Self::SignalAsProcessOne | Self::NamedAsProcessOne)
    }
}

/// Returns why this machine cannot run a disturbance, or `None` if it can.
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
    (disturbance.is_as_process_one() && !runs(&unshare)).then_some("needs the right to be process 1")
}

/// Paths and contents of files.
type Files = BTreeMap<PathBuf, Vec<u8>>;

impl Job {
    /// Disturbs one call after the other. Returns how many runs were made, which is not 0.
    ///
    /// # Errors
    /// The first run that fails a check, with the output of the program.
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
            Disturbance::Named | Disturbance::NamedAsProcessOne => {
                let unnamed = calls.iter().find(|call| call.text.contains("O_TMPFILE"));
                let unnamed = unnamed.ok_or("no file without a name was made")?;
                let inject = format!("inject=openat:error=EOPNOTSUPP:when={}", unnamed.number);
                let first = ["-e", &inject[..]];
                // strace applies only one rule to a call, and `first` is a rule for `openat`. So `openat` is left out.
                let mut calls = self.calls(&new, &first)?;
                if !calls.iter().any(|call| call.text.contains("O_EXCL")) {
                    return Err("no file with a name was made".to_owned());
                }
                calls.retain(|call| call.name != "openat");
                if disturbance.is_as_process_one() {
                    self.each(calls, |calls| self.signal(&new, calls, &first, true))?
                } else {
                    self.each(calls, |calls| {
                        Ok(self.fail(&new, calls, &first)? + self.signal(&new, calls, &first, false)?)
                    })?
                }
            }
        };
        runs::add(runs);
        if runs.made == 0 { Err("nothing was disturbed".to_owned()) } else { Ok(runs) }
    }

    /// Chooses calls and runs `disturb` on them. `disturb` must make an equal number of runs for each call.
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
            // If the permissions cannot be set, the picture must be written nevertheless.
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
            // strace ends like the program: by the signal, or with the program's status.
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

    /// Runs the program undisturbed and returns the calls that can be disturbed.
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

    /// Returns the path of strace's log. It is beside the folder, because only the program may write into the folder.
    fn log(&self) -> PathBuf {
        self.folder.with_file_name("strace.log")
    }

    /// Restores the old files and runs the program.
    fn run(&self, new: &Files, as_process_one: bool, more: &[&str]) -> Result<Output, String> {
        self.prepare(new).map_err(|error| error.to_string())?;
        let unshare: &[&str] = if as_process_one { &["unshare", "-pf"] } else { &[] };
        if let Some((gate, content)) = &self.gate {
            return gate::run(self, (gate, content), unshare, more);
        }
        // With -D the program is process 1, and strace is its grandchild. Without it strace would be process 1.
        let strace: &[&str] = if as_process_one { &["strace", "-D"] } else { &["strace"] };
        let tracer = [unshare, strace].concat();
        let mut command = Command::new(tracer[0]);
        command.args(&tracer[1..]).args(["-f", "-y", "-qq", "-o"]).arg(self.log()).args(more);
        command.arg(&self.program).args(&self.arguments).output().map_err(|error| error.to_string())
    }
}

#[cfg(test)]
mod tests;
