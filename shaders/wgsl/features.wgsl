// The features that a scene needs. The values are set when a pipeline is compiled, so that it has no code for the
// features that are off.

// Whether any object is a sphere.
override has_spheres: bool = true;
// Whether any object is a cylinder.
override has_cylinders: bool = true;
// Whether any object has a matte material.
override has_matte: bool = true;
// Whether any object has a metal material.
override has_metal: bool = true;
// Whether any object has a refractive material.
override has_refraction: bool = true;
// Config::max_depth: how many rays a sample may send. If the last of them hits an object, the sample is black.
override max_depth: u32 = 5u;
