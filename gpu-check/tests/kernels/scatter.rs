//! The directions in which surfaces scatter rays: matte, reflection, metal and refraction.

use cpu::Vec3;
use cpu::internals::materials::{reflection, refraction, scatter};
use cpu::internals::math::real::Real;
use cpu::internals::math::vec3::NEGLIGIBLE;
use cpu::internals::sampling::uniform::Uniform;
use gpu_check::reader::Reader;

use super::kernel::Formula;
use super::special::{self, DIRECTIONS, NUMBERS, Row};
use super::store;

pub enum Matte {}
pub enum Reflection {}
pub enum Metal {}
pub enum Refraction {}

const VECTOR: &[&str] = &["x", "y", "z"];

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
fn normal(draws: &mut Uniform) -> Vec3 {
    let length = if special::once_in(draws, 3.0) { special::of_any_size(draws, -3.0, 3.0).abs() } else { 1.0 };
    special::direction(draws) * length
}

impl Formula for Matte {
    const MODULE: &'static str = "kernels/matte";
    const INPUTS: usize = 6;
    const OUTPUTS: &'static [&'static str] = VECTOR;

    fn evaluate<T: Real<Mask = bool>>(mut case: Reader<'_, T>, result: &mut [T]) {
        store(scatter::scatter_around(case.vector(), case.vector(), T::of(NEGLIGIBLE)), result);
    }

    fn edges(rows: &mut Row) {
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
    }

    fn random(draws: &mut Uniform, row: &mut Row) {
        let normal = normal(draws);
        let mut vector = special::in_cube(draws, 1.0);
        if special::once_in(draws, 4.0) {
            let size = special::of_any_size(draws, -10.0, -6.0);
            vector = special::in_cube(draws, size) - normal;
        }
        row.vector(normal).vector(vector);
    }
}

impl Formula for Reflection {
    const MODULE: &'static str = "kernels/reflection";
    const INPUTS: usize = 6;
    const OUTPUTS: &'static [&'static str] = VECTOR;

    fn evaluate<T: Real<Mask = bool>>(mut case: Reader<'_, T>, result: &mut [T]) {
        store(reflection::reflect(case.vector(), case.vector()), result);
    }

    fn edges(rows: &mut Row) {
        for normal in NORMALS {
            for direction in DIRECTIONS {
                rows.vector(direction).vector(normal);
            }
        }
        for number in NUMBERS {
            for other in NUMBERS {
                rows.vector([number, -1.0, 0.0]).vector([0.0, other, 0.0]);
            }
        }
    }

    fn random(draws: &mut Uniform, row: &mut Row) {
        let size = special::of_any_size(draws, -6.0, 6.0);
        row.vector(special::direction(draws) * size).vector(normal(draws));
    }
}

impl Formula for Metal {
    const MODULE: &'static str = "kernels/metal";
    const INPUTS: usize = 9;
    const OUTPUTS: &'static [&'static str] = VECTOR;

    fn evaluate<T: Real<Mask = bool>>(mut case: Reader<'_, T>, result: &mut [T]) {
        store(reflection::mirror(case.vector(), case.vector()) + case.vector(), result);
    }

    fn edges(rows: &mut Row) {
        for normal in NORMALS {
            for direction in DIRECTIONS {
                for vector in [[0.0; 3], [-0.0; 3], [0.1, -0.2, 0.3], [1e-8, 0.0, 1e9]] {
                    rows.vector(direction).vector(normal).vector(vector);
                }
            }
        }
    }

    fn random(draws: &mut Uniform, row: &mut Row) {
        let size = special::of_any_size(draws, -6.0, 6.0);
        let diffusion = if special::once_in(draws, 4.0) { 0.0 } else { draws.canonical() };
        row.vector(special::direction(draws) * size).vector(normal(draws));
        row.vector(special::in_cube(draws, 1.0) * diffusion);
    }
}

impl Formula for Refraction {
    const MODULE: &'static str = "kernels/refraction";
    const INPUTS: usize = 7;
    const OUTPUTS: &'static [&'static str] = VECTOR;

    fn evaluate<T: Real<Mask = bool>>(mut case: Reader<'_, T>, result: &mut [T]) {
        store(refraction::refract(case.vector(), case.vector(), case.number()), result);
    }

    fn edges(rows: &mut Row) {
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
    }

    fn random(draws: &mut Uniform, row: &mut Row) {
        let normal = normal(draws);
        let direction = special::direction(draws);
        let mut ratio = if special::once_in(draws, 2.0) { draws.draw(1.0, 3.0) } else { draws.draw(0.3, 1.0) };
        if special::once_in(draws, 3.0) {
            // The case is near the critical angle.
            let cosine = direction.dot(normal);
            let sine = (1.0 - cosine * cosine).max(1e-6).sqrt();
            ratio = (1.0 / sine) * (1.0 + special::of_any_size(draws, -17.0, -3.0));
        }
        let size = special::of_any_size(draws, -3.0, 3.0).abs();
        row.vector(direction * size).vector(normal).number(ratio);
    }
}
