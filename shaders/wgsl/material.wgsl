// The materials of surfaces; twin of cpu/src/input/material.rs.

// The values of Material.kind, one for each variant of the Rust type.
const MATTE: u32 = 0u;
const METAL: u32 = 1u;
const REFRACTIVE: u32 = 2u;

struct Material {
    // Material::reflectance: the factor for the colour of the scattered ray; 1 in a refractive material.
    reflectance: vec3<real>,
    // The index of a refractive material: the sine of the angle of incidence divided by the sine of the angle of
    // refraction, for light that enters. It is 0 for other materials.
    index: real,
    // The factor of a scatter vector: 1 for a matte material, the diffusion for a metal one, 0 for a refractive one.
    extent: real,
    kind: u32,
}
