//! One sample's way through the scene.

use super::nearest::nearest;
use crate::layout::Layout;
use crate::material::Material;
use crate::prepare::Prepared;
use crate::ray::Ray;
use crate::scatter::{self, ScatterVectors};
use crate::scene::MaterialId;
use crate::vec3::Vec3;

/// Follows rays, one after the other; holds what they share.
pub struct Path<'a, L: Layout> {
    prepared: &'a Prepared<L>,
    vectors: ScatterVectors,
    /// Materials met by the ray being followed, first hit first.
    met: Vec<MaterialId>,
}

impl<'a, L: Layout> Path<'a, L> {
    pub fn new(prepared: &'a Prepared<L>) -> Self {
        Self { prepared, vectors: ScatterVectors::new(prepared.scatter, prepared.material_seed), met: Vec::new() }
    }

    /// The colour that arrives along `ray`.
    pub fn color(&mut self, mut ray: Ray) -> Vec3 {
        self.met.clear();
        for _ in 0..self.prepared.max_depth {
            let Some((hit, id)) = nearest::<L>(&self.prepared.objects, &ray) else {
                let color = self.prepared.background.color(ray.direction);
                return self.attenuated(color);
            };
            let direction = match self.prepared.materials[id as usize] {
                Material::Matte { .. } => {
                    self.met.push(id);
                    scatter::matte(hit.normal, self.vectors.next(1.0))
                }
                Material::Metal { diffusion, .. } => {
                    self.met.push(id);
                    scatter::metal(ray.direction, hit.normal, self.vectors.next(diffusion))
                }
                Material::Refractive { index } => {
                    let ratio = if hit.front { 1.0 / index } else { index };
                    scatter::refract(ray.direction, hit.normal, ratio)
                }
            };
            ray = Ray { origin: hit.point, direction };
        }
        Vec3::ZERO
    }

    /// `color` after all surfaces met, from the last to the first, in the order in which the recursion returns.
    fn attenuated(&self, color: Vec3) -> Vec3 {
        let reflectance = |id: &MaterialId| self.prepared.materials[*id as usize].reflectance();
        self.met.iter().rev().map(reflectance).fold(color, Vec3::attenuate)
    }
}
