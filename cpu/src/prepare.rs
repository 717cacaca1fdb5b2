//! From checked values to what the rendering needs and nothing more.

use crate::background::Background;
use crate::camera::Camera;
use crate::config::Config;
use crate::error::Error;
use crate::image::Size;
use crate::layout::{Layout, Objects};
use crate::material::Material;
use crate::quantize::Quantizer;
use crate::scatter::Scatter;
use crate::scene::Scene;

/// Everything that is the same for all rays, computed once. After it nothing can fail.
#[derive(Debug)]
pub struct Prepared<L: Layout> {
    /// The picture's size.
    pub size: Size,
    /// Where primary rays come from.
    pub camera: Camera,
    /// What rays see that meet nothing.
    pub background: Background,
    /// The scene's objects, in the layout's storage.
    pub objects: L::Objects,
    /// The scene's materials.
    pub materials: Vec<Material>,
    /// Means to bytes.
    pub quantizer: Quantizer,
    /// Rays a pixel.
    pub samples: u64,
    /// Most surfaces that a ray may meet.
    pub max_depth: u64,
    /// Where random vectors come from.
    pub scatter: Scatter,
    /// Seed of the samples' places.
    pub ray_seed: u64,
    /// Seed of the random vectors.
    pub material_seed: u64,
}

impl<L: Layout> Prepared<L> {
    /// Prepares to render `scene` as `config` asks.
    ///
    /// # Errors
    /// [`Error::Picture`] when the configuration makes no picture, [`Error::OutOfMemory`] when the scene does not fit.
    pub fn new(config: &Config, scene: &Scene, scatter: Scatter) -> Result<Self, Error> {
        let size = config.image_size()?;
        let deterministic = scatter == Scatter::Deterministic;
        Ok(Self {
            size,
            camera: Camera::new(config, size)?,
            background: Background::new(config),
            objects: L::Objects::build(scene)?,
            materials: scene.materials.clone(),
            quantizer: Quantizer::new(config.gamma),
            samples: if deterministic { 1 } else { config.samples_per_pixel },
            max_depth: config.max_depth,
            scatter,
            ray_seed: config.ray_rng_seed,
            material_seed: config.material_rng_seed,
        })
    }
}
