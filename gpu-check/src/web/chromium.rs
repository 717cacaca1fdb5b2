//! Finds and starts a headless Chromium, whose WebGPU compiles with Tint and calculates with SwiftShader.

use std::io;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};

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

/// Returns the browser's name and version, as the browser prints them.
///
/// # Errors
/// The error of the system if the browser cannot be started.
pub fn version(chromium: &Path) -> io::Result<String> {
    let output = Command::new(chromium).arg("--version").stderr(Stdio::null()).output()?;
    Ok(String::from_utf8_lossy(&output.stdout).trim().to_owned())
}

/// A running browser. It is killed when this value is dropped.
#[derive(Debug)]
pub struct Browser(pub Child);

impl Drop for Browser {
    fn drop(&mut self) {
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
        // The browser's messages must not appear between those of the program.
        let child = command.arg(url).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null()).spawn()?;
        Ok(Self(child))
    }
}
