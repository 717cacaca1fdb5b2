//! The reference: a renderer that follows docs/specification.md line by line. It is slow, and takes no shortcut.
//!
//! Every ray is intersected with all objects, in the order of the scene file. Every shortcut of the real renderer must
//! give the reference's bytes. The two share the vector arithmetic, the making of a random number from a word and of
//! unit vectors from numbers, the picture's height, the camera's window and the definition of a byte. Nearly all other
//! formulas exist twice, so a comparison can show an error of either renderer. This holds for [`Plain`] intersections,
//! to which records only pass numbers. With [`Exact`] intersections, the reference also shares the module `exact` with
//! the real renderer.
//!
//! Uses `math`, `input`, `geometry`, `exact`, `sampling` and `image`. Begin here: this is the specification as a
//! program.

mod hit;
pub mod intersect;
mod nearest;

pub use crate::reference::intersect::{Exact, Intersect, Plain};

use crate::reference::{hit::Hit, nearest::is_nearer};
use crate::{
    geometry::camera::Camera, geometry::ray::Ray, image::Image, image::Rgb, image::quantize::quantize,
    input::config::Config, input::error::Error, input::error::push, input::material::Material,
    input::scene::MaterialId, input::scene::Scene, math::vec3::Vec3, sampling::scatter_vectors::Scatter,
    sampling::scatter_vectors::ScatterVectors, sampling::uniform::Uniform,
};

/// Renders a picture by the specification, slowly and literally, with the plain formulas for intersections. Their
/// rounding errors may decide that a ray hits where it misses, or the reverse. Then the picture differs from that of
/// [`crate::render()`]. To get the bytes of that picture, call [`render_with`] with [`Exact`].
///
/// # Errors
/// [`Error::Picture`] if the picture has more than 2^30 pixels, or if the camera has no projection window: its position
/// equals its target, north is null or parallel to the view, or the window is not finite. [`Error::OutOfMemory`] if
/// memory is short.
pub fn render<I: Image>(config: &Config, scene: &Scene, scatter: Scatter) -> Result<I, Error> {
    render_with::<I, Plain>(config, scene, scatter)
}

/// Renders as [`render`] does, but with the intersections of `P`: [`Plain`] or [`Exact`].
///
/// # Errors
/// The errors of [`render`].
pub fn render_with<I: Image, P: Intersect>(config: &Config, scene: &Scene, scatter: Scatter) -> Result<I, Error> {
    let size = config.image_size()?;
    let mut image = I::black(size)?;
    render_linear::<P>(config, scene, scatter, |index, mean| {
        let [red, green, blue] = mean.to_array().map(|channel| quantize(channel, config.gamma));
        image.set_pixel(index, Rgb { red, green, blue });
    })?;
    Ok(image)
}

/// The work for a picture without any shortcut: the rays that the reference traced.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Number of rays.
    pub rays: u64,
    /// Number of rays that hit an object.
    pub hits: u64,
}

/// Renders by the specification, with the intersections of `P`. Calls `pixel` for every pixel, with its index and its
/// mean colour before quantisation. Returns the numbers of rays and hits.
///
/// # Errors
/// The errors of [`render`].
pub fn render_linear<P: Intersect>(
    config: &Config,
    scene: &Scene,
    scatter: Scatter,
    pixel: impl FnMut(usize, Vec3),
) -> Result<Counts, Error> {
    render_recorded::<P>(config, scene, scatter, |_| (), pixel)
}

/// Renders as [`render_linear`] does. After each sample it also calls `sample` with the number of words that the path
/// took from the generator of the materials. With these numbers another renderer can start any path at its place in
/// the stream, without tracing the paths before it.
///
/// # Errors
/// The errors of [`render`].
pub fn render_recorded<P: Intersect>(
    config: &Config,
    scene: &Scene,
    scatter: Scatter,
    mut sample: impl FnMut(u64),
    mut pixel: impl FnMut(usize, Vec3),
) -> Result<Counts, Error> {
    let size = config.image_size()?;
    let camera = Camera::new(config, size)?;
    let deterministic = scatter == Scatter::Deterministic;
    let samples = if deterministic { 1 } else { config.samples_per_pixel };
    let mut jitter = Uniform::new(config.ray_rng_seed);
    let vectors = ScatterVectors::new(scatter, config.material_rng_seed);
    let mut paths = Paths { config, scene, vectors, counts: Counts::default() };
    for row in 0..size.height() {
        for column in 0..size.width() {
            let mut sum = Vec3::ZERO;
            for _ in 0..samples {
                let (mut x, mut y) = (0.0, 0.0);
                if !deterministic {
                    x = jitter.draw(-0.5, 0.5);
                    y = jitter.draw(-0.5, 0.5);
                }
                let target = camera.origin + camera.delta_x * (column as f64 + x) + camera.delta_y * (row as f64 + y);
                let start = paths.vectors.words();
                sum = sum + paths.color::<P>(camera.position, target - camera.position, config.max_depth)?;
                sample(paths.vectors.words() - start);
            }
            pixel(row * size.width() + column, sum / samples as f64);
        }
    }
    Ok(paths.counts)
}

/// The scene, and the state that all paths of a picture share. Paths are traced one after the other.
struct Paths<'a> {
    config: &'a Config,
    scene: &'a Scene,
    vectors: ScatterVectors,
    counts: Counts,
}

impl Paths<'_> {
    /// Returns the colour that a ray contributes (specification, section 8.1). The recursion of the specification is a
    /// loop here, so that no depth overflows the call stack.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`] if memory is short. A path between mirrors hits up to `max_depth` surfaces.
    fn color<P: Intersect>(&mut self, mut origin: Vec3, mut direction: Vec3, max_depth: u64) -> Result<Vec3, Error> {
        // The reflectances of the surfaces on the path, in the order of the hits.
        let mut reflectances = Vec::new();
        let mut color = Vec3::ZERO;
        for _ in 0..max_depth {
            self.counts.rays += 1;
            let Some((hit, material)) = self.nearest::<P>(&Ray { origin, direction }) else {
                color = self.background(direction);
                break;
            };
            self.counts.hits += 1;
            let front = direction.dot(hit.outward) < 0.0;
            let normal = if front { hit.outward } else { -hit.outward };
            let (reflectance, scattered) = self.scatter(material, direction, normal, front);
            push(&mut reflectances, reflectance, "the surfaces that a ray meets")?;
            (origin, direction) = (hit.point, scattered);
        }
        // The factors are applied from the last hit back to the first, in the order in which the recursion returns.
        for reflectance in reflectances.into_iter().rev() {
            color = color.attenuate(reflectance);
        }
        Ok(color)
    }

    /// Returns the nearest hit among all objects, in the order of the scene file, and the material of its object. The
    /// result is `None` if the ray hits no object.
    fn nearest<P: Intersect>(&self, ray: &Ray) -> Option<(Hit, Material)> {
        let mut nearest: Option<(Hit, MaterialId)> = None;
        for object in &self.scene.objects {
            let Some(hit) = Hit::new::<P>(&object.shape, ray) else { continue };
            let is_nearer = nearest.is_none_or(|(nearest, _)| {
                let hits = [(hit.lambda, hit.surface), (nearest.lambda, nearest.surface)];
                is_nearer(hit.is_on_cap(), P::compare(ray, hits))
            });
            if is_nearer {
                nearest = Some((hit, object.material));
            }
        }
        nearest.map(|(hit, material)| (hit, self.scene.materials[material as usize]))
    }

    /// Returns the colour of the background in a direction.
    fn background(&self, direction: Vec3) -> Vec3 {
        let m = (direction.unit().y + 1.0) / 2.0;
        self.config.background_light_color * (1.0 - m) + self.config.background_dark_color * m
    }

    /// Returns the reflectance of a surface, and the direction of the scattered ray. `direction` is that of the ray
    /// that hits the surface, and `normal` is on the side that the ray comes from.
    fn scatter(&mut self, material: Material, direction: Vec3, normal: Vec3, front: bool) -> (Vec3, Vec3) {
        match material {
            Material::Matte { reflectance } => {
                let scattered = normal + self.vectors.next(1.0);
                (reflectance, if scattered.is_negligible() { normal } else { scattered })
            }
            Material::Metal { reflectance, diffusion } => {
                let mirrored = direction - normal * (2.0 * direction.dot(normal));
                (reflectance, mirrored.unit() + self.vectors.next(diffusion))
            }
            Material::Refractive { index } => {
                let u = direction.unit();
                let cos = (-u.dot(normal)).min(1.0);
                let sin = (1.0 - cos * cos).sqrt();
                let ratio = if front { 1.0 / index } else { index };
                let scattered = if ratio * sin > 1.0 {
                    u - normal * (2.0 * u.dot(normal))
                } else {
                    let p = (u + normal * cos) * ratio;
                    p - normal * (1.0 - p.dot(p)).abs().sqrt()
                };
                (Vec3::ONE, scattered)
            }
        }
    }
}
