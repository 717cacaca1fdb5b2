//! Whole pictures in deterministic mode, on the device and in Rust, and what was compared of them.

use cpu::{Scatter, Vec3, reference};
use gpu_check::difference::difference;
use gpu_check::{Error, Float, Gpu, Picture, Renderer, Rendering, features_of};
use shaders::Library;

use crate::scenes::Case;

/// Returns a renderer with a pipeline for the scene's own features, and the picture that it renders.
///
/// # Errors
/// An error of the device, of the library's WGSL or of the scene.
pub fn prepared<'a, T: Float>(
    gpu: &'a Gpu,
    library: &Library,
    case: &Case,
) -> Result<(Renderer<'a, T>, Picture<T>), Error> {
    let features = features_of(&case.config, &case.scene)?;
    Ok((Renderer::new(gpu, library, &features, &[])?, Picture::new(&case.config, &case.scene)?))
}

/// Renders on the device, by a pipeline for the scene's own features.
pub fn on_device<T: Float>(gpu: &Gpu, library: &Library, case: &Case) -> Rendering<T> {
    let rendering = prepared(gpu, library, case).and_then(|(renderer, picture)| renderer.render(&picture));
    rendering.unwrap_or_else(|error| panic!("{}: {error}", case.name))
}

/// Renders by the reference.
pub fn by_reference(case: &Case) -> Vec<Vec3> {
    let mut means = Vec::new();
    reference::render_linear::<reference::Plain>(&case.config, &case.scene, Scatter::Deterministic, |_, mean| {
        means.push(mean)
    })
    .unwrap_or_else(|error| panic!("{}: {error}", case.name));
    means
}

/// The comparison of several pictures with the reference's.
#[derive(Debug, Default)]
pub struct Compared {
    pixels: usize,
    /// Number of pixels that are not black.
    lit: usize,
    faults: Vec<String>,
}

impl Compared {
    /// Compares a picture.
    pub fn add(&mut self, case: &Case, pixels: &[Vec3]) {
        let expected = by_reference(case);
        let found = difference(pixels, &expected);
        self.pixels += found.pixels;
        self.lit += expected.iter().filter(|color| **color != Vec3::ZERO).count();
        self.faults.extend((found.differing > 0).then(|| format!("{}: {found}", case.name)));
    }

    /// Fails if a picture differs, or if fewer than `least` pixels are not black.
    #[track_caller]
    pub fn check(&self, least: usize) {
        println!("{} pixels compared, {} of them not black", self.pixels, self.lit);
        assert!(self.faults.is_empty(), "{}", self.faults.join("\n"));
        assert!(self.lit >= least, "{} pixels with light are too few", self.lit);
    }
}
