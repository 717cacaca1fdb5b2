//! A folder with the input files of a run, and functions for processes that get signals.

use std::fs;
use std::ops::Deref;
use std::os::unix::process::ExitStatusExt;
use std::process::{Child, Command, ExitStatus, Output, Stdio};

use nix::sys::signal::{Signal, kill};
use nix::unistd::Pid;
use test_support::folder::Folder;
use test_support::running::Running;

/// Paths of the two programs.
pub const PROGRAMS: [&str; 2] = [env!("CARGO_BIN_EXE_render-aos"), env!("CARGO_BIN_EXE_render-soa")];

/// The arguments of a run.
pub const NAMES: [&str; 3] = ["config.txt", "scene.txt", "d/out.ppm"];

/// A temporary folder with `config.txt`, `scene.txt`, and an empty folder `d` for the picture.
pub struct Workshop(Folder);

impl Deref for Workshop {
    type Target = Folder;

    fn deref(&self) -> &Folder {
        &self.0
    }
}

impl Workshop {
    pub fn new(config: impl AsRef<[u8]>, scene: impl AsRef<[u8]>) -> Self {
        let folder = Folder::with_scene(config, scene);
        fs::create_dir(folder.file("d")).expect("the folder is writable");
        Self(folder)
    }

    /// Returns the names of the files in the picture's folder `d`.
    pub fn outputs(&self) -> Vec<String> {
        self.names_in("d")
    }

    /// Returns the command `program config.txt scene.txt d/out.ppm`, with this folder as its working folder.
    pub fn command(&self, program: &str) -> Command {
        self.command_with(program, NAMES)
    }

    pub fn command_with(&self, program: &str, names: [&str; 3]) -> Command {
        let mut command = Command::new(program);
        command.current_dir(self.path()).args(names).stdout(Stdio::piped()).stderr(Stdio::piped());
        command
    }

    /// Returns the command of [`Self::command_with`] in a shell, after the shell command `limit`.
    pub fn after(&self, limit: &str, program: &str, names: [&str; 3]) -> Command {
        let mut shell = test_support::running::bash();
        shell.args(["-c", &format!("{limit}; exec \"$@\""), "limited", program]).args(names);
        shell.current_dir(self.path());
        shell
    }

    /// Returns the command of [`Self::command_with`], limited to `kilobytes` of address space.
    pub fn limited(&self, kilobytes: u64, program: &str, names: [&str; 3]) -> Command {
        self.after(&format!("ulimit -v {kilobytes}"), program, names)
    }

    /// Renders the picture with the first program, removes its file and returns its bytes.
    pub fn render(&self) -> Vec<u8> {
        let output = self.command(PROGRAMS[0]).output().expect("the program runs");
        assert!(output.status.success(), "{output:?}");
        let picture = fs::read(self.file("d/out.ppm")).expect("it was written");
        fs::remove_file(self.file("d/out.ppm")).expect("it is ours");
        picture
    }
}

/// Starts a program, which is killed when the value is dropped.
pub fn running(command: &mut Command) -> Running {
    Running::start(command).expect("the program runs")
}

/// Sends `signal` to a process, which may have ended already.
pub fn send(child: &Child, signal: Signal) {
    let id = i32::try_from(child.id()).expect("it is a process");
    kill(Pid::from_raw(id), signal).expect("it is ours, and not yet waited for");
}

/// Returns the signal that ended a process, or `None` if the process exited.
pub fn signal_of(status: ExitStatus) -> Option<Signal> {
    status.signal().map(|number| Signal::try_from(number).expect("it is a signal"))
}

/// Checks that a program ended with status 1, wrote nothing to standard output, and wrote this message to standard
/// error.
#[track_caller]
pub fn assert_refused(output: &Output, message: &str) {
    let stderr = String::from_utf8_lossy(&output.stderr);
    assert!(stderr.starts_with(&format!("Error: {message}")), "{output:?} instead of {message}");
    assert!(output.status.code() == Some(1) && output.stdout.is_empty() && stderr.ends_with('\n'), "{output:?}");
}
