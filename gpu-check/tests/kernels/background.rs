//! The colour of a ray that hits no object.

use cpu::internals::math::real::Real;
use cpu::internals::render::background::Background;
use cpu::internals::sampling::uniform::Uniform;
use gpu_check::reader::Reader;

use super::kernel::Formula;
use super::special::{self, DIRECTIONS, NUMBERS, Row};
use super::store;

pub enum Gradient {}

impl Formula for Gradient {
    const MODULE: &'static str = "kernels/background";
    const INPUTS: usize = 9;
    const OUTPUTS: &'static [&'static str] = &["red", "green", "blue"];

    fn evaluate<T: Real<Mask = bool>>(mut case: Reader<'_, T>, result: &mut [T]) {
        let background = Background { dark: case.vector(), light: case.vector() };
        store(background.color(case.vector()), result);
    }

    fn edges(rows: &mut Row) {
        let colors = [[0.0; 3], [1.0; 3], [0.25, 0.5, 1.0], [5e-324, 1e-40, 0.1]];
        for dark in colors {
            for light in colors {
                for direction in DIRECTIONS {
                    rows.vector(dark).vector(light).vector(direction);
                }
                for number in NUMBERS {
                    for other in NUMBERS {
                        rows.vector(dark).vector(light).vector([0.0, number, other]);
                    }
                }
            }
        }
    }

    fn random(draws: &mut Uniform, row: &mut Row) {
        for _ in 0..6 {
            row.number(draws.canonical());
        }
        let size = if special::once_in(draws, 4.0) { special::of_any_size(draws, -18.0, 18.0) } else { 1.0 };
        row.vector(special::direction(draws) * size);
    }
}
