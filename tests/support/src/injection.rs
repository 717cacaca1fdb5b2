//! Makes one system call of a program fail, or sends a signal during the call, and then checks the program's output
//! files.
//!
//! `strace` first runs the program to list its calls about files. Then the program runs once for each of these calls,
//! which fails or gets a signal. After each run, every output file must be the old one or the new one, the exit status
//! must tell which, and the folder must have no other file.
//!
//! `strace` counts calls by thread, and disturbs the n-th call of a name in every thread. So a program that works in a
//! second thread gets a [gate](Job::gate): it waits there until `strace` watches only that thread.

mod calls;
mod check;
mod gate;
mod syncs;

use std::collections::BTreeMap;
use std::ffi::OsString;
use std::fs;
use std::os::unix::process::ExitStatusExt;
use std::path::PathBuf;
use std::process::{Command, Output};
use std::sync::LazyLock;

use calls::Call;
pub use syncs::check_syncs;

/// The errors that each call returns, one error in each run.
const ERRORS: [&str; 4] = ["EIO", "ENOSPC", "EPERM", "EINTR"];

/// The signal that is sent during each call.
const SIGNAL: &str = "TERM";
const SIGNAL_NUMBER: i32 = 15;

/// A program that writes files into `folder`, and what to know about it for the disturbances.
#[derive(Clone, Debug)]
pub struct Job {
    /// Path of the program.
    pub program: PathBuf,
    /// The program's arguments. One of them names `folder` or a file in it.
    pub arguments: Vec<OsString>,
    /// The output folder. Only this program writes into it. The name of the folder must not occur in other paths.
    pub folder: PathBuf,
    /// The old content of every output file; `None` if these files do not exist before the run.
    pub old: Option<Vec<u8>>,
    /// Whether the program may finish its work after a signal. If false, the signal must end it at once.
    pub graceful: bool,
    /// The path of an input file of the program, and its content. Calls before the program reads this input are not
    /// disturbed. If there is no gate, a call is left out if another thread makes a call with the same name and number.
    pub gate: Option<(PathBuf, Vec<u8>)>,
    /// Whether only calls that name `folder` or use a file in it are disturbed. If false, all calls about files are
    /// disturbed, beginning with the first that names `folder`.
    pub only_folder: bool,
    /// Largest number of calls with one name that are disturbed: the first, the last, and others evenly between them.
    /// See [`most`].
    pub most: usize,
}

/// Returns the number of calls with one name to disturb: `some`, or all calls if [everything](crate::everything) is
/// compared.
#[must_use]
pub fn most(some: usize) -> usize {
    if crate::everything() { usize::MAX } else { some }
}

/// A way to disturb calls.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Disturbance {
    /// Each call fails, once with each error.
    Errors,
    /// A signal is sent during each call.
    Signal,
    /// A signal is sent during each call, and the program is process 1, which a signal does not end by default.
    SignalAsProcessOne,
    /// Both [`Disturbance::Errors`] and [`Disturbance::Signal`], on a simulated file system without `O_TMPFILE`, where
    /// the temporary file has a name.
    Named,
    /// [`Disturbance::SignalAsProcessOne`], on the same kind of file system.
    NamedAsProcessOne,
}

impl Disturbance {
    fn is_as_process_one(self) -> bool {
        matches!(self, Self::SignalAsProcessOne | Self::NamedAsProcessOne)
    }
}

/// Returns the reason why this machine cannot run `disturbance`, or `None` if it can.
#[must_use]
pub fn unavailable(disturbance: Disturbance) -> Option<&'static str> {
    static MAY_TRACE: LazyLock<bool> = LazyLock::new(|| {
        runs(&["strace", "-qq", "-o", "/dev/null", "-e", "inject=close:error=EIO:when=1000", "true"])
            && runs(&["bash", "-c", "sleep 1 & strace -qq -o /dev/null -p $!"])
    });
    static MAY_BE_PROCESS_ONE: LazyLock<bool> =
        LazyLock::new(|| runs(&["unshare", "-pf", "strace", "-D", "-qq", "-o", "/dev/null", "true"]));
    if !*MAY_TRACE {
        return Some("needs strace and the right to trace");
    }
    (disturbance.is_as_process_one() && !*MAY_BE_PROCESS_ONE).then_some("needs the right to be process 1")
}

/// Whether a command runs, and ends with success.
fn runs(command: &[&str]) -> bool {
    Command::new(command[0]).args(&command[1..]).output().is_ok_and(|run| run.status.success())
}

/// Files by their paths, with their contents.
type Files = BTreeMap<PathBuf, Vec<u8>>;

impl Job {
    /// Disturbs one call after the other, each in its own run. Returns the number of runs, which is not 0.
    ///
    /// # Errors
    /// A message about the first run that fails a check, with the output of the program.
    pub fn disturb(&self, disturbance: Disturbance) -> Result<usize, String> {
        self.prepare(&Files::new()).map_err(|error| error.to_string())?;
        let output = self.run(&Files::new(), false, &[])?;
        let new = check::files(&self.folder).map_err(|error| error.to_string())?;
        if !output.status.success() || new.is_empty() {
            return Err(format!("undisturbed: {new:?}, {output:?}"));
        }
        let (mut calls, mut more) = (self.calls(&new, &[])?, Vec::new());
        let inject;
        if matches!(disturbance, Disturbance::Named | Disturbance::NamedAsProcessOne) {
            let unnamed = calls.iter().find(|call| call.text.contains("O_TMPFILE"));
            let unnamed = unnamed.ok_or("no file without a name was made")?;
            inject = format!("inject=openat:error=EOPNOTSUPP:when={}", unnamed.number);
            more = vec!["-e", &inject[..]];
            // strace applies only one rule to a call, and `more` is already a rule for `openat`. So `openat` is left
            // out.
            calls = self.calls(&new, &more)?;
            if !calls.iter().any(|call| call.text.contains("O_EXCL")) {
                return Err("no file with a name was made".to_owned());
            }
            calls.retain(|call| call.name != "openat");
        }
        let calls = calls::spread(calls, self.most);
        let mut runs = 0;
        if matches!(disturbance, Disturbance::Errors | Disturbance::Named) {
            runs += self.fail(&new, &calls, &more)?;
        }
        if disturbance != Disturbance::Errors {
            runs += self.signal(&new, &calls, &more, disturbance.is_as_process_one())?;
        }
        if runs == 0 { Err("nothing was disturbed".to_owned()) } else { Ok(runs) }
    }

    fn fail(&self, new: &Files, calls: &[Call], more: &[&str]) -> Result<usize, String> {
        let mut runs = 0;
        for (call, error) in calls.iter().flat_map(|call| ERRORS.map(|error| (call, error))) {
            let inject = format!("inject={}:error={error}:when={}", call.name, call.number);
            let output = self.run(new, false, &[more, &["-e", &inject]].concat())?;
            self.check(new, &output, false).map_err(|error| format!("{inject}: {error}"))?;
            // If the permissions cannot be set, the picture must still be written.
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
            // strace ends in the way of the program: by the signal, or with the program's status.
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

    /// Runs the program without a disturbance, and returns the calls that can be disturbed.
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

    /// Returns the path of strace's log. The log is beside the folder, because only the program may write into the
    /// folder.
    fn log(&self) -> PathBuf {
        self.folder.with_file_name("strace.log")
    }

    /// Restores the old files, runs the program with strace, and returns the output.
    fn run(&self, new: &Files, as_process_one: bool, more: &[&str]) -> Result<Output, String> {
        self.prepare(new).map_err(|error| error.to_string())?;
        let unshare: &[&str] = if as_process_one { &["unshare", "-pf"] } else { &[] };
        if let Some((gate, content)) = &self.gate {
            return gate::run(self, (gate, content), unshare, more);
        }
        // With -D the program is process 1, and strace is its grandchild. Without -D strace would be process 1.
        let strace: &[&str] = if as_process_one { &["strace", "-D"] } else { &["strace"] };
        let tracer = [unshare, strace].concat();
        let mut command = Command::new(tracer[0]);
        command.args(&tracer[1..]).args(["-f", "-y", "-qq", "-o"]).arg(self.log()).args(more);
        command.arg(&self.program).args(&self.arguments).output().map_err(|error| error.to_string())
    }
}

#[cfg(test)]
mod tests;
