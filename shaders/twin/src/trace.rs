//! The twin of `shaders/wgsl/trace.wgsl` in Rust: a renderer for any number type. `gpu_check::sampled::twin` adds the
//! random numbers. With f32 it gives the bits that the f32 shader must give. With `gpu_check::running::Running` it
//! gives a bound on the difference between f32 and f64 in each pixel.

use cpu::internals::geometry::cylinder::CylinderPart;
use cpu::internals::geometry::ray::front_and_normal;
use cpu::internals::geometry::tie::{is_closer, rank};
use cpu::internals::layout::Placed;
use cpu::internals::materials::{reflection, refraction, scatter};
use cpu::internals::math::real::Real;
use cpu::internals::math::vec3::NEGLIGIBLE;
use cpu::{Ray, Vec3};

use crate::Picture;
use crate::picture::{Kind, PackedMaterial};

/// A point where a ray hits a surface. The twin of `Hit` in `ray.wgsl`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit<T> {
    /// The point of the hit, in scene units.
    pub point: Vec3<T>,
    /// The surface's normal on the side that the ray comes from.
    pub normal: Vec3<T>,
    /// Whether the ray hits the surface from outside the object.
    pub front: bool,
}

impl<T: Real<Mask = bool>> Hit<T> {
    /// Returns the hit at `point` of a ray along `direction`. `outward` is the normal that points out of the object.
    #[must_use]
    pub fn facing(direction: Vec3<T>, point: Vec3<T>, outward: Vec3<T>) -> Self {
        let (front, normal) = front_and_normal(direction, outward);
        Self { point, normal, front }
    }
}

/// The closest hit found so far.
struct ClosestHit<T> {
    lambda: T,
    order: u32,
    surface: Surface,
}

impl<T> ClosestHit<T> {
    fn rank(&self) -> i64 {
        let on_cap = matches!(self.surface, Surface::Cylinder(_, CylinderPart::Top | CylinderPart::Bottom));
        rank(self.order, on_cap)
    }
}

/// The surface that a ray hits first, with the hit.
#[derive(Clone, Copy, Debug)]
pub struct SurfaceHit<T> {
    /// The point and the normal.
    pub hit: Hit<T>,
    /// The index of the object's material.
    pub material: u32,
    /// The distance along the ray, in lengths of its direction.
    pub lambda: T,
    /// The object's index in the scene file.
    pub order: u32,
    /// The number of the part of a cylinder, as in `cylinder.wgsl`; 0 for a sphere.
    pub part: u32,
}

enum Surface {
    Sphere(usize),
    Cylinder(usize, CylinderPart),
}

impl<T: Real<Mask = bool>> Picture<T> {
    /// Returns the linear colour of the pixel at `index`.
    pub fn color(&self, index: usize) -> Vec3<T> {
        let width = self.size.width();
        let [row, column] = [index / width, index % width].map(|number| T::of(number as f64));
        let zero = T::of(0.0);
        self.color_along(self.camera.ray(row, column, [zero; 2]), |_| Vec3::splat(zero))
    }

    /// Returns the linear colour that arrives along the camera ray `ray`. `scatter_vector` returns the next scatter
    /// vector for the extent that it is given.
    pub fn color_along(&self, mut ray: Ray<T>, mut scatter_vector: impl FnMut(T) -> Vec3<T>) -> Vec3<T> {
        let mut attenuations = Vec::new();
        for _ in 0..self.max_depth {
            let Some(surface) = self.closest_hit(&ray) else {
                let color = self.background.color(ray.direction);
                return attenuations.iter().rev().fold(color, |color, reflectance| color.attenuate(*reflectance));
            };
            let material = self.materials[surface.material as usize];
            let mut vector = Vec3::splat(T::of(0.0));
            if material.kind != Kind::Refractive {
                attenuations.push(material.reflectance);
                vector = scatter_vector(material.extent);
            }
            ray = self.scatter_ray(&ray, &surface, vector);
        }
        Vec3::splat(T::of(0.0))
    }

    /// Returns the ray that the surface scatters when `ray` hits it. A refractive surface does not use the scatter
    /// vector `vector`.
    pub fn scatter_ray(&self, ray: &Ray<T>, surface: &SurfaceHit<T>, vector: Vec3<T>) -> Ray<T> {
        scattered(ray, &surface.hit, &self.materials[surface.material as usize], vector)
    }

    /// Returns the closest hit of the ray, found by a loop over all objects, or `None` if the ray escapes.
    pub fn closest_hit(&self, ray: &Ray<T>) -> Option<SurfaceHit<T>> {
        let mut closest = None;
        for (index, Placed { record, file_index, .. }) in self.spheres.iter().enumerate() {
            if let Some(lambda) = record.intersect(ray) {
                update(&mut closest, lambda, *file_index, Surface::Sphere(index));
            }
        }
        for (index, Placed { record, file_index, .. }) in self.cylinders.iter().enumerate() {
            if let Some((lambda, part)) = record.intersect(ray) {
                update(&mut closest, lambda, *file_index, Surface::Cylinder(index, part));
            }
        }
        let ClosestHit { lambda, order, surface } = closest?;
        let point = ray.at(lambda);
        let (outward, material, part) = match surface {
            Surface::Sphere(index) => (self.spheres[index].record.outward(point), self.spheres[index].material, 0),
            Surface::Cylinder(index, part) => {
                (self.cylinders[index].record.outward(part, point), self.cylinders[index].material, part as u32)
            }
        };
        Some(SurfaceHit { hit: Hit::facing(ray.direction, point, outward), material, lambda, order, part })
    }
}

/// The twin of `bounce_ray`: returns the ray that a surface of `material` scatters when `ray` hits it at `hit`.
pub fn scattered<T: Real<Mask = bool>>(
    ray: &Ray<T>,
    hit: &Hit<T>,
    material: &PackedMaterial<T>,
    vector: Vec3<T>,
) -> Ray<T> {
    let direction = match material.kind {
        Kind::Matte => scatter::scatter_around(hit.normal, vector, T::of(NEGLIGIBLE)),
        Kind::Metal => reflection::mirror(ray.direction, hit.normal) + vector,
        Kind::Refractive => {
            // The twin of `scatter_index_ratio`, which divides in the precision T. `PreparedMaterial` of `cpu` divides
            // in f64. If T is f32, that ratio may have other bits.
            let ratio = if hit.front { T::of(1.0) / material.index } else { material.index };
            refraction::refract(ray.direction, hit.normal, ratio)
        }
    };
    Ray { origin: hit.point, direction }
}

/// Replaces the closest hit by the hit at `lambda` if that hit is closer. The objects may come in any order.
fn update<T: Real<Mask = bool>>(closest: &mut Option<ClosestHit<T>>, lambda: T, order: u32, surface: Surface) {
    let hit = ClosestHit { lambda, order, surface };
    if closest.as_ref().is_none_or(|best| is_closer((lambda, hit.rank()), (best.lambda, best.rank()))) {
        *closest = Some(hit);
    }
}
