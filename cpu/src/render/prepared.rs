//! The prepared scene: all values that rendering needs, computed once from the checked texts.

use crate::render::background::Background;
use crate::{
    accel::choice::Accel, accel::extent::Extent, geometry::camera::Camera, image::quantize::Quantizer,
    input::config::Config, input::error::Error, input::error::with_room, input::material::Material,
    input::scene::Scene, input::size::Size, layout::Layout, layout::Objects, materials::prepared::PreparedMaterial,
    sampling::scatter_vectors::Scatter,
};

/// Everything that is the same for all rays, computed once.
#[derive(Debug)]
pub struct Prepared<L: Layout> {
    /// The picture's size.
    pub size: Size,
    /// The origin of the camera rays, and the window.
    pub camera: Camera,
    /// The colour of rays that hit nothing.
    pub background: Background,
    /// The scene's objects, in the layout's storage.
    pub objects: L::Objects,
    /// The scene's materials, ready to scatter.
    pub materials: Vec<PreparedMaterial>,
    /// The acceleration structure over the objects.
    pub accel: Accel,
    /// Turns means into bytes.
    pub quantizer: Quantizer,
    /// Samples of a pixel.
    pub samples: u64,
    /// Most rays of a sample; see [`RaysLeft`](crate::render::max_depth::RaysLeft).
    pub max_depth: u64,
    /// The convention of the random vectors.
    pub scatter: Scatter,
    /// The convention of the stream of scatter samples. It is `scatter`, or deterministic if no scatter sample can
    /// change a pixel, because then nothing needs to be drawn.
    pub scatter_stream: Scatter,
    /// Whether no material in use is refractive: then every hit takes a scatter sample.
    pub scatters_everywhere: bool,
    /// Seed of the samples' offsets.
    pub ray_seed: u64,
    /// Seed of the scatter samples.
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
        let mut prepared_materials = with_room(scene.materials.len(), "the materials")?;
        prepared_materials.extend(scene.materials.iter().map(|material| PreparedMaterial::new(material, scatter)));
        let deterministic = scatter == Scatter::Deterministic;
        Ok(Self {
            size,
            camera,
            background: Background::new(config),
            accel: Accel::new(&objects, &extent)?,
            objects,
            materials: prepared_materials,
            quantizer: Quantizer::new(config.gamma),
            samples: if deterministic { 1 } else { config.samples_per_pixel },
            max_depth: config.max_depth,
            scatter,
            scatter_stream: if needs_samples(config, &materials, scatter) { scatter } else { Scatter::Deterministic },
            scatters_everywhere: !materials.iter().any(|material| matches!(material, Material::Refractive { .. })),
            ray_seed: config.ray_rng_seed,
            material_seed: config.material_rng_seed,
        })
    }
}

/// Whether a scatter sample can change a pixel. With a depth of one every path that scatters is black. A metal without
/// diffusion multiplies the statement's draws by zero. (A published vector times zero may be a negative zero.)
fn needs_samples(config: &Config, materials: &[Material], scatter: Scatter) -> bool {
    let scatters = |material: &Material| match *material {
        Material::Matte { .. } => true,
        Material::Metal { diffusion, .. } => diffusion != 0.0 || scatter == Scatter::Published,
        Material::Refractive { .. } => false,
    };
    config.max_depth > 1 && materials.iter().any(scatters)
}
