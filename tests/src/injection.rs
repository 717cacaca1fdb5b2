//! A program whose system calls fail one after the other, and which signals meet in each of them.
//!
//! `strace` runs the program once to list the calls on the way of its output. Then the program runs again for each of
//! them, which fails once or is met by a signal. After each run the output's old file stands or the new one does, the
//! status says which, and nothing else is in the folder.

use std::collections::HashMap;
use std::ffi::OsString;
use std::fs;
use std::os::unix::process::ExitStatusExt;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// Calls about files, by the names that Linux gives them. The others are about memory, signals and time.
const CALLS: [&str; 24] = [
    "access",
    "close",
    "dup",
    "faccessat",
    "faccessat2",
    "fchmod",
    "fchown",
    "fcntl",
    "fstat",
    "fsync",
    "ftruncate",
    "getcwd",
    "linkat",
    "lseek",
    "newfstatat",
    "open",
    "openat",
    "read",
    "readlink",
    "rename",
    "renameat",
    "statx",
    "unlinkat",
    "write",
];

/// What each call fails with.
const ERRORS: [&str; 4] = ["EIO", "ENOSPC", "EPERM", "EINTR"];

/// The signal that meets each call.
const SIGNAL: &str = "TERM";
const SIGNAL_NUMBER: i32 = 15;

/// A program that makes the file `out`, alone in its folder.
#[derive(Clone, Debug)]
pub struct Job {
    /// The program.
    pub program: PathBuf,
    /// Its arguments, of which one names `out`.
    pub arguments: Vec<OsString>,
    /// The file.
    pub out: PathBuf,
    /// What stands there before, if anything.
    pub old: Option<Vec<u8>>,
    /// What stands there afterwards.
    pub new: Vec<u8>,
    /// Whether the program may go on to a good end after a request to stop. Else it ends by the signal at once.
    pub graceful: bool,
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
    let unshare = ["unshare", "-pf", "strace", "-D", "-qq", "-o", "/dev/null", "true"];
    let runs =
        |command: &[&str]| Command::new(command[0]).args(&command[1..]).output().is_ok_and(|run| run.status.success());
    if !runs(&strace) {
        return Some("needs strace and the right to trace");
    }
    (disturbance == Disturbance::SignalAsProcessOne && !runs(&unshare)).then_some("needs the right to be process 1")
}

impl Job {
    /// Disturbs every call in turn. Gives the number of runs.
    ///
    /// # Errors
    /// The first run after which the file is neither the old nor the new one, with what the program said.
    pub fn disturb(&self, disturbance: Disturbance) -> Result<usize, String> {
        let calls = self.calls(&[])?;
        match disturbance {
            Disturbance::Errors => self.fail(&calls, &[]),
            Disturbance::Signal => self.signal(&calls, &[]),
            Disturbance::SignalAsProcessOne => {
                let mut runs = 0;
                for call in &calls {
                    let inject = format!("inject={}:signal={SIGNAL}:when={}", call.name, call.number);
                    let output = self.run(&["unshare", "-pf", "strace", "-D"], &["-e", &inject])?;
                    let ended = output.status.code() == Some(128 + SIGNAL_NUMBER);
                    self.check_stopped(&output, ended).map_err(|error| format!("{inject}: {error}"))?;
                    runs += 1;
                }
                Ok(runs)
            }
            Disturbance::Named => {
                let unnamed = calls.iter().find(|call| call.text.contains("O_TMPFILE"));
                let unnamed = unnamed.ok_or("no file without a name was made")?;
                let inject = format!("inject=openat:error=EOPNOTSUPP:when={}", unnamed.number);
                let first = ["-e", &inject[..]];
                // strace disturbs a call by one rule only.
                let mut calls = self.calls(&first)?;
                if !calls.iter().any(|call| call.text.contains("O_EXCL")) {
                    return Err("no file with a name was made".to_owned());
                }
                calls.retain(|call| call.name != "openat");
                Ok(self.fail(&calls, &first)? + self.signal(&calls, &first)?)
            }
        }
    }

    fn fail(&self, calls: &[Call], more: &[&str]) -> Result<usize, String> {
        let mut runs = 0;
        for (call, error) in calls.iter().flat_map(|call| ERRORS.map(|error| (call, error))) {
            let inject = format!("inject={}:error={error}:when={}", call.name, call.number);
            let output = self.run(&["strace"], &[more, &["-e", &inject]].concat())?;
            self.check(&output, false).map_err(|error| format!("{inject}: {error}"))?;
            // Permissions that cannot be set are no reason to lose the picture.
            if call.name == "fchmod" && !output.status.success() {
                return Err(format!("{inject}: {output:?}"));
            }
            runs += 1;
        }
        Ok(runs)
    }

    fn signal(&self, calls: &[Call], more: &[&str]) -> Result<usize, String> {
        let mut runs = 0;
        for call in calls {
            let inject = format!("inject={}:signal={SIGNAL}:when={}", call.name, call.number);
            let output = self.run(&["strace"], &[more, &["-e", &inject]].concat())?;
            // strace ends as the program did.
            let ended = output.status.signal() == Some(SIGNAL_NUMBER);
            self.check_stopped(&output, ended).map_err(|error| format!("{inject}: {error}"))?;
            runs += 1;
        }
        Ok(runs)
    }

    /// The calls about files from the first on that names the output.
    fn calls(&self, more: &[&str]) -> Result<Vec<Call>, String> {
        // Where the program itself writes nothing.
        let output = self.run_into("/dev/stdout", &["strace"], more)?;
        if !output.status.success() {
            return Err(format!("undisturbed: {output:?}"));
        }
        let text = String::from_utf8_lossy(&output.stdout);
        let out = self.out.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let calls = calls(&text, &format!("{out}\""));
        if calls.len() < 10 { Err(format!("only {} calls in {text}", calls.len())) } else { Ok(calls) }
    }

    fn run(&self, tracer: &[&str], more: &[&str]) -> Result<Output, String> {
        self.run_into("/dev/null", tracer, more)
    }

    /// Runs the program with the old file in its place.
    fn run_into(&self, log: &str, tracer: &[&str], more: &[&str]) -> Result<Output, String> {
        let prepared = match &self.old {
            Some(old) => fs::write(&self.out, old),
            None => fs::remove_file(&self.out).or(Ok(())),
        };
        prepared.map_err(|error| error.to_string())?;
        let mut command = Command::new(tracer[0]);
        command.args(&tracer[1..]).args(["-f", "-qq", "-o", log]).args(more);
        command.arg(&self.program).args(&self.arguments).output().map_err(|error| error.to_string())
    }

    /// Checks a run that a signal met.
    fn check_stopped(&self, output: &Output, ended_by_signal: bool) -> Result<(), String> {
        if ended_by_signal || self.graceful {
            self.check(output, ended_by_signal)
        } else {
            Err(format!("the signal did not end it: {output:?}"))
        }
    }

    /// Checks what stands after a run, which a signal may have ended.
    fn check(&self, output: &Output, ended_by_signal: bool) -> Result<(), String> {
        let mut names = Vec::new();
        for entry in fs::read_dir(self.out.parent().unwrap_or(Path::new("."))).map_err(|error| error.to_string())? {
            names.push(entry.map_err(|error| error.to_string())?.path());
        }
        let stands = fs::read(&self.out).ok();
        let (is_old, is_new) = (stands == self.old, stands.as_ref() == Some(&self.new));
        let told = if output.status.success() {
            is_new
        } else if ended_by_signal {
            is_old || is_new
        } else {
            // What is uncertain about a new file is its way onto the disk, and the message says so.
            let stderr = String::from_utf8_lossy(&output.stderr);
            stderr.contains("rror: ") && (is_old || is_new && stderr.contains("the new file is there"))
        };
        let alone = names.iter().all(|name| *name == self.out);
        if told && alone { Ok(()) } else { Err(format!("old {is_old}, new {is_new}, {names:?}, {output:?}")) }
    }
}

/// A call: its name, the how-many-th of this name it is in its thread, and how strace writes it.
#[derive(Debug)]
struct Call {
    name: String,
    number: usize,
    text: String,
}

/// The calls about files in what strace wrote, from the first on that contains `start`.
fn calls(text: &str, start: &str) -> Vec<Call> {
    let mut counts: HashMap<(&str, &str), usize> = HashMap::new();
    let mut found: Vec<Call> = Vec::new();
    for line in text.lines() {
        let Some((process, text)) = line.split_once(' ') else { continue };
        let Some((name, _)) = text.trim_start().split_once('(') else { continue };
        let Some(name) = CALLS.iter().find(|known| **known == name) else { continue };
        let number = counts.entry((process, name)).or_default();
        *number += 1;
        if !found.is_empty() || text.contains(start) {
            let is_known = found.iter().any(|call| call.name == *name && call.number == *number);
            if !is_known {
                found.push(Call { name: (*name).to_owned(), number: *number, text: text.to_owned() });
            }
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn calls_are_counted_by_thread_from_the_first_that_names_the_output() {
        let text = "7 openat(1, \"c\") = 3\n8 openat(1, \"x\") = 3\n7 brk(0) = 1\n7 openat(1, \"d/out\") = 3\n8 close(3) = 0\n";
        let calls: Vec<_> = calls(text, "out\"").into_iter().map(|call| (call.name, call.number)).collect();
        assert_eq!(calls, [("openat".to_owned(), 2), ("close".to_owned(), 1)]);
    }

    fn job(script: &str) -> (tempfile::TempDir, Job) {
        let folder = tempfile::tempdir().expect("the temporary folder is writable");
        let out = folder.path().join("out");
        let arguments = ["-c", script, "job", out.to_str().expect("the name is ours")].map(OsString::from).to_vec();
        (
            folder,
            Job {
                program: "bash".into(),
                arguments,
                out,
                old: Some(b"old".to_vec()),
                new: b"new\n".to_vec(),
                graceful: false,
            },
        )
    }

    #[test]
    fn a_program_that_writes_in_place_is_found_out() {
        if unavailable(Disturbance::Errors).is_some() {
            return;
        }
        let (_folder, in_place) = job("echo new > $1");
        assert!(in_place.disturb(Disturbance::Errors).is_err());
    }
}
