//! Materials in the form that the renderer uses: with constants that are computed once.

use crate::geometry::ray::front_and_normal;
use crate::input::material::Material;
use crate::materials::{reflection::mirror, refraction::refract, scatter::ScatterParams};
use crate::math::{real::Real, vec3::NEGLIGIBLE, vec3::Vec3};
use crate::sampling::scatter_vectors::Scatter;

/// The kind of a material, which decides in which direction a surface scatters rays.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BsdfKind {
    /// The surface scatters around the normal.
    Matte,
    /// The surface scatters around the mirror direction.
    Metal,
    /// The surface refracts, or reflects beyond the critical angle. It takes no random vector.
    Refractive,
}

/// A material in the form that the renderer uses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PreparedMaterial {
    /// The kind of the material.
    pub bsdf_kind: BsdfKind,
    /// The constants with which a scatter sample changes the direction.
    pub scatter_params: ScatterParams,
    /// The ratios of refractive indices for a ray that enters the object, and for one that leaves it: the inverse of
    /// the index, and the index. Only refractive materials use them.
    pub index_ratios: [f64; 2],
    /// The factor that the surface applies to the colour of the scattered ray.
    pub reflectance: Vec3,
}

impl PreparedMaterial {
    /// A material that makes every path black.
    pub const BLACK: Self = Self {
        bsdf_kind: BsdfKind::Metal,
        scatter_params: ScatterParams { scale: 0.0, shift: 0.0, negligible: 0.0 },
        index_ratios: [1.0; 2],
        reflectance: Vec3::ZERO,
    };

    /// Prepares `material` for the convention `scatter` of random vectors.
    pub(crate) fn new(material: &Material, scatter: Scatter) -> Self {
        let (bsdf_kind, diffusion, negligible, index) = match *material {
            Material::Matte { .. } => (BsdfKind::Matte, 1.0, NEGLIGIBLE, 1.0),
            Material::Metal { diffusion, .. } => (BsdfKind::Metal, diffusion, 0.0, 1.0),
            Material::Refractive { index } => (BsdfKind::Refractive, 0.0, 0.0, index),
        };
        let (scale, shift) = match scatter {
            // By the specification a draw in [-diffusion, diffusion) is u * (diffusion - -diffusion) + -diffusion.
            Scatter::Statement => (diffusion + diffusion, -diffusion),
            // Adding -0 changes no number, not even the sign of a zero.
            Scatter::Published | Scatter::Deterministic => (diffusion, -0.0),
        };
        let scatter_params = ScatterParams { scale, shift, negligible };
        let index_ratios = [1.0 / index, index];
        Self { bsdf_kind, scatter_params, index_ratios, reflectance: material.reflectance() }
    }

    /// Whether the surface takes a scatter sample: matte and metal surfaces do, refractive ones do not.
    #[inline(always)]
    pub fn takes_scatter_sample(&self) -> bool {
        self.bsdf_kind != BsdfKind::Refractive
    }

    /// Returns the direction of the scattered ray before the random vector is added. This is the normal of a matte
    /// surface, the mirror direction of a metal one, and the refracted direction of a refractive one. `direction` is
    /// that of the ray that hits the surface, and `outward` is the normal that points out of the object.
    #[inline(always)]
    pub fn unperturbed_direction<T: Real>(&self, direction: Vec3<T>, outward: Vec3<T>) -> Vec3<T> {
        match self.bsdf_kind {
            BsdfKind::Matte => front_and_normal(direction, outward).1,
            // A normal and its opposite give the same bits of the mirror image, because both signs cancel.
            BsdfKind::Metal => mirror(direction, outward),
            BsdfKind::Refractive => {
                let (front, normal) = front_and_normal(direction, outward);
                let [entering, leaving] = self.index_ratios;
                refract(direction, normal, T::select(front, T::of(entering), T::of(leaving)))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn vectors_have_the_conventions_arithmetic() {
        let metal = Material::Metal { reflectance: Vec3::ONE, diffusion: 0.3 };
        let sample = Vec3::new(0.25, 0.0, 0.999);
        let expected = sample.map(|u| u * (0.3 - -0.3) + -0.3);
        let vector = |material, scatter, sample| PreparedMaterial::new(material, scatter).scatter_params.vector(sample);
        assert_eq!(vector(&metal, Scatter::Statement, sample), expected);
        assert_eq!(vector(&metal, Scatter::Published, sample), sample * 0.3);
        let matte = Material::Matte { reflectance: Vec3::ONE };
        assert_eq!(vector(&matte, Scatter::Statement, sample), sample.map(|u| u * 2.0 - 1.0));
        assert_eq!(vector(&matte, Scatter::Published, -sample), -sample);
    }

    #[test]
    fn a_matte_direction_that_is_negligible_is_replaced_and_no_metal_one() {
        let up = Vec3::new(0.0, 1.0, 0.0);
        let matte =
            PreparedMaterial::new(&Material::Matte { reflectance: Vec3::ONE }, Scatter::Published).scatter_params;
        let metal =
            PreparedMaterial::new(&Material::Metal { reflectance: Vec3::ONE, diffusion: 1.0 }, Scatter::Published)
                .scatter_params;
        for (sample, negligible) in
            [(-up, true), (Vec3::new(9e-9, -1.0, 0.0), true), (Vec3::new(2e-8, -1.0, 0.0), false), (up, false)]
        {
            assert_eq!(matte.scatter_around(up, sample), if negligible { up } else { up + sample });
            assert_eq!(metal.scatter_around(up, sample), up + sample);
        }
    }

    #[test]
    fn each_kind_of_surface_has_its_direction() {
        let (down, up) = (Vec3::new(3.0, -4.0, 0.0), Vec3::new(0.0, 1.0, 0.0));
        let direction = |material, outward| {
            PreparedMaterial::new(&material, Scatter::Statement).unperturbed_direction(down, outward)
        };
        for outward in [up, -up] {
            assert_eq!(direction(Material::Matte { reflectance: Vec3::ONE }, outward), up);
            let metal = Material::Metal { reflectance: Vec3::ONE, diffusion: 0.5 };
            assert_eq!(direction(metal, outward), Vec3::new(0.6, 0.8, 0.0));
        }
        let refractive = Material::Refractive { index: 1.5 };
        assert_eq!(direction(refractive, up), refract(down, up, 1.0 / 1.5));
        assert_eq!(direction(refractive, -up), refract(down, up, 1.5));
        let metal = Material::Metal { reflectance: Vec3::ONE, diffusion: 0.0 };
        for (material, takes) in
            [(Material::Matte { reflectance: Vec3::ONE }, true), (metal, true), (refractive, false)]
        {
            assert_eq!(PreparedMaterial::new(&material, Scatter::Statement).takes_scatter_sample(), takes);
        }
    }
}
