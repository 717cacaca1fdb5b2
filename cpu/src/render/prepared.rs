//! From checked values to what the rendering needs and nothing more.

use crate::accel::extent::Extent;
use crate::materials::prepared::PreparedMaterial;

use crate::accel::choice::Accel;
use crate::geometry::camera::Camera;
use crate::image::quantize::Quantizer;
use crate::input::config::Config;
use crate::input::error::Error;
use crate::input::material::Material;
use crate::input::scene::Scene;
use crate::input::size::Size;
use crate::layout::{Layout, Objects};
use crate::render::background::Background;
use crate::sampling::scatter_vectors::Scatter;

/// Everything that is the same for all rays, computed once.
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
    /// The scene's materials, ready to scatter.
    pub materials: Vec<PreparedMaterial>,
    /// How the nearest object of a ray is found.
    pub search: Accel,
    /// Means to bytes.
    pub quantizer: Quantizer,
    /// Rays a pixel.
    pub samples: u64,
    /// Most surfaces that a ray may meet.
    pub max_depth: u64,
    /// The convention of the picture.
    pub scatter: Scatter,
    /// Where random vectors come from: from nowhere where no path can tell.
    pub vectors: Scatter,
    /// No material in use is refractive: wherever a path's last ray ends, it takes a random vector.
    pub scatters_everywhere: bool,
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
        let camera = Camera::new(config, size)?;
        let objects = L::Objects::build(scene)?;
        let materials = scene.materials_in_use()?;
        let extent = Extent::new(&objects, &camera, &materials);
        let deterministic = scatter == Scatter::Deterministic;
        Ok(Self {
            size,
            camera,
            background: Background::new(config),
            search: Accel::new(&objects, &extent)?,
            objects,
            materials: prepare_materials(scene, scatter)?,
            quantizer: Quantizer::new(config.gamma),
            samples: if deterministic { 1 } else { config.samples_per_pixel },
            max_depth: config.max_depth,
            scatter,
            vectors: if needs_vectors(config, &materials, scatter) { scatter } else { Scatter::Deterministic },
            scatters_everywhere: !materials.iter().any(|material| matches!(material, Material::Refractive { .. })),
            ray_seed: config.ray_rng_seed,
            material_seed: config.material_rng_seed,
        })
    }
}

fn prepare_materials(scene: &Scene, scatter: Scatter) -> Result<Vec<PreparedMaterial>, Error> {
    let mut prepared = Vec::new();
    let out_of_memory = |_| Error::OutOfMemory { what: "the materials" };
    prepared.try_reserve_exact(scene.materials.len()).map_err(out_of_memory)?;
    prepared.extend(scene.materials.iter().map(|material| PreparedMaterial::new(material, scatter)));
    Ok(prepared)
}

/// Whether a random vector may reach a pixel. With a depth of one every path that scatters is black; a metal without
/// diffusion multiplies the statement's draws by nought. (A published vector times nought may be a negative nought.)
fn needs_vectors(config: &Config, materials: &[Material], scatter: Scatter) -> bool {
    let spreads = |material: &Material| match *material {
        Material::Matte { .. } => true,
        Material::Metal { diffusion, .. } => diffusion != 0.0 || scatter == Scatter::Published,
        Material::Refractive { .. } => false,
    };
    config.max_depth > 1 && materials.iter().any(spreads)
}
