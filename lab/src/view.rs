//! Answers the requests of the page in `web/site`: its files, the two input files, and pictures.
//!
//! | Request | Answer |
//! |---|---|
//! | `GET /FILE` | a file of the page |
//! | `GET /view/files` | the texts of both input files, and their version |
//! | `GET /view/version` | the version alone, which changes when a file changes |
//! | `POST /view/render/NUMBER` | the PPM file of the two texts in the body; `NUMBER` names the picture |
//! | `GET /view/progress` | the number of finished rows and of all rows |
//! | `POST /view/cancel/NUMBER` | nothing; stops the picture if it is being rendered |
//! | `POST /view/camera` | the new version; writes the camera in the body into the configuration file |
//!
//! [`loopback`] limits the requests and asks for the secret. [`input`] reads the files, and [`native`] renders one
//! picture at a time. `camera` is the only part that writes.

mod camera;
pub mod input;
pub mod native;
mod replace;
pub mod site;

use std::sync::Mutex;

use loopback::Answer;
use loopback::budget::{Budget, Full};
use loopback::client::Client;
use loopback::request::Request;
use output::Options;

pub use input::Input;
use native::Native;
pub use site::Site;

/// The start of the paths of all requests but those for the files of the page. A cookie does not open them.
pub const PRIVATE: &str = "/view/";

/// The page, its two input files and the renderer behind it.
#[derive(Debug)]
pub struct View {
    site: Site,
    config: Input,
    scene: Input,
    native: Native,
    /// The bytes of the answers with the files.
    budget: Budget,
    /// How the configuration is written.
    how: Options,
    /// Held while a camera is saved.
    saving: Mutex<()>,
}

impl View {
    /// Returns the view of two input files. Bytes of pictures and answers are counted in `budget`. `how` tells how a
    /// camera is written into the configuration.
    pub fn new(site: Site, [config, scene]: [Input; 2], budget: Budget, how: Options) -> Self {
        Self { site, config, scene, native: Native::new(budget.clone()), budget, how, saving: Mutex::default() }
    }

    /// Answers one request of `client`.
    pub fn answer(&self, request: &Request, client: &Client) -> Answer {
        let path = request.path.split('?').next().unwrap_or_default();
        let number = |start: &str| path.strip_prefix(start).and_then(|number| number.parse::<u32>().ok());
        match request.method.as_str() {
            "GET" => match path {
                "/view/files" => self.files(),
                "/view/version" => Answer::ok("text/plain", self.version()),
                "/view/progress" => Answer::ok("text/plain", self.native.progress()),
                _ => self.site.file(path),
            },
            "POST" if path == "/view/camera" => self.save_camera(&request.body),
            "POST" => {
                if let Some(number) = number("/view/render/") {
                    self.native.render(number, &request.body, client)
                } else if let Some(number) = number("/view/cancel/") {
                    self.native.cancel(number);
                    Answer::ok("text/plain", "")
                } else {
                    Answer::not_found()
                }
            }
            _ => Answer::refused("405 Method Not Allowed", "this server answers GET and POST"),
        }
    }

    /// Answers with both files: a line with their version and the length of the configuration in bytes, then the
    /// configuration, then the scene.
    fn files(&self) -> Answer {
        let texts = || -> Result<Answer, Answer> {
            let inputs = [&self.config, &self.scene];
            let refused = |input: &Input, error| Answer::refused("404 Not Found", input.message(&error));
            let open = |input: &Input| input.open().map_err(|error| refused(input, error));
            let [(config, length), (scene, other)] = [open(inputs[0])?, open(inputs[1])?];
            // Each file is in memory twice: alone, and in the answer.
            let share = self.budget.take(2 * (length + other) as usize + 1000);
            let mut share = share.map_err(full)?;
            let text = |input: &Input, file, length| input.text(file, length).map_err(|error| refused(input, error));
            let (config, scene) = (text(inputs[0], config, length)?, text(inputs[1], scene, other)?);
            let version = [&config, &scene].map(|text| input::version_of(text.as_bytes())).join("-");
            let body = [&format!("{version} {}\n", config.len()), &config[..], &scene].concat();
            share.shrink(body.len());
            Ok(Answer { share: Some(share), ..Answer::ok("application/octet-stream", body) })
        };
        texts().unwrap_or_else(|refusal| refusal)
    }

    /// Returns a text that changes when the content of one of the files changes.
    fn version(&self) -> String {
        [&self.config, &self.scene].map(Input::version).join("-")
    }
}

/// Returns the answer to a request that is wrong.
fn invalid(message: impl Into<String>) -> Answer {
    Answer::refused("422 Unprocessable Content", message)
}

/// Returns the answer to a request that gives an error of the renderer.
fn wrong(error: cpu::Error) -> Answer {
    invalid(String::from_utf8_lossy(&error.message()))
}

/// Returns the answer to a request for which other requests leave too few bytes.
fn full(full: Full) -> Answer {
    Answer::refused("503 Service Unavailable", full.to_string())
}

#[cfg(test)]
mod tests;
