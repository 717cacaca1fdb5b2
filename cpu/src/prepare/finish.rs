//! A material ready to scatter: constants hoisted, the convention's arithmetic settled.

use crate::material::Material;
use crate::scatter::{self, Scatter};
use crate::vec3::Vec3;

/// How a surface scatters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Around the normal.
    Matte,
    /// Around the mirror image.
    Metal,
    /// Through the surface.
    Refractive,
}

/// A material as the renderer uses it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Finish {
    /// How it scatters.
    pub kind: Kind,
    /// A random vector is the stream's next triple times `scale`, plus `shift`.
    pub scale: f64,
    /// See `scale`.
    pub shift: f64,
    /// `rho`, where a ray leaves.
    pub index: f64,
    /// `1 / rho`, where a ray enters.
    pub inverse_index: f64,
    /// What the scattered ray's colour is multiplied by.
    pub reflectance: Vec3,
}

impl Finish {
    /// The finish of `material` under a convention.
    #[must_use]
    pub fn new(material: &Material, scatter: Scatter) -> Self {
        let (kind, extent, index) = match *material {
            Material::Matte { .. } => (Kind::Matte, 1.0, 1.0),
            Material::Metal { diffusion, .. } => (Kind::Metal, diffusion, 1.0),
            Material::Refractive { index } => (Kind::Refractive, 0.0, index),
        };
        let (scale, shift) = match scatter {
            // A draw in [-extent, extent) is u * (extent - -extent) + -extent.
            Scatter::Statement => (extent + extent, -extent),
            // Adding -0 changes no number, not even the sign of a zero.
            Scatter::Published | Scatter::Deterministic => (extent, -0.0),
        };
        Self { kind, scale, shift, index, inverse_index: 1.0 / index, reflectance: material.reflectance() }
    }

    /// The direction of a ray scattered around `base` with the stream's next triple.
    #[inline(always)]
    #[must_use]
    pub fn scattered(&self, base: Vec3, triple: Vec3) -> Vec3 {
        let vector = self.vector(triple);
        if self.kind == Kind::Matte { scatter::matte(base, vector) } else { base + vector }
    }

    /// The random vector that the stream's next triple stands for.
    #[inline(always)]
    #[must_use]
    pub fn vector(&self, triple: Vec3) -> Vec3 {
        triple.map(|component| component * self.scale + self.shift)
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
        assert_eq!(Finish::new(&metal, Scatter::Statement).vector(triple), expected);
        assert_eq!(Finish::new(&metal, Scatter::Published).vector(triple), triple * 0.3);
        let matte = Material::Matte { reflectance: Vec3::ONE };
        assert_eq!(Finish::new(&matte, Scatter::Statement).vector(triple), triple.map(|u| u * 2.0 - 1.0));
        assert_eq!(Finish::new(&matte, Scatter::Published).vector(-triple), -triple);
    }

    #[test]
    fn both_ratios_of_a_refractive_material_are_ready() {
        let finish = Finish::new(&Material::Refractive { index: 1.5 }, Scatter::Statement);
        assert_eq!((finish.kind, finish.index, finish.inverse_index), (Kind::Refractive, 1.5, 1.0 / 1.5));
        assert_eq!(finish.reflectance, Vec3::ONE);
    }
}
