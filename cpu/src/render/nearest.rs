//! The nearest hit of a ray over all objects.

use crate::cylinder::Part;
use crate::layout::{Layout, Objects};
use crate::ray::{Hit, Ray};
use crate::scene::MaterialId;

/// The nearest surface so far. Of two at the same lambda, the later object of the file counts.
struct Nearest {
    lambda: f64,
    order: u32,
    surface: Surface,
}

enum Surface {
    Sphere(usize),
    Cylinder(usize, Part),
}

impl Nearest {
    #[inline(always)]
    fn offer(nearest: &mut Option<Self>, lambda: f64, order: u32, surface: impl FnOnce() -> Surface) {
        let closer =
            nearest.as_ref().is_none_or(|best| lambda < best.lambda || (lambda == best.lambda && order > best.order));
        if closer {
            *nearest = Some(Self { lambda, order, surface: surface() });
        }
    }
}

/// Where the ray first meets an object, and of what material.
#[inline(always)]
pub fn nearest<L: Layout>(objects: &L::Objects, ray: &Ray) -> Option<(Hit, MaterialId)> {
    let mut nearest = None;
    for index in 0..objects.sphere_count() {
        let sphere = objects.sphere(index);
        if let Some(lambda) = sphere.record.intersect(ray) {
            Nearest::offer(&mut nearest, lambda, sphere.order, || Surface::Sphere(index));
        }
    }
    for index in 0..objects.cylinder_count() {
        let cylinder = objects.cylinder(index);
        if let Some((lambda, part)) = cylinder.record.intersect(ray) {
            Nearest::offer(&mut nearest, lambda, cylinder.order, || Surface::Cylinder(index, part));
        }
    }
    let Nearest { lambda, surface, .. } = nearest?;
    let point = ray.at(lambda);
    let (outward, material) = match surface {
        Surface::Sphere(index) => {
            let sphere = objects.sphere(index);
            (sphere.record.outward(point), sphere.material)
        }
        Surface::Cylinder(index, part) => {
            let cylinder = objects.cylinder(index);
            (cylinder.record.outward(part, point), cylinder.material)
        }
    };
    Some((Hit::facing(ray.direction, point, outward), material))
}
