//! The cases of the directions in which surfaces scatter rays: matte, reflection, metal and refraction.

use cpu::Vec3;
use stability::random::Random;

use super::special::{DIRECTIONS, Row, any_size, direction, once_in, pairs, rows};

/// Normals for edge cases: of length 1, of the length of a cylinder's radius, tiny ones and huge ones.
const NORMALS: [[f64; 3]; 10] = [
    [0.0, 1.0, 0.0],
    [0.0, -1.0, 0.0],
    [0.0, 0.0, -1.0],
    [0.6, 0.8, 0.0],
    [-0.577_350_269_189_625_7, 0.577_350_269_189_625_7, 0.577_350_269_189_625_7],
    [0.0, 0.3, -0.4],
    [250.0, 0.0, 1000.0],
    [1e-40, 0.0, 0.0],
    [0.0, 5e-324, 0.0],
    [0.0, 1e160, 0.0],
];

/// Returns a random normal. Its length is 1, or any length, as on the side of a cylinder.
fn normal(random: &mut Random) -> Vec3 {
    let length = if once_in(random, 3.0) { any_size(random, -3.0, 3.0).abs() } else { 1.0 };
    direction(random) * length
}

/// Returns a normal and a vector for each case.
pub fn matte(count: usize, seed: u64) -> Vec<f64> {
    let edges = |rows: &mut Row| {
        for normal in NORMALS.map(Vec3::from) {
            for vector in DIRECTIONS.into_iter().chain(NORMALS) {
                rows.vector(normal).vector(vector);
            }
            // Sums of the normal and the random vector just below and above 1e-8 in each component. Below 1e-8, the
            // scattered direction is the normal.
            for limit in [1e-8, 1e-8_f64.next_down(), 1e-8_f64.next_up(), 9e-9, 2e-8] {
                for sign in [1.0, -1.0] {
                    for axis in 0..3 {
                        let mut rest = [0.0; 3];
                        rest[axis] = limit * sign;
                        rows.vector(normal).vector(-normal + rest.into());
                        rows.vector([0.0; 3]).vector(rest);
                    }
                }
            }
        }
    };
    rows(count, seed, edges, |random, row| {
        let normal = normal(random);
        let mut vector = random.cube(1.0);
        if once_in(random, 4.0) {
            let size = any_size(random, -10.0, -6.0);
            vector = random.cube(size) - normal;
        }
        row.vector(normal).vector(vector);
    })
}

/// Returns a direction and a normal for each case.
pub fn reflection(count: usize, seed: u64) -> Vec<f64> {
    let edges = |rows: &mut Row| {
        for normal in NORMALS {
            for direction in DIRECTIONS {
                rows.vector(direction).vector(normal);
            }
        }
        for (number, other) in pairs() {
            rows.vector([number, -1.0, 0.0]).vector([0.0, other, 0.0]);
        }
    };
    rows(count, seed, edges, |random, row| {
        let size = any_size(random, -6.0, 6.0);
        row.vector(direction(random) * size).vector(normal(random));
    })
}

/// Returns a direction, a normal and a vector for each case.
pub fn metal(count: usize, seed: u64) -> Vec<f64> {
    let edges = |rows: &mut Row| {
        for normal in NORMALS {
            for direction in DIRECTIONS {
                for vector in [[0.0; 3], [-0.0; 3], [0.1, -0.2, 0.3], [1e-8, 0.0, 1e9]] {
                    rows.vector(direction).vector(normal).vector(vector);
                }
            }
        }
    };
    rows(count, seed, edges, |random, row| {
        let size = any_size(random, -6.0, 6.0);
        let diffusion = if once_in(random, 4.0) { 0.0 } else { random.uniform(0.0, 1.0) };
        row.vector(direction(random) * size).vector(normal(random));
        row.vector(random.cube(1.0) * diffusion);
    })
}

/// Returns a direction, a normal and a ratio of indices for each case.
pub fn refraction(count: usize, seed: u64) -> Vec<f64> {
    let edges = |rows: &mut Row| {
        let ratios = [1.0, 1.5, 1.0 / 1.5, 0.5, 2.0, 1e-9, 1e9, 5e-324, 1e-40];
        for normal in NORMALS {
            for direction in DIRECTIONS {
                for ratio in ratios {
                    rows.vector(direction).vector(normal).number(ratio);
                }
            }
        }
        // Cases around the critical angle: the sine of the angle of incidence is within a few units in the last place
        // of 1 / ratio.
        for (x, y) in [(3.0, -4.0), (4.0, -3.0), (5.0, -12.0), (1.0, -1.0), (1.0, 0.0)] {
            let sine = x / f64::hypot(x, y);
            let mut ratio = 1.0 / sine;
            for _ in 0..4 {
                ratio = ratio.next_down();
            }
            for _ in 0..9 {
                rows.vector([x, y, 0.0]).vector([0.0, 1.0, 0.0]).number(ratio);
                rows.vector([x, y, 0.0]).vector([0.0, 1.0, 0.0]).number(f64::from((ratio as f32).next_up()));
                rows.vector([x, y, 0.0]).vector([0.0, 1.0, 0.0]).number(f64::from((ratio as f32).next_down()));
                ratio = ratio.next_up();
            }
        }
    };
    rows(count, seed, edges, |random, row| {
        let normal = normal(random);
        let direction = direction(random);
        let mut ratio = if once_in(random, 2.0) { random.uniform(1.0, 3.0) } else { random.uniform(0.3, 1.0) };
        if once_in(random, 3.0) {
            // The case is near the critical angle.
            let cosine = direction.dot(normal);
            let sine = (1.0 - cosine * cosine).max(1e-6).sqrt();
            ratio = (1.0 / sine) * (1.0 + any_size(random, -17.0, -3.0));
        }
        let size = any_size(random, -3.0, 3.0).abs();
        row.vector(direction * size).vector(normal).number(ratio);
    })
}
