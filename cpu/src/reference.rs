//! The renderer by the definition: docs/specification.md line by line, slow and plain for good.
//!
//! A loop over all objects in the order of the file, for every ray. It shares no formula with the real
//! renderer, only the vector arithmetic, the random numbers, the camera's window and the definition of a byte, so that
//! each of the two tells when the other is wrong. Every fast path must give its bytes.
//!
//! Uses `math`, `input`, `geometry`, `exact`, `sampling` and `image`. Begin here: this is the specification as a
//! program.
//!
//! With [`Exact`] intersections it shares those with the real renderer, and calls them for every object in turn.
//! With [`Plain`] ones it has formulas of its own.

pub mod intersect;
mod nearest;

pub use crate::reference::intersect::{Exact, Intersect, Plain, Precision};

use std::marker::PhantomData;

use crate::geometry::camera::Camera;
use crate::geometry::ray::Ray;
use crate::image::quantize::quantize;
use crate::image::{Image, Rgb};
use crate::input::config::Config;
use crate::input::error::Error;
use crate::input::material::Material;
use crate::input::scene::{Scene, Shape};
use crate::math::vec3::Vec3;
use crate::reference::nearest::{
    Nearest, meets_certified_cylinder, meets_certified_sphere, meets_cylinder, meets_sphere,
};
use crate::sampling::scatter_vectors::{Scatter, ScatterVectors};
use crate::sampling::uniform::Uniform;

/// Renders by the definition, with the textbook's intersections.
///
/// # Errors
/// [`Error::Picture`] when the configuration makes no picture, [`Error::OutOfMemory`] when it does not fit.
pub fn render<I: Image>(config: &Config, scene: &Scene, scatter: Scatter) -> Result<I, Error> {
    render_with::<I, Plain>(config, scene, scatter)
}

/// Renders by the definition, with the intersections of `P`.
///
/// # Errors
/// As [`render`].
pub fn render_with<I: Image, P: Intersect>(config: &Config, scene: &Scene, scatter: Scatter) -> Result<I, Error> {
    let size = config.image_size()?;
    let mut image = I::black(size)?;
    render_linear_with::<P>(config, scene, scatter, |index, mean| {
        let [red, green, blue] = mean.to_array().map(|channel| quantize(channel, config.gamma));
        image.set_pixel(index, Rgb { red, green, blue });
    })?;
    Ok(image)
}

/// Renders by the definition, with the textbook's intersections, and hands every pixel's mean, before it becomes
/// bytes, to `pixel` with its index.
///
/// # Errors
/// [`Error::Picture`] when the configuration makes no picture, [`Error::OutOfMemory`] when a path does not fit.
pub fn render_linear(
    config: &Config,
    scene: &Scene,
    scatter: Scatter,
    pixel: impl FnMut(usize, Vec3),
) -> Result<(), Error> {
    render_linear_with::<Plain>(config, scene, scatter, pixel)
}

/// As [`render_linear`], with the intersections of `P`.
///
/// # Errors
/// [`Error::Picture`] when the configuration makes no picture, [`Error::OutOfMemory`] when a path does not fit.
pub fn render_linear_with<P: Intersect>(
    config: &Config,
    scene: &Scene,
    scatter: Scatter,
    pixel: impl FnMut(usize, Vec3),
) -> Result<(), Error> {
    render_counted::<P>(config, scene, scatter, pixel).map(|_| ())
}

/// How much a picture takes, whoever renders it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Rays for which the nearest object was sought.
    pub rays: u64,
    /// Those of them that met one.
    pub hits: u64,
}

/// [`render_linear`], and the rays and hits that the picture takes.
///
/// # Errors
/// [`Error::Picture`] when the configuration makes no picture, [`Error::OutOfMemory`] when a path does not fit.
pub fn render_counted<P: Intersect>(
    config: &Config,
    scene: &Scene,
    scatter: Scatter,
    mut pixel: impl FnMut(usize, Vec3),
) -> Result<Counts, Error> {
    let size = config.image_size()?;
    let camera = Camera::new(config, size)?;
    let deterministic = scatter == Scatter::Deterministic;
    let samples = if deterministic { 1 } else { config.samples_per_pixel };
    let mut offsets = Uniform::new(config.ray_rng_seed);
    let vectors = ScatterVectors::new(scatter, config.material_rng_seed);
    let mut path = Path::<P> {
        config,
        scene,
        vectors,
        reflectances: Vec::new(),
        counts: Counts::default(),
        intersect: PhantomData,
    };
    for row in 0..size.height() {
        for column in 0..size.width() {
            let mut sum = Vec3::ZERO;
            for _ in 0..samples {
                let (mut x, mut y) = (0.0, 0.0);
                if !deterministic {
                    x = offsets.draw(-0.5, 0.5);
                    y = offsets.draw(-0.5, 0.5);
                }
                let target = camera.origin + camera.delta_x * (column as f64 + x) + camera.delta_y * (row as f64 + y);
                sum = sum + path.color(camera.position, target - camera.position, config.max_depth)?;
            }
            pixel(row * size.width() + column, sum / samples as f64);
        }
    }
    Ok(path.counts)
}

/// What all rays of a picture share.
struct Path<'a, P> {
    config: &'a Config,
    scene: &'a Scene,
    vectors: ScatterVectors,
    /// Reflectances met by the ray being followed, first hit first. Empty between rays.
    reflectances: Vec<Vec3>,
    intersect: PhantomData<P>,
    counts: Counts,
}

impl<P: Intersect> Path<'_, P> {
    /// The colour that arrives along a ray: the recursion (specification, section 8.1), unrolled so that no depth
    /// overflows the stack.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`]: a ray between mirrors meets as many surfaces as it may, and that may be 2^64.
    fn color(&mut self, mut origin: Vec3, mut direction: Vec3, max_depth: u64) -> Result<Vec3, Error> {
        let mut reflectances = std::mem::take(&mut self.reflectances);
        let mut color = Vec3::ZERO;
        for _ in 0..max_depth {
            self.counts.rays += 1;
            let Some((nearest, material)) = self.nearest(origin, direction) else {
                color = self.background(direction);
                break;
            };
            self.counts.hits += 1;
            let front = direction.dot(nearest.outward) < 0.0;
            let normal = if front { nearest.outward } else { -nearest.outward };
            let (reflectance, scattered) = self.scatter(material, direction, normal, front);
            reflectances.try_reserve(1).map_err(|_| Error::OutOfMemory { what: "the surfaces that a ray meets" })?;
            reflectances.push(reflectance);
            (origin, direction) = (nearest.point, scattered);
        }
        // From the last hit back to the first, as the recursion returns.
        for reflectance in reflectances.drain(..).rev() {
            color = color.attenuate(reflectance);
        }
        self.reflectances = reflectances;
        Ok(color)
    }

    /// The nearest hit over all objects, in the order of the file, and what is hit.
    fn nearest(&self, origin: Vec3, direction: Vec3) -> Option<(Nearest, Material)> {
        let mut nearest = Nearest { lambda: f64::INFINITY, point: Vec3::ZERO, outward: Vec3::ZERO };
        let mut hit = None;
        for object in &self.scene.objects {
            let nearest = &mut nearest;
            let met = match (P::PRECISION, &object.shape) {
                (Precision::Plain, Shape::Sphere(sphere)) => meets_sphere(sphere, origin, direction, nearest),
                (Precision::Plain, Shape::Cylinder(cylinder)) => meets_cylinder(cylinder, origin, direction, nearest),
                (Precision::Exact, Shape::Sphere(sphere)) => {
                    meets_certified_sphere::<P>(sphere, Ray { origin, direction }, nearest)
                }
                (Precision::Exact, Shape::Cylinder(cylinder)) => {
                    meets_certified_cylinder::<P>(cylinder, Ray { origin, direction }, nearest)
                }
            };
            if met {
                hit = Some(object.material);
            }
        }
        Some((nearest, self.scene.materials[hit? as usize]))
    }

    fn background(&self, direction: Vec3) -> Vec3 {
        let m = (direction.unit().y + 1.0) / 2.0;
        self.config.background_light_color * (1.0 - m) + self.config.background_dark_color * m
    }

    /// The reflectance of a hit and the direction in which it sends light.
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
