//! Rendering again when a file has changed.
//!
//! Texts are compared, several times a second, and not the times of their last change: every editor and every file
//! system is noticed that way, and saving without a change renders nothing.

use std::fs;
use std::path::PathBuf;
use std::time::Duration;

use shaders::Precision;

use super::args::Options;
use super::files::{self, UserModule};
use super::progress;
use super::trial::{Outcome, Trial};
use super::truth::Truth;
use crate::{Error, Gpu};

/// How often files are looked at.
const INTERVAL: Duration = Duration::from_millis(150);

/// Files that a rendering depends on: the modules, then the configuration and the scene.
type State = (Result<Vec<UserModule>, String>, Texts);
/// Of the configuration and the scene.
type Texts = Vec<Option<Vec<u8>>>;

/// A shader lab between two renderings.
#[derive(Debug)]
pub struct Lab {
    options: Options,
    gpu: Option<Gpu>,
    truth: Option<Truth>,
    /// The texts that the truth was computed from.
    scene: Texts,
}

impl Lab {
    /// A lab in which nothing has been rendered yet.
    #[must_use]
    pub const fn new(options: Options) -> Self {
        Self { options, gpu: None, truth: None, scene: Vec::new() }
    }

    /// Renders once and gives the report.
    ///
    /// # Errors
    /// A message that names the person's file.
    pub fn render(&mut self) -> Result<Outcome, String> {
        let modules = files::read(&self.options.modules).map_err(|error| error.to_string())?;
        let result = self.render_with(&modules);
        if matches!(result, Err(Error::DeviceLost { .. } | Error::Timeout { .. } | Error::OutOfMemory { .. })) {
            self.gpu = None;
        }
        result.map_err(|error| explain(&error, &modules))
    }

    fn render_with(&mut self, modules: &[UserModule]) -> Result<Outcome, Error> {
        let scene = self.scene_texts();
        if self.truth.is_none() || scene != self.scene {
            progress::say("the CPU renders by the definition");
            self.truth = Some(Truth::read(&self.options.config, &self.options.scene)?);
            self.scene = scene;
        }
        if self.gpu.is_none() {
            self.gpu = Some(Gpu::open()?);
        }
        let (Some(gpu), Some(truth)) = (&self.gpu, &self.truth) else { unreachable!("both were just made") };
        let trial = Trial { gpu, options: &self.options, modules, truth };
        match self.options.precision {
            Precision::F32 => trial.run::<f32>(),
            Precision::F64 => trial.run::<f64>(),
        }
    }

    fn scene_texts(&self) -> Texts {
        [&self.options.config, &self.options.scene].map(|path| fs::read(path).ok()).to_vec()
    }

    /// Hands a report or a message to `say` now and after every change, until `say` answers no.
    pub fn watch(&mut self, mut say: impl FnMut(Result<Outcome, String>) -> bool) {
        loop {
            let before = self.state();
            let result = self.render();
            if !say(result) {
                return;
            }
            while self.state() == before {
                std::thread::sleep(INTERVAL);
            }
        }
    }

    /// All that a rendering depends on, as it is now.
    fn state(&self) -> State {
        (files::read(&self.options.modules).map_err(|error| error.to_string()), self.scene_texts())
    }
}

/// The error's own words; where they point elsewhere than to a person's file, that file too.
fn explain(error: &Error, modules: &[UserModule]) -> String {
    let mut message = error.to_string();
    if !matches!(error, Error::Shader(_) | Error::Refused { .. } | Error::Unwritten { .. }) {
        return message;
    }
    let names: Vec<(PathBuf, &str)> =
        modules.iter().map(|module| (module.path.clone(), module.name.as_str())).collect();
    let is_named = |path: &PathBuf| message.starts_with(&format!("{}:", path.display()));
    if names.iter().any(|(path, _)| is_named(path)) {
        return message;
    }
    for (path, name) in names {
        let path = path.display();
        message.push_str(&format!("\n{path}:1: stands in for [{name}], and may lack a name that others need of it"));
    }
    message
}
