//! Finds and starts a headless browser.

use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};

/// Returns the path of the browser: the file that the variable `CHROMIUM` names, or the first file with a usual name in
/// the folders of `PATH`. Returns `None` if there is no browser.
pub fn chromium() -> Option<PathBuf> {
    if let Some(path) = std::env::var_os("CHROMIUM") {
        return Some(path.into());
    }
    let folders: Vec<_> = std::env::split_paths(&std::env::var_os("PATH")?).collect();
    let names = ["chromium", "chromium-browser", "google-chrome"];
    names.iter().flat_map(|name| folders.iter().map(move |folder| folder.join(name))).find(|path| path.is_file())
}

/// A running browser. It is killed when this value is dropped.
pub struct Browser(Child);

impl Browser {
    /// Waits until the browser ends by itself.
    #[allow(dead_code, reason = "only one of the tests that share this file uses it")]
    pub fn wait(&mut self) -> std::io::Result<()> {
        self.0.wait().map(drop)
    }
}

impl Drop for Browser {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// Starts the browser at `url` with an own folder for its profile, and with the options `more`.
pub fn open(chromium: &Path, profile: &Path, more: &[String], url: &str) -> std::io::Result<Browser> {
    let mut command = Command::new(chromium);
    command.args(more);
    command.args(["--headless", "--enable-unsafe-webgpu", "--no-sandbox", "--disable-quic", "--no-first-run"]);
    command.args(["--disable-background-networking", "--disable-component-update", "--disable-sync"]);
    command.arg(format!("--user-data-dir={}", profile.display()));
    // The browser's messages must not appear between those of the test.
    let child = command.arg(url).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null()).spawn()?;
    Ok(Browser(child))
}
