//! The prepared scene: all values that rendering needs, computed once from the checked texts.

use std::borrow::Borrow;

use crate::render::{background::Background, max_depth::RaysLeft, ray_error::RayError};
use crate::{
    accel::choice::Accel, accel::extent::Extent, accel::may_hit::target::Target, accel::may_hit::target::targets,
    geometry::camera::Camera, image::quantize::Quantizer, input::config::Config, input::error::Error,
    input::error::with_room, input::material::Material, input::scene::Scene, input::size::Size, layout::Layout,
    layout::Objects, materials::prepared::PreparedMaterial, sampling::scatter_vectors::Scatter,
};

/// The prepared scene: all values that rendering needs and that are the same for all rays.
#[derive(Debug)]
pub struct Prepared<L: Layout> {
    /// The picture's size.
    pub size: Size,
    /// The origin of the camera rays, and the projection window.
    pub camera: Camera,
    /// Bounds of the rounding error of all camera rays.
    pub ray_error: RayError,
    /// The background: the colour of rays that hit no object.
    pub background: Background,
    /// The scene's objects, stored in the layout `L`.
    pub objects: L::Objects,
    /// The scene's materials, with constants that are computed once.
    pub materials: Vec<PreparedMaterial>,
    /// Whether the scene is [moderate](Extent::moderate), so that culling and background pixels are allowed.
    pub moderate: bool,
    /// The acceleration structure over the objects.
    pub accel: Accel,
    /// The objects for specular chains in lanes. It is empty if chains are traced one after the other; see [`targets`].
    pub chain_targets: Vec<Target>,
    /// The table that turns means into bytes.
    pub quantizer: Quantizer,
    /// Number of samples of each pixel.
    pub samples: u64,
    /// Maximum number of rays of a sample. See [`RaysLeft`].
    pub max_depth: u64,
    /// The convention of the random vectors.
    pub scatter: Scatter,
    /// The convention of the stream of scatter samples. It is `scatter`. But if no scatter sample can change a pixel,
    /// it is [`Scatter::Deterministic`], so that nothing is drawn.
    pub scatter_stream: Scatter,
    /// Whether every hit takes a scatter sample, because no object is refractive.
    pub scatters_everywhere: bool,
    /// Seed of the random generator of the samples' offsets.
    pub ray_seed: u64,
    /// Seed of the random generator of the scatter samples.
    pub material_seed: u64,
}

impl<L: Layout> Prepared<L> {
    /// Prepares `scene` for rendering with the configuration `config`. A scene that is passed by value is freed as
    /// early as possible. With a million objects it takes about as much memory as all that is built from it.
    ///
    /// # Errors
    /// [`Error::Picture`] if [`Config::check_picture`] returns it. [`Error::OutOfMemory`] if memory is short.
    pub fn new(config: &Config, scene: impl Borrow<Scene>, scatter: Scatter) -> Result<Self, Error> {
        let owner = scene;
        let scene = owner.borrow();
        let size = config.image_size()?;
        let camera = Camera::new(config, size)?;
        let mut objects = L::Objects::build(scene)?;
        let materials = scene.materials_in_use()?;
        let extent = Extent::new(&objects, &camera, &materials);
        let mut prepared_materials = with_room(scene.materials.len(), "the materials")?;
        prepared_materials.extend(scene.materials.iter().map(|material| PreparedMaterial::new(material, scatter)));
        drop(owner);
        let deterministic = scatter == Scatter::Deterministic;
        Ok(Self {
            size,
            camera,
            ray_error: RayError::new(&camera, size),
            background: Background::new(config),
            moderate: extent.moderate,
            accel: Accel::new(&mut objects, &extent)?,
            chain_targets: targets(&objects, &extent)?,
            objects,
            materials: prepared_materials,
            quantizer: Quantizer::new(config.gamma),
            samples: if deterministic { 1 } else { config.samples_per_pixel },
            max_depth: config.max_depth,
            scatter,
            scatter_stream: if needs_samples(config, &materials, scatter) { scatter } else { Scatter::Deterministic },
            scatters_everywhere: materials.iter().all(|material| takes_scatter_sample(material, scatter)),
            ray_seed: config.ray_rng_seed,
            material_seed: config.material_rng_seed,
        })
    }
}

/// Whether a scatter sample can change a pixel. It cannot with a maximum depth of one, because every path that hits a
/// surface is then black. It cannot for a metal without diffusion in the statement's convention, because the random
/// numbers are multiplied by zero. In the published convention this product may be a negative zero, so the sample is
/// needed.
fn needs_samples(config: &Config, materials: &[Material], scatter: Scatter) -> bool {
    let is_smooth = |material: &Material| matches!(*material, Material::Metal { diffusion, .. } if diffusion == 0.0);
    let is_needed = |material: &Material| {
        takes_scatter_sample(material, scatter) && (scatter == Scatter::Published || !is_smooth(material))
    };
    !RaysLeft::after_camera_ray(config.max_depth).is_none() && materials.iter().any(is_needed)
}

/// Whether a surface of `material` takes a scatter sample.
fn takes_scatter_sample(material: &Material, scatter: Scatter) -> bool {
    PreparedMaterial::new(material, scatter).takes_scatter_sample()
}
