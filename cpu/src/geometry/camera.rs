//! The projection window, and the rays through its pixels (specification, sections 6.1 and 6.2).

use crate::geometry::ray::Ray;
use crate::input::{config::Config, error::Error, error::Picture, size::Size};
use crate::math::dyadic::{Dyadic, times_power_of_two};
use crate::math::{real::Real, tangent::tangent, vec3::Vec3, vec3::broadcast};

/// The largest offset of a sample from the middle of its pixel, in pixels (specification, section 6.2).
pub const HALF_PIXEL: f64 = 0.5;

/// The constants from which every camera ray is computed, in scene units.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Camera<T = f64> {
    /// `P`: the point where all camera rays start.
    pub position: Vec3<T>,
    /// `O`: the middle of the top left pixel in the projection window.
    pub origin: Vec3<T>,
    /// The vector from a pixel to the next one on its right.
    pub delta_x: Vec3<T>,
    /// The vector from a pixel to the next one below it.
    pub delta_y: Vec3<T>,
}

broadcast!(Camera: position, origin, delta_x, delta_y;);

impl Config {
    /// Checks that the configuration describes a picture that can be made. [`render`](crate::render()) makes the same
    /// check before it renders.
    ///
    /// # Errors
    /// [`Error::Picture`] if the picture has more than 2^30 pixels, or if the camera has no projection window: its
    /// position equals its target, north is null or parallel to the view, or the window is not finite.
    pub fn check_picture(&self) -> Result<(), Error> {
        Camera::new(self, self.image_size()?)?;
        Ok(())
    }
}

impl Camera {
    /// Returns the camera of a picture of `size` pixels.
    ///
    /// # Errors
    /// [`Picture::CameraAtTarget`], [`Picture::NorthParallel`] or [`Picture::CameraOutOfRange`] if the configuration
    /// gives no projection window.
    pub fn new(config: &Config, size: Size) -> Result<Self, Picture> {
        // The computed cross product of parallel vectors may not be zero. It may be a rounding error of a few units in
        // the last place of the product of their lengths.
        const PARALLEL_TO_NORTH: f64 = 4.0 * f64::EPSILON;

        let (position, target) = (config.camera_position, config.camera_target);
        let north = of_moderate_length(config.camera_north);
        if position == target {
            return Err(Picture::CameraAtTarget);
        }
        let (width, height) = (size.width() as f64, size.height() as f64);
        let focal = position - target;
        let focal_distance = focal.length();
        if !(focal_distance.is_finite() && focal_distance > 0.0 && north.is_finite()) {
            return Err(Picture::CameraOutOfRange);
        }
        let fov = config.field_of_view * std::f64::consts::PI / 180.0;
        let window_height = 2.0 * tangent(fov / 2.0) * focal_distance;
        let window_width = window_height * (width / height);
        let backward = focal.unit();
        let right = north.cross(backward);
        if right.length() <= PARALLEL_TO_NORTH * north.length() {
            return Err(Picture::NorthParallel);
        }
        let u = right.unit();
        let v = backward.cross(u);
        let horizontal = u * window_width;
        let vertical = -v * window_height;
        let (delta_x, delta_y) = (horizontal / width, vertical / height);
        let origin = position - focal - (horizontal + vertical) / 2.0 + (delta_x + delta_y) / 2.0;
        let camera = Self { position, origin, delta_x, delta_y };
        let finite = [position, origin, delta_x, delta_y].iter().all(|vector| vector.is_finite());
        if finite { Ok(camera) } else { Err(Picture::CameraOutOfRange) }
    }
}

/// Returns the vector times the power of two that brings its largest component to the range from 1/2 to 1, so that its
/// squared length neither overflows nor vanishes. A null vector, an infinite one and one with NaN are
/// returned as they are.
fn of_moderate_length(vector: Vec3) -> Vec3 {
    let largest = vector.to_array().into_iter().map(f64::abs).fold(0.0, f64::max);
    match Dyadic::new(largest).and_then(|largest| largest.top_exponent()) {
        Some(exponent) if vector.is_finite() => vector.map(|component| times_power_of_two(component, -exponent)),
        _ => vector,
    }
}

impl<T: Real> Camera<T> {
    /// Returns the camera ray through a point of pixel (`row`, `column`). `offset` is the distance of the point from
    /// the pixel's middle, in pixels: to the right, then down, each in `[-1/2, 1/2)`. The direction is not normalised.
    #[inline(always)]
    pub fn ray(&self, row: T, column: T, offset: [T; 2]) -> Ray<T> {
        let [x, y] = offset;
        let target = self.origin + self.delta_x * (column + x) + self.delta_y * (row + y);
        Ray { origin: self.position, direction: target - self.position }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn camera(change: impl FnOnce(&mut Config)) -> Result<Camera, Picture> {
        let mut config = Config { image_width: 4, aspect_ratio: [2, 1], ..Config::default() };
        change(&mut config);
        let camera = Camera::new(&config, config.image_size()?);
        assert_eq!(config.check_picture().is_ok(), camera.is_ok());
        camera
    }

    fn assert_near(actual: Vec3, expected: [f64; 3]) {
        assert!((actual - expected.into()).length() < 1e-12, "{actual:?} is not {expected:?}");
    }

    #[test]
    fn the_window_passes_through_the_target_and_fills_the_field_of_view() {
        // From (0, 0, -10) to the origin at 90 degrees: the window is 20 high and 40 wide, for 2 rows and 4 columns.
        let camera = camera(|_| ()).expect("the defaults make a camera");
        assert_near(camera.delta_y, [0.0, -10.0, 0.0]);
        assert_near(camera.delta_x, [-10.0, 0.0, 0.0]);
        assert_near(camera.origin, [15.0, 5.0, 0.0]);
    }

    #[test]
    fn a_ray_goes_through_its_pixel() {
        let camera = camera(|_| ()).expect("the defaults make a camera");
        let ray = camera.ray(1.0, 2.0, [0.5, -0.5]);
        assert_eq!(ray.origin, camera.position);
        assert_near(ray.at(1.0), [-10.0, 0.0, 0.0]);
    }

    #[test]
    fn a_camera_at_its_target_is_refused() {
        let result = camera(|config| config.camera_target = config.camera_position);
        assert_eq!(result, Err(Picture::CameraAtTarget));
    }

    #[test]
    fn a_parallel_or_null_north_is_refused() {
        for north in [[0.0, 0.0, 2.0], [0.0, 0.0, -1e-9], [0.0; 3]] {
            let result = camera(|config| config.camera_north = north.into());
            assert_eq!(result, Err(Picture::NorthParallel), "{north:?}");
        }
        let parallel_up_to_rounding = camera(|config| {
            config.camera_position = Vec3::new(0.3, 0.6, 0.9);
            config.camera_north = Vec3::new(0.1, 0.2, 0.3);
        });
        assert_eq!(parallel_up_to_rounding, Err(Picture::NorthParallel));
        assert!(camera(|config| config.camera_north = Vec3::new(0.0, 1e-9, 1.0)).is_ok());
    }

    #[test]
    fn north_may_have_any_length() {
        let north = Vec3::new(0.1, 0.7, -0.2);
        let expected = camera(|config| config.camera_north = north).expect("there is a window");
        for power in [-1070, -600, -200, 200, 600, 1023] {
            let north = north.map(|component| times_power_of_two(component, power));
            let actual = camera(|config| config.camera_north = north).expect("there is a window");
            let difference = (actual.delta_x - expected.delta_x).length() + (actual.origin - expected.origin).length();
            // 2^-1070 is so small that the components have only three or four bits.
            assert!(difference <= if power == -1070 { 1.0 } else { 0.0 }, "2^{power}: {difference}");
        }
        for north in [[0.0, f64::MAX, 0.0], [0.0, 1e155, 0.0], [0.0, 1e-170, 0.0], [0.0, 5e-324, 0.0]] {
            assert_eq!(camera(|config| config.camera_north = north.into()), camera(|_| ()), "{north:?}");
        }
        let infinite = camera(|config| config.camera_north = Vec3::new(0.0, f64::INFINITY, 0.0));
        assert_eq!(infinite, Err(Picture::CameraOutOfRange));
    }

    #[test]
    fn a_window_that_overflows_is_refused() {
        let result = camera(|config| config.camera_position = Vec3::new(0.0, 0.0, 1e300));
        assert_eq!(result, Err(Picture::CameraOutOfRange));
    }
}
