//! Renders the picture of a trial on the device: in deterministic mode, or with random numbers.

use std::time::{Duration, Instant};

use shaders::{Features, Library, Precision};

use super::files::{self, UserModule};
use super::truth::Truth;
use super::{args, guard};
use crate::sampled::streams::Streams;
use crate::sampled::{SampleRenderer, SampledRendering};
use crate::terminal::bar;
use crate::{Error, Float, Gpu, Picture, Renderer, Rendering};

/// The kernel of a picture in deterministic mode.
const IMAGE: &str = "kernels/image";
/// The kernel that traces samples, and the one that adds them.
const SAMPLES: [&str; 2] = ["kernels/samples", "kernels/means"];

/// A picture by WGSL.
pub(super) struct Rendered<T> {
    pub rendering: Rendering<T>,
    /// The time to compile the kernels.
    pub compiled: Duration,
    /// For a picture with random numbers: a line for the report, and the number of paths that took another number of
    /// words from the stream of scatter vectors than in the reference.
    pub words: Option<(String, u64)>,
}

/// Returns the name of the kernel that traces rays. Compiles the other kernel of a picture with random numbers in the
/// separate process.
///
/// # Errors
/// [`Error::Request`] if such a picture uses none of the user's modules, so that no change of them could be seen.
pub(super) fn check_modules(
    gpu: &Gpu,
    library: &Library,
    modules: &[UserModule],
    truth: &Truth,
    precision: Precision,
) -> Result<&'static str, Error> {
    if truth.recording.is_none() {
        return Ok(IMAGE);
    }
    let [samples, means] = SAMPLES;
    let (samples_text, means_text) = (library.compose(samples, precision)?, library.compose(means, precision)?);
    let paths: Vec<_> = samples_text.parts().chain(means_text.parts()).map(|(path, _)| path.to_owned()).collect();
    if !modules.iter().any(|module| paths.contains(&files::shown(&module.path))) {
        let names: Vec<_> = modules.iter().map(|module| format!("[{}]", module.name)).collect();
        let message = format!("--samples renders with [{samples}], which does not use {}", names.join(", "));
        return Err(Error::Request { message });
    }
    guard::check(gpu, &means_text, &[])?;
    Ok(samples)
}

/// Compiles the kernels and renders the picture.
///
/// # Errors
/// The errors of [`Renderer`] and [`SampleRenderer`].
pub(super) fn render<T: Float>(
    gpu: &Gpu,
    library: &Library,
    (features, own): (&Features, &args::Own<'_>),
    picture: &Picture<T>,
    truth: &Truth,
) -> Result<Rendered<T>, Error> {
    let progress = bar("WGSL renders", 0);
    let tell = |done, of| {
        progress.set_length(of);
        progress.set_position(done);
    };
    let start = Instant::now();
    let Some(recording) = &truth.recording else {
        let renderer = Renderer::<T>::new(gpu, library, features, own)?;
        let compiled = start.elapsed();
        return Ok(Rendered { rendering: renderer.render_telling(picture, tell)?, compiled, words: None });
    };
    let renderer = SampleRenderer::<T>::new(gpu, library, features, own)?;
    let compiled = start.elapsed();
    let SampledRendering { size, pixels, disagreeing, time, .. } =
        renderer.render_from(picture, recording, Streams::new(recording), tell)?;
    let text = format!(
        "{} samples for each pixel, scatter convention [{}]; {disagreeing} of {} paths take another number of words\n",
        recording.samples_per_pixel,
        recording.convention,
        recording.words.len(),
    );
    Ok(Rendered { rendering: Rendering { size, pixels, time }, compiled, words: Some((text, disagreeing)) })
}
