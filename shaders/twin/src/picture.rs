//! A scene in the form for a device: the contents of the buffers of `shaders/wgsl/picture.wgsl`.

use crate::Features;
use cpu::internals::Camera;
use cpu::internals::geometry::cylinder::CylinderRecord;
use cpu::internals::geometry::sphere::SphereRecord;
use cpu::internals::input::scene::{Scene, Shape};
use cpu::internals::layout::Placed;
use cpu::internals::math::real::Real;
use cpu::internals::render::background::Background;
use cpu::{Config, Error as CpuError, Material, Size, Vec3};

/// The reason why a scene has no form for a device.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The configuration makes no picture.
    #[error("{}", String::from_utf8_lossy(&.0.message_for_terminal()))]
    Scene(#[from] cpu::Error),
    /// The maximum depth does not fit in 32 bits, and no device could hold the list of a path's surfaces.
    #[error("a max_depth of {depth} is too large for a device; use a smaller one")]
    TooDeep {
        /// The maximum depth of the configuration.
        depth: u64,
    },
}

/// A material in the form of `material.wgsl`.
#[derive(Clone, Copy, Debug)]
pub struct PackedMaterial<T> {
    /// The factor by which the surface multiplies the colour of the scattered ray.
    pub reflectance: Vec3<T>,
    /// The refractive index; 0 for materials that are not refractive.
    pub index: T,
    /// The factor of a scatter vector: 1 for a matte material, the diffusion for a metal one, 0 for a refractive one.
    pub extent: T,
    /// The kind of the material, which is the variant of [`Material`].
    pub kind: Kind,
}

/// The variants of [`Material`], with the numbers that `material.wgsl` gives them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum Kind {
    /// [`Material::Matte`].
    Matte = 0,
    /// [`Material::Metal`].
    Metal = 1,
    /// [`Material::Refractive`].
    Refractive = 2,
}

/// A scene in one precision with its camera.
#[derive(Clone, Debug)]
pub struct Picture<T> {
    /// Number of columns and rows.
    pub size: Size,
    /// The camera. Its window is computed in f64 and then rounded, because it needs a tangent.
    pub camera: Camera<T>,
    /// The colours for rays that hit no object.
    pub background: Background<T>,
    /// The spheres in the order of the file.
    pub spheres: Vec<Placed<SphereRecord<T>>>,
    /// The cylinders in the order of the file.
    pub cylinders: Vec<Placed<CylinderRecord<T>>>,
    /// The materials, in the order of the file.
    pub materials: Vec<PackedMaterial<T>>,
    /// The maximum depth: the number of rays that a sample may send, the camera ray included. If the last of them
    /// hits an object, the sample is black.
    pub max_depth: u32,
}

impl<T: Real> Picture<T> {
    /// Returns the picture of `scene` with the configuration `config`. Every number is rounded once to the precision
    /// `T`.
    ///
    /// # Errors
    /// [`Error::Scene`] if the configuration makes no picture; [`Error::TooDeep`] if the maximum depth does not fit in
    /// 32 bits.
    pub fn new(config: &Config, scene: &Scene) -> Result<Self, Error> {
        let size = config.image_size().map_err(CpuError::from)?;
        let camera = Camera::new(config, size).map_err(CpuError::from)?.lanes();
        let background = Background::new(config).lanes();
        let (mut spheres, mut cylinders) = (Vec::new(), Vec::new());
        for (file_index, object) in (0..).zip(&scene.objects) {
            let material = object.material;
            match object.shape {
                Shape::Sphere(shape) => {
                    let record = SphereRecord::new(shape.center.map(T::of), T::of(shape.radius));
                    spheres.push(Placed { record, file_index, material });
                }
                Shape::Cylinder(shape) => {
                    let (center, axis) = (shape.center.map(T::of), shape.axis.map(T::of));
                    let record = CylinderRecord::new(center, T::of(shape.radius), axis);
                    cylinders.push(Placed { record, file_index, material });
                }
            }
        }
        let materials = scene.materials.iter().map(pack).collect();
        Ok(Self { size, camera, background, spheres, cylinders, materials, max_depth: depth(config)? })
    }
}

/// Returns the maximum depth.
///
/// # Errors
/// [`Error::TooDeep`] if it does not fit in 32 bits.
pub fn depth(config: &Config) -> Result<u32, Error> {
    u32::try_from(config.max_depth).map_err(|_| Error::TooDeep { depth: config.max_depth })
}

fn pack<T: Real>(material: &Material) -> PackedMaterial<T> {
    let (kind, index, extent) = match *material {
        Material::Matte { .. } => (Kind::Matte, 0.0, 1.0),
        Material::Metal { diffusion, .. } => (Kind::Metal, 0.0, diffusion),
        Material::Refractive { index } => (Kind::Refractive, index, 0.0),
    };
    let reflectance = material.reflectance().map(T::of);
    PackedMaterial { reflectance, index: T::of(index), extent: T::of(extent), kind }
}

/// Returns the features that a pipeline for `scene` needs. Materials that no object has are ignored.
///
/// # Errors
/// [`Error::TooDeep`] if the maximum depth does not fit in 32 bits.
pub fn features_of(config: &Config, scene: &Scene) -> Result<Features, Error> {
    let of_shape =
        |spheres: bool| scene.objects.iter().any(|object| matches!(object.shape, Shape::Sphere(_)) == spheres);
    let of_kind = |kind: Kind| {
        let mut materials = scene.objects.iter().map(|object| &scene.materials[object.material as usize]);
        materials.any(|material| pack::<f64>(material).kind == kind)
    };
    Ok(Features {
        has_spheres: of_shape(true),
        has_cylinders: of_shape(false),
        has_matte: of_kind(Kind::Matte),
        has_metal: of_kind(Kind::Metal),
        has_refraction: of_kind(Kind::Refractive),
        max_depth: depth(config)?,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_materials_of_objects_count_as_features() {
        let text = "matte: a 1 1 1\nmetal: unused 1 1 1 0\nrefractive: b 1.5\nsphere: 0 0 0 1 a\nsphere: 0 0 0 2 b\n";
        let scene = Scene::parse(text.as_bytes()).expect("it is valid");
        let features = features_of(&Config::default(), &scene).expect("five is not deep");
        let expected = Features { has_cylinders: false, has_metal: false, ..Features::all(5) };
        assert_eq!(features, expected);
    }
}
