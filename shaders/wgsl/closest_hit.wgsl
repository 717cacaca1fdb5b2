// The surface that a ray hits first, found by a loop over all objects. In scenes of many objects hierarchy.wgsl stands
// in for this module.

// Returns the surface at the closest hit of the ray, if there is one.
fn closest_hit(ray: Ray) -> SurfaceHit {
    return surface_at(intersect_every_object(ray), ray);
}
