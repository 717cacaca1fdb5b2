//! The materials of a scene file (specification, section 4.1). [`crate::materials`] computes how they scatter light.

use crate::math::vec3::Vec3;

/// The material of an object.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Material {
    /// A matte surface, which scatters light around the normal.
    Matte {
        /// The share of the light that is scattered, for each channel, in `[0, 1]`.
        reflectance: Vec3,
    },
    /// A metal surface, which scatters light around the mirror direction.
    Metal {
        /// The share of the light that is scattered, for each channel, in `[0, 1]`.
        reflectance: Vec3,
        /// The size of the random vector that is added to the mirror direction, at least 0. Each component of the
        /// vector has at most this magnitude.
        diffusion: f64,
    },
    /// A refractive surface, which refracts all light.
    Refractive {
        /// The refractive index, positive. For light that enters the object, it is the sine of the angle of incidence
        /// divided by the sine of the angle of refraction.
        index: f64,
    },
}

impl Material {
    /// Returns the factor that the surface applies to the colour of the scattered ray. It is one for a refractive
    /// surface.
    pub const fn reflectance(&self) -> Vec3 {
        match *self {
            Self::Matte { reflectance } | Self::Metal { reflectance, .. } => reflectance,
            Self::Refractive { .. } => Vec3::ONE,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn refractive_surfaces_attenuate_nothing() {
        let reflectance = Vec3::new(0.1, 0.2, 0.3);
        assert_eq!(Material::Matte { reflectance }.reflectance(), reflectance);
        assert_eq!(Material::Metal { reflectance, diffusion: 1.0 }.reflectance(), reflectance);
        assert_eq!(Material::Refractive { index: 1.5 }.reflectance(), Vec3::ONE);
    }
}
