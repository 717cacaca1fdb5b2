//! The cases of the intersection of a ray with a sphere.

use cpu::Vec3;
use cpu::internals::geometry::sphere::SphereRecord;
use gpu_check::Float;
use gpu_check::reader::Reader;
use stability::record::Record;
use stability::regimes::SPHERES;

use super::of_regimes;
use super::special::{DIRECTIONS, Row, pairs};

/// Origins of rays, relative to the centre of the sphere, in radii.
const ORIGINS: [[f64; 3]; 20] = [
    [0.0, 0.0, 0.0],  // at the centre
    [0.0, 0.0, -3.0], // outside, before and behind
    [0.0, 0.0, 3.0],
    [0.0, 0.25, 0.5], // inside
    [0.0, 0.0, -1.0], // on the surface
    [1.0, 0.0, 0.0],
    [0.0, -1.0, 0.0],
    [0.6, 0.8, 0.0],
    [0.0, 0.0, -0.999_999_999],
    [0.0, 0.0, -1.001], // a thousandth before the surface, and behind it
    [0.0, 0.0, 1.001],
    [0.0, 0.0, -0.999],
    [1.0, 0.0, -3.0], // tangent, and one unit in the last place inside and outside
    [0.999_999_999_999_999_9, 0.0, -3.0],
    [1.000_000_000_000_000_2, 0.0, -3.0],
    [0.999_999_94, 0.0, -3.0],
    [0.6, -0.8, -5.0],
    [0.0, -0.999_999, -2.0],
    [0.0, 1e6, -1e6],
    [1e-20, 5e-324, -1e150],
];

const CENTERS: [[f64; 3]; 4] = [[0.0; 3], [1.0, -2.0, 0.5], [0.0, -1000.0, 0.0], [1e-40, 1e10, 0.1]];
const RADII: [f64; 9] = [1.0, 2.0, 0.3, 1e-6, 1000.0, 1e9, 1e-40, 1e-160, 1e160];

/// Reads a sphere from a row.
pub fn record<T: Float>(row: &mut Reader<'_, T>) -> Record<T> {
    Record::Sphere(SphereRecord::new(row.vector(), row.number()))
}

/// Returns a ray and a sphere for each case. The random cases, about `count`, are those of all regimes.
pub fn cases(count: usize, seed: u64) -> Vec<f64> {
    let mut rows = Row::default();
    for center in CENTERS.map(Vec3::from) {
        for radius in RADII {
            for origin in ORIGINS {
                for direction in DIRECTIONS {
                    let origin = center + Vec3::from(origin) * radius;
                    rows.vector(origin).vector(direction).vector(center).number(radius);
                }
            }
        }
    }
    for (number, other) in pairs() {
        rows.vector([number, 0.0, -3.0]).vector([other, 0.0, 1.0]).vector([0.0; 3]).number(1.0);
        rows.vector([0.0, 0.0, number]).vector([0.0, 0.0, other]).vector([0.0; 3]).number(1.0);
        rows.vector([0.0, 0.0, -3.0]).vector([0.0, 0.0, 1.0]).vector([number, 0.0, 0.0]).number(other.abs());
    }
    rows.0.extend(of_regimes(&SPHERES, count / SPHERES.len(), seed));
    rows.0
}
