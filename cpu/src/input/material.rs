//! What surfaces are made of (specification, section 4.1). How they scatter light is in [`crate::materials`].

use crate::math::vec3::Vec3;

/// The material of an object.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Material {
    /// Scatters around the normal.
    Matte {
        /// Share of the light that comes back, a channel each, in `[0, 1]`.
        reflectance: Vec3,
    },
    /// Scatters around the mirror direction, as widely as the diffusion says.
    Metal {
        /// Share of the light that comes back, a channel each, in `[0, 1]`.
        reflectance: Vec3,
        /// Half the side of the cube of the random vector, at least 0.
        diffusion: f64,
    },
    /// Refracts light.
    Refractive {
        /// Sine of incidence to sine of refraction for light that enters, positive.
        index: f64,
    },
}

impl Material {
    /// The factor of the scattered ray's colour.
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
