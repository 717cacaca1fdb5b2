// What surfaces are made of; twin of cpu/src/input/material.rs.

// Material: `kind` tells the variant.
const MATTE: u32 = 0u;
const METAL: u32 = 1u;
const REFRACTIVE: u32 = 2u;

struct Material {
    // Material::reflectance: what the colour of the scattered ray is multiplied by; one in a refractive material.
    reflectance: vec3<real>,
    // Of a refractive material: sine of incidence to sine of refraction for light that enters.
    index: real,
    kind: u32,
}
