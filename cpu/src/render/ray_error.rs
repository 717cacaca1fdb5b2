//! The rounding error of camera rays. Culling and background pixels argue about exact camera rays, so their margins
//! contain this error.
//!
//! Take `O`, `P`, `dx` and `dy` as exact. The camera ray through a point of the picture has the direction
//! `d = (O - P) + dx (c + x) + dy (f + y)`, and `d^` is the direction that [`Camera::ray`] computes. The point
//! `O + dx (c + x) + dy (f + y)` is rounded to the spacing of numbers near the camera's *position*, however near the
//! window is. Let `W` and `H` be the picture's width and height in pixels, and `u = 2^-53`. With
//! `s = |O - P| + W |dx| + H |dy|` the error `|d^ - d|` is at most `5 u (|P| + s)` (`cpu/stability/src/proof/camera.rs`
//! proves it from the formula). The code uses [`ROUNDINGS`] `= 8` instead of 5, which also covers the roundings of the
//! bound itself.
//!
//! Let `D` be the distance of `P` from the plane of the window. No direction `d` is shorter than `D`, and no computed
//! direction is shorter than `D - |d^ - d|`. So rounding turns a camera ray by an angle whose sine is at most
//! `|d^ - d| / (D - |d^ - d|)`. This is also a bound of `|d^ - d| / |d^|`, which background pixels need. The computed
//! `D` has an error of at most `8 u s`. The difference between 5 and 8 roundings covers this if the computed `D` is at
//! least four times the bound of `|d^ - d|`. Otherwise the code gives no bound.

use crate::geometry::camera::Camera;
use crate::input::size::Size;

/// The number of roundings, each of at most `u (|P| + s)`, that the bound allows. It is proved that 5
/// suffice (docs/margins.md).
pub const ROUNDINGS: f64 = 8.0;

/// Bounds of the rounding error of all camera rays of a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RayError {
    /// A bound of the distance between the computed direction of a camera ray and its exact direction, in scene units.
    pub length: f64,
    /// A bound of the sine of the angle between these two directions. It is infinite if the error may be longer than a
    /// quarter of the direction, or if a number is not finite.
    pub turn: f64,
}

impl RayError {
    /// Returns the bounds for the picture of `size` pixels that `camera` takes.
    pub fn new(camera: &Camera, size: Size) -> Self {
        let to_origin = camera.origin - camera.position;
        let right = camera.delta_x.length() * size.width() as f64;
        let down = camera.delta_y.length() * size.height() as f64;
        let window = to_origin.length() + right + down;
        let length = ROUNDINGS * (f64::EPSILON / 2.0) * (camera.position.length() + window);
        let distance = to_origin.dot(camera.delta_x.cross(camera.delta_y).unit());
        // The comparison is false if a number is not finite, and if the window is not in front of the camera.
        let turn = if 4.0 * length < distance { length / (distance - length) } else { f64::INFINITY };
        Self { length, turn }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::config::Config;
    use crate::math::double_double::DoubleDouble;
    use crate::math::real::Real as _;
    use crate::math::vec3::Vec3;
    use crate::sampling::uniform::Uniform;

    fn camera(text: &str) -> (Camera, Size) {
        let config = Config::parse(text.as_bytes()).expect("the configuration is valid");
        let size = config.image_size().expect("it has a size");
        (Camera::new(&config, size).expect("there is a window"), size)
    }

    /// Returns the length of the error of the camera ray through this point of the picture, by double-double
    /// arithmetic.
    fn error(camera: &Camera, row: f64, column: f64, [x, y]: [f64; 2]) -> f64 {
        let of = DoubleDouble::of;
        let wide = |vector: Vec3| vector.map(of);
        let to_origin = wide(camera.origin) - wide(camera.position);
        let exact = to_origin + wide(camera.delta_x) * (of(column) + of(x)) + wide(camera.delta_y) * (of(row) + of(y));
        (wide(camera.ray(row, column, [x, y]).direction) - exact).map(|component| component.high).length()
    }

    #[test]
    fn no_ray_has_a_larger_error_and_far_from_the_origin_some_come_near_it() {
        let mut draws = Uniform::new(5);
        for (position, target, fov) in [
            ("0 0 -10", "0 0 0", 90.0),
            ("131234.5 -7.25 131000.125", "131234.4 -7.25 131000.125", 60.0),
            ("1e9 1e9 -1e9", "1e9 1e9 -999999999.9", 20.0),
            ("-3.3e5 0 1", "-3.3e5 1e-3 1", 179.0),
            ("3e-3 0 2e-3", "1e7 3e6 1e7", 1e-6),
        ] {
            let (camera, size) = camera(&format!(
                "image_width: 60\ncamera_position: {position}\ncamera_target: {target}\nfield_of_view: {fov}\n\
                 camera_north: 1 3 2\n"
            ));
            let (bound, mut worst) = (RayError::new(&camera, size), 0.0_f64);
            for _ in 0..20_000 {
                let [row, column] = [size.height(), size.width()].map(|count| draws.draw(0.0, count as f64).floor());
                worst = worst.max(error(&camera, row, column, [draws.draw(-0.5, 0.5), draws.draw(-0.5, 0.5)]));
            }
            assert!(worst <= bound.length * (5.0 / ROUNDINGS), "{position}: {worst:e} exceeds {:e}", bound.length);
            assert!(worst > bound.length / 50.0, "{position}: {worst:e} is far below {:e}", bound.length);
        }
    }

    #[test]
    fn the_turn_grows_with_the_position_and_shrinks_with_the_distance_of_the_window() {
        let turn = |position: &str, target: &str| {
            let (camera, size) = camera(&format!("camera_position: {position}\ncamera_target: {target}\n"));
            RayError::new(&camera, size).turn
        };
        let near = turn("0 0 -10", "0 0 0");
        assert!((1e-15..1e-14).contains(&near), "{near:e}");
        let far = turn("0 0 1e6", "0 0 999999");
        assert!((5e-10..2e-9).contains(&far), "{far:e}");
        assert_eq!(turn("0 0 1e9", "0 0 999999999.9999999"), f64::INFINITY, "the error is longer than the direction");
    }

    #[test]
    fn a_camera_without_a_window_in_front_has_no_bound() {
        let (camera, size) = camera("");
        for origin in [camera.position, camera.position * 2.0 - camera.origin, Vec3::splat(f64::NAN)] {
            assert_eq!(RayError::new(&Camera { origin, ..camera }, size).turn, f64::INFINITY, "{origin:?}");
        }
    }
}
