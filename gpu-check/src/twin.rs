//! The renderer of `shaders/wgsl/trace.wgsl`, once more in Rust over any number: its f32 twin gives the bits that the
//! f32 port must give, and over [`crate::running::Running`] it tells how far f32 may be from f64 in each pixel.
//!
//! The formulas are those of `cpu`; `cpu::reference`, which has its own, is what f64 is held against.

use cpu::internals::Hit;
use cpu::internals::geometry::cylinder::CylinderPart;
use cpu::internals::layout::Placed;
use cpu::internals::materials::scatter;
use cpu::internals::math::real::Real;
use cpu::{Ray, Vec3};

use crate::Picture;
use crate::picture::Kind;

/// The closest surface so far. Of two at the same lambda, the later object of the file counts.
struct ClosestHit<T> {
    lambda: T,
    order: u32,
    surface: Surface,
}

/// The surface that a ray meets first.
pub(crate) struct SurfaceHit<T> {
    pub(crate) hit: Hit<T>,
    pub(crate) material: u32,
    pub(crate) lambda: T,
    /// The object's place in the file.
    pub(crate) order: u32,
    /// The part of a cylinder, as `cylinder.wgsl` numbers them; zero on a sphere.
    pub(crate) part: u32,
}

enum Surface {
    Sphere(usize),
    Cylinder(usize, CylinderPart),
}

impl<T: Real<Mask = bool>> Picture<T> {
    /// The linear colour of the pixel at `index`.
    #[must_use]
    pub fn color(&self, index: usize) -> Vec3<T> {
        let width = self.size.width();
        let [row, column] = [index / width, index % width].map(|number| T::of(number as f64));
        let mut ray = self.camera.ray(row, column, [T::of(0.0); 2]);
        let mut attenuations = Vec::new();
        for _ in 0..self.max_depth {
            let Some(surface) = self.closest_hit(&ray) else {
                let color = self.background.color(ray.direction);
                return attenuations.iter().rev().fold(color, |color, reflectance| color.attenuate(*reflectance));
            };
            let material = self.materials[surface.material as usize];
            if material.kind != Kind::Refractive {
                attenuations.push(material.reflectance);
            }
            ray = self.scatter_ray(&ray, &surface);
        }
        Vec3::splat(T::of(0.0))
    }

    /// The ray that the surface scatters.
    pub(crate) fn scatter_ray(&self, ray: &Ray<T>, surface: &SurfaceHit<T>) -> Ray<T> {
        let material = self.materials[surface.material as usize];
        let (hit, vector) = (surface.hit, Vec3::splat(T::of(0.0)));
        let direction = match material.kind {
            Kind::Matte => scatter::matte(hit.normal, vector),
            Kind::Metal => scatter::metal(ray.direction, hit.normal, vector),
            Kind::Refractive => {
                let ratio = if hit.front { T::of(1.0) / material.index } else { material.index };
                scatter::refract(ray.direction, hit.normal, ratio)
            }
        };
        Ray { origin: hit.point, direction }
    }

    /// Where the ray first meets an object, and of what material.
    pub(crate) fn closest_hit(&self, ray: &Ray<T>) -> Option<SurfaceHit<T>> {
        let mut closest = None;
        for (index, Placed { record, order, .. }) in self.spheres.iter().enumerate() {
            if let Some(lambda) = record.intersect(ray) {
                update(&mut closest, lambda, *order, Surface::Sphere(index));
            }
        }
        for (index, Placed { record, order, .. }) in self.cylinders.iter().enumerate() {
            if let Some((lambda, part)) = record.intersect(ray) {
                update(&mut closest, lambda, *order, Surface::Cylinder(index, part));
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

fn update<T: Real<Mask = bool>>(closest: &mut Option<ClosestHit<T>>, lambda: T, order: u32, surface: Surface) {
    let closer = closest
        .as_ref()
        .is_none_or(|best| lambda.less(best.lambda) || (!best.lambda.less(lambda) && order > best.order));
    if closer {
        *closest = Some(ClosestHit { lambda, order, surface });
    }
}
