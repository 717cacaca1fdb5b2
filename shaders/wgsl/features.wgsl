// What a scene needs, decided once for a pipeline: a pipeline specialised to its scene has no code for the rest.

// Whether any object is a sphere.
override has_spheres: bool = true;
// Whether any object is a cylinder.
override has_cylinders: bool = true;
// Whether any object is of a matte material.
override has_matte: bool = true;
// Whether any object is of a metal.
override has_metal: bool = true;
// Whether any object is of a refractive material.
override has_refraction: bool = true;
// Config::max_depth: the most surfaces that a ray may meet.
override max_depth: u32 = 5u;
