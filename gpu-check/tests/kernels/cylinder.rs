//! The cases of the intersection of a ray with a cylinder.

use cpu::Vec3;
use cpu::internals::geometry::cylinder::CylinderRecord;
use gpu_check::Float;
use gpu_check::reader::Reader;
use stability::record::Record;
use stability::regimes::CYLINDERS;

use super::of_regimes;
use super::special::{DIRECTIONS, Row, pairs};

/// Origins of rays, relative to an upright cylinder of radius 1 and height 4.
const ORIGINS: [[f64; 3]; 25] = [
    [0.0, 0.0, 0.0],  // at the centre
    [0.0, 0.0, -3.0], // beside, before and behind
    [0.0, 0.0, 3.0],
    [0.0, 5.0, 0.0], // above and below, on the axis
    [0.0, -5.0, 0.0],
    [1.0, 5.0, 0.0], // along the side, on the rim
    [0.6, 5.0, 0.8],
    [1.000_000_000_000_000_2, 5.0, 0.0],
    [1.1, 5.0, 0.0],  // past the rim
    [0.0, 2.0, -3.0], // level with the caps
    [0.0, -2.0, -3.0],
    [0.0, 2.000_000_000_000_000_4, -3.0],
    [0.0, 4.0, -3.0], // rays at 45 degrees hit the rim
    [0.0, -4.0, -3.0],
    [0.0, 4.5, -3.0],
    [0.0, 2.0, 0.5], // on a cap, on the side, on the rim
    [0.0, -2.0, 0.5],
    [1.0, 0.5, 0.0],
    [0.0, 2.0, -1.0],
    [1.0, 0.0, -3.0],           // tangent
    [0.5, 1.0, -0.25],          // inside
    [-0.5, 2.000_000_001, 0.0], // just above a cap, for directions nearly in its plane
    [-0.5, -2.000_000_001, 0.0],
    [0.0, 2.001, 0.25], // a thousandth above a cap
    [1e-20, 1e6, -1e150],
];

const CENTERS: [[f64; 3]; 3] = [[0.0; 3], [1.0, -2.0, 0.5], [1e-40, 1e6, 0.1]];
/// Axes of cylinders. The length of an axis is the height of the cylinder.
const AXES: [[f64; 3]; 10] = [
    [0.0, 4.0, 0.0],
    [0.0, -4.0, 0.0],
    [0.0, 0.002, 0.0], // from the centre, the top cap is exactly at the smallest lambda in range
    [4.0, 0.0, 0.0],
    [0.0, 0.0, 1e-6],
    [1.0, 2.0, -2.0],
    [0.3, 0.1, 0.2],
    [1e9, 1e9, 0.0],
    [1e-40, 0.0, 0.0],
    [0.0, 1e-170, 0.0],
];
const RADII: [f64; 6] = [1.0, 0.3, 1e-6, 1000.0, 1e9, 1e-40];

/// Reads a cylinder from a row.
pub fn record<T: Float>(row: &mut Reader<'_, T>) -> Record<T> {
    let (center, radius, axis) = (row.vector(), row.number(), row.vector());
    Record::Cylinder(CylinderRecord::new(center, radius, axis), axis)
}

/// Returns a ray and a cylinder for each case. The random cases, about `count`, are those of all regimes.
pub fn cases(count: usize, seed: u64) -> Vec<f64> {
    let mut rows = Row::default();
    for center in CENTERS.map(Vec3::from) {
        for radius in RADII {
            for axis in AXES {
                for origin in ORIGINS {
                    for direction in DIRECTIONS {
                        let origin = center + Vec3::from(origin);
                        rows.vector(origin).vector(direction).vector(center).number(radius).vector(axis);
                    }
                }
            }
        }
    }
    for (number, other) in pairs() {
        let axis = [0.0, 4.0, 0.0];
        rows.vector([number, 5.0, 0.0]).vector([other, -1.0, 0.0]).vector([0.0; 3]).number(1.0).vector(axis);
        rows.vector([0.0, 1.0, number]).vector([0.0, 0.5, other]).vector([0.0; 3]).number(1.0).vector(axis);
        let axis = [0.0, other, 0.0];
        rows.vector([0.0, 5.0, -3.0]).vector([0.0, -1.0, 1.0]).vector([0.0; 3]);
        rows.number(number.abs()).vector(axis);
    }
    rows.0.extend(of_regimes(&CYLINDERS, count / CYLINDERS.len(), seed));
    rows.0
}
