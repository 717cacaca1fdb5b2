//! The picture as the CPU has it, computed once and kept while the person's modules change.

use std::cell::OnceCell;
use std::path::Path;
use std::time::{Duration, Instant};

use cpu::{Config, Scatter, Scene, Vec3, reference};

use crate::{Error, Picture};

/// A configuration, a scene, and the picture of it in deterministic mode.
#[derive(Clone, Debug)]
pub struct Truth {
    /// The configuration.
    pub config: Config,
    /// The scene.
    pub scene: Scene,
    /// Linear colours in f64, by the definition.
    pub wide: Vec<Vec3>,
    /// The scene for f32, and its picture once that is asked for.
    single: (Picture<f32>, OnceCell<Vec<Vec3<f32>>>),
    /// What the first took, on one core.
    pub time: Duration,
}

impl Truth {
    /// Reads both files and renders.
    ///
    /// # Errors
    /// [`Error::Scene`] with the file's name and line.
    pub fn read(config: &Path, scene: &Path) -> Result<Self, Error> {
        Self::new(Config::read(config)?, Scene::read(scene)?)
    }

    /// Renders.
    ///
    /// # Errors
    /// [`Error::Scene`] when the configuration makes no picture.
    pub fn new(config: Config, scene: Scene) -> Result<Self, Error> {
        let mut wide = Vec::new();
        let start = Instant::now();
        reference::render_linear(&config, &scene, Scatter::Deterministic, |_, color| wide.push(color))?;
        let time = start.elapsed();
        let single = (Picture::<f32>::new(&config, &scene)?, OnceCell::new());
        Ok(Self { config, scene, wide, single, time })
    }

    /// The picture with every formula in f32: what a device may at best give in f32. Computed when it is first asked for:
    /// with many objects it takes as long as the one in f64.
    #[must_use]
    pub fn single(&self) -> &[Vec3<f32>] {
        let (picture, colors) = &self.single;
        colors.get_or_init(|| (0..picture.size.pixels()).map(|index| picture.color(index)).collect())
    }
}
