//! Renders again when a file has changed.
//!
//! The contents of the files are compared several times a second, instead of the times of their last change. This works
//! with every editor and every file system. Saving a file without a change does not render again.

use std::path::PathBuf;
use std::time::Duration;

use shaders::Precision;

use super::args::Options;
use super::files::{UserModule, shown};
use super::png::Places;
use super::sources::{Sources, Text};
use super::trial::{self, Outcome, Trial};
use super::truth::Truth;
use crate::{Error, Gpu, terminal};

/// Time between two readings of all files.
const INTERVAL: Duration = Duration::from_millis(150);

/// The state that is kept between two renderings: the open device and the picture by the CPU.
#[derive(Debug)]
pub struct Lab {
    options: Options,
    gpu: Option<Gpu>,
    truth: Option<Truth>,
    /// The configuration and the scene from which `truth` was computed.
    texts: Option<[Text; 2]>,
}

impl Lab {
    /// Returns a lab that has not rendered anything yet.
    #[must_use]
    pub const fn new(options: Options) -> Self {
        Self { options, gpu: None, truth: None, texts: None }
    }

    /// Renders once, and returns the report.
    ///
    /// # Errors
    /// A message for the user. If the error comes from a module, it names the user's file.
    pub fn render(&mut self) -> Result<Outcome, String> {
        self.render_from(&Sources::read(&self.options, None))
    }

    fn render_from(&mut self, sources: &Sources) -> Result<Outcome, String> {
        let modules = sources.modules.as_ref().map_err(Clone::clone)?;
        let result = self.render_with(modules, sources);
        if matches!(result, Err(Error::DeviceLost { .. } | Error::Timeout { .. } | Error::OutOfMemory { .. })) {
            self.gpu = None;
        }
        result.map_err(|error| explain(&error, modules))
    }

    fn render_with(&mut self, modules: &[UserModule], sources: &Sources) -> Result<Outcome, Error> {
        // The outputs are opened first, so that a file that cannot be written ends the trial early.
        let places = Places::open(&self.options, modules)?;
        if self.truth.is_none() || self.texts.as_ref() != Some(&sources.texts) {
            self.truth = None;
            let (config, scene) = sources.parse(&self.options)?;
            // Checked before the CPU renders, which with many objects takes half a minute.
            trial::check(&self.options, modules, &config, &scene)?;
            terminal::note("the CPU renders by the definition ...");
            self.truth = Some(Truth::new(config, scene, self.options.convention())?);
            self.texts = Some(sources.texts.clone());
        }
        if self.gpu.is_none() {
            self.gpu = Some(Gpu::open()?.with_form(self.options.form()));
        }
        let (Some(gpu), Some(truth)) = (&self.gpu, &self.truth) else { unreachable!("both were just made") };
        let trial = Trial { gpu, options: &self.options, modules, truth };
        match self.options.precision() {
            Precision::F32 => trial.run::<f32>(places),
            Precision::F64 => trial.run::<f64>(places),
        }
    }

    /// Renders now and after every change of a file. Calls `say` with each report or error message, until `say` returns
    /// false.
    pub fn watch(&mut self, mut say: impl FnMut(Result<Outcome, String>) -> bool) {
        let mut sources = Sources::read(&self.options, None);
        loop {
            let result = self.render_from(&sources);
            if !say(result) {
                return;
            }
            sources = loop {
                let now = Sources::read(&self.options, Some(&sources));
                if now != sources {
                    break now;
                }
                std::thread::sleep(INTERVAL);
            };
        }
    }
}

/// Returns the message of `error`. If the message of a shader's error does not begin with one of the user's files,
/// these files are listed at its end.
fn explain(error: &Error, modules: &[UserModule]) -> String {
    let mut message = error.to_string();
    if !matches!(error, Error::Shader(_) | Error::Refused { .. } | Error::Unwritten { .. }) {
        return message;
    }
    let names: Vec<(PathBuf, &str)> =
        modules.iter().map(|module| (module.path.clone(), module.name.as_str())).collect();
    let is_named = |path: &PathBuf| message.starts_with(&format!("{}:", shown(path)));
    if names.iter().any(|(path, _)| is_named(path)) {
        return message;
    }
    // The driver refuses only what naga accepts, so then no name is missing.
    let hint = if matches!(error, Error::Shader(_)) { ", and may lack a name that others need of it" } else { "" };
    for (path, name) in names {
        message.push_str(&format!("\n{}:1: stands in for [{name}]{hint}", shown(&path)));
    }
    message
}
