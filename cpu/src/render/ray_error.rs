//! The rounding error of camera rays. Culling and background pixels argue about exact camera rays, so their margins
//! contain this error.
//!
//! Take `O`, `P`, `dx` and `dy` as exact. The camera ray through a point of the picture has the direction
//! `d = (O - P) + dx (c + x) + dy (f + y)`, and `d^` is the direction that [`Camera::ray`] computes. The point
//! `O + dx (c + x) + dy (f + y)` is rounded to the spacing of numbers near the camera's *position*, however near the
//! window is. Let `W` and `H` be the picture's width and height in pixels, and `u = 2^-53`. With
//! `s = |O - P| + W |dx| + H |dy|` the error `|d^ - d|` is at most `5 u (|P| + s)`
//! (`tests/stability/src/proof/camera.rs` proves it from the formula). The code uses [`ROUNDINGS`] `= 8` instead of 5,
//! which also covers the roundings of the bound itself.
//!
//! Let `D` be the distance of `P` from the plane of the window. No direction `d` is shorter than `D`, and no computed
//! direction is shorter than `D - |d^ - d|`. So rounding turns a camera ray by an angle whose sine is at most
//! `|d^ - d| / (D - |d^ - d|)`. This is also a bound of `|d^ - d| / |d^|`, which background pixels need. The difference
//! between 5 and 8 roundings covers the error of the computed `D` too, if `D` is at least [`LEAST_DISTANCE`] times the
//! bound of `|d^ - d|`. Otherwise the code gives no bound.

use crate::geometry::camera::Camera;
use crate::{input::size::Size, math::real::Real};

/// The number of roundings, each of at most `u (|P| + s)`, that the bound allows. It is proved that 5
/// suffice (docs/margins.md).
pub const ROUNDINGS: f64 = 8.0;

/// The smallest distance of the window for which there is a bound, in lengths of the error of a direction.
pub const LEAST_DISTANCE: f64 = 4.0;

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
    pub(crate) fn new(camera: &Camera, size: Size) -> Self {
        let to_first_pixel = camera.origin - camera.position;
        let right = camera.delta_x.length() * size.width() as f64;
        let down = camera.delta_y.length() * size.height() as f64;
        let window = to_first_pixel.length() + right + down;
        let length = ROUNDINGS * (f64::EPSILON / 2.0) * (camera.position.length() + window);
        let distance = distance_of_window(camera);
        // The comparison is false if a number is not finite, and if the window is not in front of the camera.
        let turn = if LEAST_DISTANCE * length < distance { length / (distance - length) } else { f64::INFINITY };
        Self { length, turn }
    }
}

/// Returns the distance of the camera's position from the plane of the window, negative if the window is behind it.
pub fn distance_of_window<T: Real>(camera: &Camera<T>) -> T {
    (camera.origin - camera.position).dot(camera.delta_x.cross(camera.delta_y).unit())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::config::Config;
    use crate::math::vec3::Vec3;

    fn camera(text: &str) -> (Camera, Size) {
        let config = Config::parse(text.as_bytes()).expect("the configuration is valid");
        let size = config.image_size().expect("it has a size");
        (Camera::new(&config, size).expect("there is a window"), size)
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
        let (front, _) = camera("camera_position: 0 0 -10\ncamera_target: 0 0 0\n");
        let behind = Camera { delta_x: front.delta_y, delta_y: front.delta_x, ..front };
        assert!((distance_of_window(&front) - 10.0).abs() < 1e-12 && distance_of_window(&behind) < -9.0);
        let (camera, size) = camera("");
        for origin in [camera.position, camera.position * 2.0 - camera.origin, Vec3::splat(f64::NAN)] {
            assert_eq!(RayError::new(&Camera { origin, ..camera }, size).turn, f64::INFINITY, "{origin:?}");
        }
    }
}
