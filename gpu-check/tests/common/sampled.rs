//! Renders pictures with random numbers, and counts what differs from the reference.

use std::collections::BTreeMap;

use cpu::{Config, Scene, Vec3};
use gpu_check::difference::difference;
use gpu_check::sampled::{Convention, Recording, SampleRenderer, SampledRendering};
use gpu_check::{Float, Gpu, Picture};
use shaders::{Features, Library};

/// A scene with its configuration and its name.
#[derive(Clone, Debug)]
pub struct Case {
    /// The name in messages: the folder of the scene, or a description of the edge case.
    pub name: String,
    /// The configuration.
    pub config: Config,
    /// The scene.
    pub scene: Scene,
}

/// Renders pictures with the pipelines of this device. One pipeline serves all scenes with the same features.
pub struct Pipelines<'a, T> {
    gpu: &'a Gpu,
    library: &'a Library,
    renderers: BTreeMap<String, SampleRenderer<'a, T>>,
}

impl<'a, T: Float> Pipelines<'a, T> {
    pub fn new(gpu: &'a Gpu, library: &'a Library) -> Self {
        Self { gpu, library, renderers: BTreeMap::new() }
    }

    /// Renders a picture with the pipeline for `features`.
    pub fn render(&mut self, case: &Case, features: &Features, recording: &Recording) -> SampledRendering<T> {
        let key = format!("{features:?}");
        if !self.renderers.contains_key(&key) {
            let renderer = SampleRenderer::new(self.gpu, self.library, features, &[]);
            self.renderers.insert(key.clone(), renderer.unwrap_or_else(|error| panic!("{}: {error}", case.name)));
        }
        let picture = Picture::new(&case.config, &case.scene).unwrap_or_else(|error| panic!("{error}"));
        let rendering = self.renderers[&key].render(&picture, recording);
        rendering.unwrap_or_else(|error| panic!("{}: {error}", case.name))
    }
}

pub fn record(case: &Case, convention: Convention) -> Recording {
    let recording = Recording::new(&case.config, &case.scene, convention);
    recording.unwrap_or_else(|error| panic!("{}: {error}", case.name))
}

/// What was compared.
#[derive(Default)]
pub struct Tally {
    pub pictures: usize,
    pub pixels: usize,
    pub samples: usize,
    pub words: u64,
    pub not_black: usize,
    pub faults: Vec<String>,
}

impl Tally {
    pub fn add(&mut self, name: &str, rendering: &SampledRendering<f64>, recording: &Recording) {
        let found = difference(&rendering.pixels, &recording.means);
        self.pictures += 1;
        self.pixels += found.pixels;
        self.samples += recording.words.len();
        self.words += recording.words.iter().map(|count| u64::from(*count)).sum::<u64>();
        self.not_black += recording.means.iter().filter(|mean| **mean != Vec3::ZERO).count();
        if found.differing > 0 || rendering.disagreeing > 0 {
            let convention = recording.convention;
            let SampledRendering { disagreeing, first_disagreeing, .. } = rendering;
            self.faults.push(format!(
                "{name}, {convention:?}: {found}; {disagreeing} paths take other words, the first {first_disagreeing:?}"
            ));
        }
    }
}
