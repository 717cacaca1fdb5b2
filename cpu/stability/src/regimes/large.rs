//! Secondary rays on spheres of a given radius, to find the largest radius that a ground may have.

use cpu::Vec3;

use crate::case::Case;
use crate::random::Random;

/// Returns `count` random rays that leave a sphere of this radius, outwards or inwards. They start near the origin of
/// coordinates, through which the sphere's surface passes.
#[must_use]
pub fn cases(radius: f64, seed: u64, count: usize) -> Vec<Case> {
    let mut random = Random::new(seed);
    let center = Vec3::new(0.0, -radius, 0.0);
    let mut draw = || {
        let extent = radius.min(10.0) * 0.5;
        let (x, z) = (random.uniform(-extent, extent), random.uniform(-extent, extent));
        let across = x * x + z * z;
        // Equals sqrt(r^2 - across) - r, but nothing cancels.
        let y = -across / (radius + (radius * radius - across).sqrt());
        let origin = Vec3::new(x, y, z);
        let outward = (origin - center) / radius;
        let direction = outward * random.sign() + random.cube(1.0);
        Case::sphere(center, radius, origin, direction)
    };
    (0..count).map(|_| draw()).collect()
}
