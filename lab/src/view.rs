//! Answers the requests of the page in `web/site`: its files, the two input files, and pictures.
//!
//! | Request | Answer |
//! |---|---|
//! | `GET /FILE` | a file of the page |
//! | `GET /view/files` | JSON with the texts of both input files, and their version |
//! | `GET /view/version` | the version alone, which changes when a file changes |
//! | `POST /view/render/NUMBER` | the PPM file of the two texts in the body; `NUMBER` names the picture |
//! | `GET /view/progress` | the number of finished rows and of all rows |
//! | `POST /view/cancel/NUMBER` | nothing; stops the picture if it is being rendered |
//! | `POST /view/camera` | the new version; writes the camera in the body into the configuration file |
//!
//! [`loopback`] limits the requests. [`native`] renders one picture at a time. `camera` is the only part that writes.

mod camera;
pub mod native;
pub mod site;

use std::io;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::time::SystemTime;

use cpu::internals::input::reader;
use loopback::Answer;
use loopback::request::Request;
use output::Options;
use serde::Serialize;

use crate::terminal;
use native::Native;
pub use site::Site;

/// Largest size of an input file that the page can edit, in bytes. The body of a request has room for two such texts.
const MAX_TEXT: u64 = 16 << 20;

/// The page, its two input files and the renderer behind it.
#[derive(Debug)]
pub struct View {
    site: Site,
    config: PathBuf,
    scene: PathBuf,
    native: Native,
    /// How the configuration is written.
    how: Options,
    /// Held while a camera is saved.
    saving: Mutex<()>,
}

/// Both input files, as the page receives them.
#[derive(Serialize)]
struct Files {
    version: String,
    config: String,
    scene: String,
}

impl View {
    /// Returns the view of two input files. `how` tells how a camera is written into the configuration.
    #[must_use]
    pub fn new(site: Site, config: PathBuf, scene: PathBuf, how: Options) -> Self {
        Self { site, config, scene, native: Native::default(), how, saving: Mutex::default() }
    }

    /// Answers one request.
    #[must_use]
    pub fn answer(&self, request: &Request) -> Answer {
        let path = request.path.split('?').next().unwrap_or_default();
        let number = |start: &str| path.strip_prefix(start).and_then(|number| number.parse::<u32>().ok());
        match request.method.as_str() {
            "GET" => match path {
                "/view/files" => self.files(),
                "/view/version" => Answer::ok("text/plain", self.version().into_bytes()),
                "/view/progress" => Answer::ok("text/plain", self.native.progress().into_bytes()),
                _ => self.site.file(path),
            },
            "POST" if path == "/view/camera" => self.save_camera(&request.body),
            "POST" => {
                if let Some(number) = number("/view/render/") {
                    self.native.render(number, &request.body)
                } else if let Some(number) = number("/view/cancel/") {
                    self.native.cancel(number);
                    Answer::ok("text/plain", &b""[..])
                } else {
                    Answer::not_found()
                }
            }
            _ => Answer::refused("405 Method Not Allowed", "this server answers GET and POST"),
        }
    }

    fn files(&self) -> Answer {
        // The version is read first. If a file changes now, the page asks again.
        let version = self.version();
        let texts = text(&self.config).and_then(|config| Ok((config, text(&self.scene)?)));
        let json = texts.and_then(|(config, scene)| {
            serde_json::to_vec(&Files { version, config, scene }).map_err(|error| error.to_string())
        });
        match json {
            Ok(json) => Answer::ok("application/json", json),
            Err(message) => Answer::refused("404 Not Found", message),
        }
    }

    /// Returns a text that changes when one of the files changes: their times of modification and their sizes.
    fn version(&self) -> String {
        [&self.config, &self.scene].map(|path| version_of(path)).join(" ")
    }
}

/// Returns a text that changes when the file changes.
fn version_of(path: &Path) -> String {
    let version = || -> io::Result<String> {
        let file = path.metadata()?;
        let time = file.modified()?.duration_since(SystemTime::UNIX_EPOCH).unwrap_or_default();
        Ok(format!("{}-{}", time.as_nanos(), file.len()))
    };
    version().unwrap_or_else(|_| "missing".to_owned())
}

/// Returns the text of an input file, or a message with the file's name.
fn text(path: &Path) -> Result<String, String> {
    reader::read_text(path, MAX_TEXT).map_err(|error| format!("Cannot read file [{}]: {error}", terminal::name(path)))
}

#[cfg(test)]
mod tests;
