//! Answers the requests of the page in `web/site`: its files, and the two input files. The page itself renders.
//!
//! | Request | Answer |
//! |---|---|
//! | `GET /FILE` | a file of the page |
//! | `GET /view/files` | a line of JSON (`Files`), then the texts of both input files |
//! | `GET /view/version` | the versions of both files, which change when the files change |
//! | `POST /view/config`, `POST /view/scene` | the new version of the file, after the text in the body was saved |
//!
//! [`loopback`] limits the requests and asks for the secret. [`input`] reads the files. `save` is the only part that
//! writes.

pub mod input;
mod replace;
mod save;
pub mod site;

use std::sync::Mutex;

use loopback::Answer;
use loopback::request::Request;
use output::Options;
use serde::Serialize;

pub use input::Input;
pub use site::Site;

/// The start of the paths of all requests but those for the files of the page. A cookie does not open them.
pub const PRIVATE: &str = "/view/";

/// The page and its two input files.
#[derive(Debug)]
pub struct View {
    site: Site,
    /// The configuration and the scene.
    inputs: [Input; 2],
    /// How a file is written.
    how: Options,
    /// Held while a text is saved.
    saving: Mutex<()>,
}

/// What the page gets before the two texts.
#[derive(Serialize)]
struct Files {
    /// The version of each file.
    version: [String; 2],
    /// The path of each file, from which the page takes the name of a picture.
    path: [String; 2],
    /// The length of the configuration in bytes.
    length: usize,
}

impl View {
    /// Returns the view of two input files. `how` tells how a text is saved into its file.
    pub fn new(site: Site, inputs: [Input; 2], how: Options) -> Self {
        Self { site, inputs, how, saving: Mutex::default() }
    }

    /// Answers one request.
    pub fn answer(&self, request: &Request) -> Answer {
        let path = request.path.split('?').next().unwrap_or_default();
        let [config, scene] = &self.inputs;
        match (request.method.as_str(), path) {
            ("GET", "/view/files") => self.files(),
            ("GET", "/view/version") => Answer::ok("text/plain", self.inputs.each_ref().map(Input::version).join(" ")),
            ("GET", _) => self.site.file(path),
            ("POST", "/view/config") => self.save(config, &request.body),
            ("POST", "/view/scene") => self.save(scene, &request.body),
            ("POST", _) => Answer::not_found(),
            _ => Answer::refused("405 Method Not Allowed", "this server answers GET and POST"),
        }
    }

    /// Answers with both files. A file that does not exist has no bytes, and a version that says so.
    fn files(&self) -> Answer {
        let texts = || -> Result<Answer, Answer> {
            let text = |input: &Input| match input.text() {
                Ok(text) => Ok((input::version_of(text.as_bytes()), text)),
                Err(error) if error.kind() == std::io::ErrorKind::NotFound => {
                    Ok((input::MISSING.to_owned(), String::new()))
                }
                Err(error) => Err(Answer::refused("404 Not Found", input.message(&error))),
            };
            let [(one, config), (other, scene)] = [text(&self.inputs[0])?, text(&self.inputs[1])?];
            let path = self.inputs.each_ref().map(|input| input.path().to_string_lossy().into_owned());
            let head = Files { version: [one, other], path, length: config.len() };
            // Serialising texts into memory never fails.
            let head = serde_json::to_string(&head).unwrap_or_default();
            Ok(Answer::ok("application/octet-stream", [&head, "\n", &config, &scene].concat()))
        };
        texts().unwrap_or_else(|refusal| refusal)
    }
}

/// Returns the answer to a request that is wrong.
fn invalid(message: impl Into<String>) -> Answer {
    Answer::refused("422 Unprocessable Content", message)
}

#[cfg(test)]
mod tests;
