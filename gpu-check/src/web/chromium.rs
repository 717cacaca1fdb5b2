//! Finds and starts a headless Chromium, whose WebGPU compiles with Tint and calculates with SwiftShader.

use std::io::{self, Read};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::mpsc;
use std::time::{Duration, Instant};

use output::stop;

/// Largest number of bytes of the browser's version that are read.
const MAX_VERSION: u64 = 1 << 10;

/// Time between two looks at whether the user has interrupted the program, or the browser has ended.
pub const INTERVAL: Duration = Duration::from_millis(100);

/// Returns the path of the browser: the file that the variable `CHROMIUM` names, or the first file with a usual name in
/// the folders of `PATH`. Returns `None` if there is no browser.
#[must_use]
pub fn find() -> Option<PathBuf> {
    if let Some(path) = std::env::var_os("CHROMIUM") {
        return Some(path.into());
    }
    let folders: Vec<_> = std::env::split_paths(&std::env::var_os("PATH")?).collect();
    let names = ["chromium", "chromium-browser", "google-chrome"];
    names.iter().flat_map(|name| folders.iter().map(move |folder| folder.join(name))).find(|path| path.is_file())
}

/// Returns the browser's name and version, as the browser prints them. After the time `patience` the browser is ended.
///
/// # Errors
/// The error of the system if the browser cannot be started; [`io::ErrorKind::TimedOut`] if it does not end; another
/// error if it prints nothing, or if the user interrupts the program.
pub fn version(chromium: &Path, patience: Duration) -> io::Result<String> {
    let mut browser = Browser::start(Command::new(chromium).arg("--version").stdout(Stdio::piped()))?;
    let stdout = browser.0.stdout.take();
    let (sender, receiver) = mpsc::channel();
    // The thread ends when all processes of the browser have ended or have closed their standard output.
    std::thread::spawn(move || {
        let mut text = Vec::new();
        let _ = stdout.map(|stdout| stdout.take(MAX_VERSION).read_to_end(&mut text));
        sender.send(text)
    });
    let start = Instant::now();
    let text = loop {
        match receiver.recv_timeout(INTERVAL) {
            Ok(text) => break String::from_utf8_lossy(&text).trim().to_owned(),
            Err(_) if stop::requested() => return Err(io::Error::other("interrupted")),
            Err(_) if start.elapsed() < patience => {}
            Err(_) => {
                let text = format!("it did not print its version within {patience:?}, so it was ended");
                return Err(io::Error::new(io::ErrorKind::TimedOut, text));
            }
        }
    };
    if text.is_empty() { Err(io::Error::other("it ended without printing its version")) } else { Ok(text) }
}

/// A running browser. When this value is dropped, the browser and all processes that it has started are killed.
#[derive(Debug)]
pub struct Browser(Child);

impl Drop for Browser {
    fn drop(&mut self) {
        // Errors are ignored, because the processes may have ended already.
        #[cfg(unix)]
        if let Ok(group) = i32::try_from(self.0.id()) {
            let _ = nix::sys::signal::killpg(nix::unistd::Pid::from_raw(group), nix::sys::signal::Signal::SIGKILL);
        }
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

impl Browser {
    /// Starts the browser with the page `url`. The browser keeps its files in the folder `profile`.
    ///
    /// # Errors
    /// The error of the system if the browser cannot be started.
    pub fn open(chromium: &Path, profile: &Path, url: &str) -> io::Result<Self> {
        let mut command = Command::new(chromium);
        command.args(["--headless", "--enable-unsafe-webgpu", "--no-sandbox", "--disable-quic", "--no-first-run"]);
        command.args(["--disable-background-networking", "--disable-component-update", "--disable-sync"]);
        command.arg(format!("--user-data-dir={}", profile.display()));
        Self::start(command.arg(url).stdout(Stdio::null()))
    }

    /// Starts the command of a browser, in a process group of its own.
    ///
    /// # Errors
    /// The error of the system if the command cannot be started.
    pub fn start(command: &mut Command) -> io::Result<Self> {
        #[cfg(unix)]
        std::os::unix::process::CommandExt::process_group(command, 0);
        // The browser's messages must not appear between those of the program.
        Ok(Self(command.stdin(Stdio::null()).stderr(Stdio::null()).spawn()?))
    }

    /// Returns the status with which the browser has ended, or `None` if it is running.
    ///
    /// # Errors
    /// The error of the system.
    pub fn ended(&mut self) -> io::Result<Option<ExitStatus>> {
        self.0.try_wait()
    }
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;

    #[test]
    fn a_browser_that_hangs_or_dies_before_it_prints_its_version_is_an_error() {
        let folder = tempfile::tempdir().expect("the temporary folder is writable");
        let script = |name: &str, text: &str| {
            let path = folder.path().join(name);
            std::fs::write(&path, format!("#!/bin/sh\n{text}\n")).expect("the folder is writable");
            let mode = std::os::unix::fs::PermissionsExt::from_mode(0o755);
            std::fs::set_permissions(&path, mode).expect("it is ours");
            path
        };
        let short = Duration::from_millis(300);
        let long = Duration::from_secs(60);
        // A process that the shell starts keeps the pipe open.
        let hangs = version(&script("hangs", "sleep 1000; echo late"), short).expect_err("it prints nothing");
        assert_eq!(hangs.to_string(), "it did not print its version within 300ms, so it was ended");
        let dies = version(&script("dies", "exit 3"), long).expect_err("it prints nothing");
        assert_eq!(dies.to_string(), "it ended without printing its version");
        assert_eq!(version(&script("good", "echo Browser 1"), long).expect("it prints its version"), "Browser 1");
    }
}
