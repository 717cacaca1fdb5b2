//! The surface that a ray meets: its point, its normal, its material.

use crate::layout::Objects;
use crate::ray::{Hit, Ray};
use crate::scene::MaterialId;
use crate::search::Found;

/// The hit that the search has found.
#[inline(always)]
#[must_use]
pub fn surface<O: Objects>(objects: &O, ray: &Ray, found: &Found) -> (Hit, MaterialId) {
    let point = ray.at(found.lambda);
    let (outward, material) = match (found.object as usize).checked_sub(objects.sphere_count()) {
        None => {
            let sphere = objects.sphere(found.object as usize);
            (sphere.record.outward(point), sphere.material)
        }
        Some(index) => {
            let cylinder = objects.cylinder(index);
            (cylinder.record.outward(found.part, point), cylinder.material)
        }
    };
    (Hit::facing(ray.direction, point, outward), material)
}
