//! A material ready to scatter: constants hoisted, the convention's arithmetic settled.

use crate::input::material::Material;
use crate::materials::scatter;
use crate::math::real::Real;
use crate::math::vec3::{NEGLIGIBLE, Vec3};
use crate::sampling::scatter_vectors::Scatter;

/// How a surface scatters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BsdfKind {
    /// Around the normal.
    Matte,
    /// Around the mirror image.
    Metal,
    /// Through the surface.
    Refractive,
}

/// A material as the renderer uses it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PreparedMaterial {
    /// How it scatters.
    pub kind: BsdfKind,
    /// What it makes of the stream's triples.
    pub spread: ScatterParams,
    /// `rho`, where a ray leaves.
    pub index: f64,
    /// `1 / rho`, where a ray enters.
    pub inverse_index: f64,
    /// What the scattered ray's colour is multiplied by.
    pub reflectance: Vec3,
}

/// How a surface scatters light around a direction, or how several do.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScatterParams<T = f64> {
    /// A random vector is the stream's next triple times `scale`, plus `shift`.
    pub scale: T,
    /// See `scale`.
    pub shift: T,
    /// A direction whose components are all smaller is replaced by the one it is scattered around (specification,
    /// section 10.1); nothing is smaller where the surface is metal.
    pub negligible: T,
}

impl<T: Real> ScatterParams<T> {
    /// The random vector that the stream's next triple stands for.
    #[inline(always)]
    #[must_use]
    pub fn vector(&self, triple: Vec3<T>) -> Vec3<T> {
        triple * self.scale + Vec3::splat(self.shift)
    }
}

impl ScatterParams {
    /// The direction of a ray scattered around `base` with the stream's next triple.
    #[inline(always)]
    #[must_use]
    pub fn around(&self, base: Vec3, triple: Vec3) -> Vec3 {
        scatter::around(base, self.vector(triple), self.negligible)
    }

    /// The same in every lane.
    #[inline(always)]
    #[must_use]
    pub fn lanes<V: Real>(&self) -> ScatterParams<V> {
        ScatterParams { scale: V::of(self.scale), shift: V::of(self.shift), negligible: V::of(self.negligible) }
    }
}

impl PreparedMaterial {
    /// A surface that sends nothing on.
    pub const BLACK: Self = Self {
        kind: BsdfKind::Metal,
        spread: ScatterParams { scale: 0.0, shift: 0.0, negligible: 0.0 },
        index: 1.0,
        inverse_index: 1.0,
        reflectance: Vec3::ZERO,
    };

    /// Prepares `material` for a convention of random vectors.
    #[must_use]
    pub fn new(material: &Material, scatter: Scatter) -> Self {
        let (kind, extent, index) = match *material {
            Material::Matte { .. } => (BsdfKind::Matte, 1.0, 1.0),
            Material::Metal { diffusion, .. } => (BsdfKind::Metal, diffusion, 1.0),
            Material::Refractive { index } => (BsdfKind::Refractive, 0.0, index),
        };
        let (scale, shift) = match scatter {
            // A draw in [-extent, extent) is u * (extent - -extent) + -extent.
            Scatter::Statement => (extent + extent, -extent),
            // Adding -0 changes no number, not even the sign of a zero.
            Scatter::Published | Scatter::Deterministic => (extent, -0.0),
        };
        let spread = ScatterParams { scale, shift, negligible: if kind == BsdfKind::Matte { NEGLIGIBLE } else { 0.0 } };
        Self { kind, spread, index, inverse_index: 1.0 / index, reflectance: material.reflectance() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn vectors_have_the_conventions_arithmetic() {
        let metal = Material::Metal { reflectance: Vec3::ONE, diffusion: 0.3 };
        let triple = Vec3::new(0.25, 0.0, 0.999);
        let expected = triple.map(|u| u * (0.3 - -0.3) + -0.3);
        let vector = |material, scatter, triple| PreparedMaterial::new(material, scatter).spread.vector(triple);
        assert_eq!(vector(&metal, Scatter::Statement, triple), expected);
        assert_eq!(vector(&metal, Scatter::Published, triple), triple * 0.3);
        let matte = Material::Matte { reflectance: Vec3::ONE };
        assert_eq!(vector(&matte, Scatter::Statement, triple), triple.map(|u| u * 2.0 - 1.0));
        assert_eq!(vector(&matte, Scatter::Published, -triple), -triple);
    }

    #[test]
    fn a_matte_direction_that_is_negligible_is_replaced_and_no_metal_one() {
        let up = Vec3::new(0.0, 1.0, 0.0);
        let matte = PreparedMaterial::new(&Material::Matte { reflectance: Vec3::ONE }, Scatter::Published).spread;
        let metal =
            PreparedMaterial::new(&Material::Metal { reflectance: Vec3::ONE, diffusion: 1.0 }, Scatter::Published)
                .spread;
        for (triple, negligible) in
            [(-up, true), (Vec3::new(9e-9, -1.0, 0.0), true), (Vec3::new(2e-8, -1.0, 0.0), false), (up, false)]
        {
            assert_eq!(matte.around(up, triple), scatter::matte(up, triple));
            assert_eq!(matte.around(up, triple) == up, negligible);
            assert_eq!(metal.around(up, triple), up + triple);
        }
    }

    #[test]
    fn both_ratios_of_a_refractive_material_are_ready() {
        let material_data = PreparedMaterial::new(&Material::Refractive { index: 1.5 }, Scatter::Statement);
        assert_eq!(
            (material_data.kind, material_data.index, material_data.inverse_index),
            (BsdfKind::Refractive, 1.5, 1.0 / 1.5)
        );
        assert_eq!(material_data.reflectance, Vec3::ONE);
    }
}
