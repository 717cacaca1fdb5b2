//! The camera ray of a pixel.

use cpu::internals::geometry::camera::Camera;
use cpu::internals::math::real::Real;
use cpu::internals::sampling::uniform::Uniform;
use cpu::{Config, Vec3};
use gpu_check::reader::Reader;

use super::kernel::Formula;
use super::special::{self, NUMBERS, Row};
use super::store;

pub enum CameraRay {}

impl Formula for CameraRay {
    const MODULE: &'static str = "kernels/camera";
    const INPUTS: usize = 16;
    const OUTPUTS: &'static [&'static str] =
        &["origin.x", "origin.y", "origin.z", "direction.x", "direction.y", "direction.z"];

    fn evaluate<T: Real<Mask = bool>>(mut case: Reader<'_, T>, result: &mut [T]) {
        let (position, origin) = (case.vector(), case.vector());
        let camera = Camera { position, origin, delta_x: case.vector(), delta_y: case.vector() };
        let (row, column) = (case.number(), case.number());
        let ray = camera.ray(row, column, [case.number(), case.number()]);
        store(ray.origin, result);
        store(ray.direction, &mut result[3..]);
    }

    fn edges(rows: &mut Row) {
        for number in NUMBERS {
            for other in NUMBERS {
                for place in [[0.0, 0.0, -0.5, -0.5], [0.0, 1e9, 0.0, 0.5], [16_777_217.0, 3.0, 0.25, -0.0]] {
                    rows.vector([number, 1.0, -10.0]).vector([other, -5.0, number]);
                    rows.vector([other, 0.0, 1e-9]).vector([-0.0, number, 0.0]);
                    rows.0.extend(place);
                }
            }
        }
    }

    fn random(draws: &mut Uniform, row: &mut Row) {
        let width = draws.draw(1.0, 4096.0).floor();
        let config = Config {
            image_width: width as u64,
            camera_position: special::in_cube(draws, 20.0),
            camera_target: special::in_cube(draws, 2.0),
            camera_north: special::direction(draws),
            field_of_view: draws.draw(1.0, 179.0),
            ..Config::default()
        };
        let size = config.image_size().expect("the width is small");
        // If the random north is parallel to the view, which is very rare, there is no window. Then any camera can be
        // used.
        let camera = Camera::new(&config, size).unwrap_or(Camera {
            position: Vec3::ZERO,
            origin: Vec3::ONE,
            delta_x: Vec3::ONE,
            delta_y: Vec3::ONE,
        });
        row.vector(camera.position).vector(camera.origin).vector(camera.delta_x).vector(camera.delta_y);
        row.number(draws.draw(0.0, size.height() as f64).floor()).number(draws.draw(0.0, width).floor());
        let middle = special::once_in(draws, 4.0);
        for _ in 0..2 {
            row.number(if middle { 0.0 } else { draws.draw(-0.5, 0.5) });
        }
    }
}
