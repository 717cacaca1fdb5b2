//! Bounds of the background over a pixel, by its derivative. `background_pixels.rs` derives bytes from these bounds.
//!
//! With `s(d) = d.y / |d|` for a direction `d`, a channel of the background is `light + (dark - light) (s + 1) / 2`.
//! The rays through a pixel have the directions `d = d0 + x dx + y dy` with `x, y` in `[-1/2, 1/2]`. Taylor's theorem
//! gives
//!
//! `s(d) = s(d0) + x g.dx + y g.dy + R`, `g = (j - s(d0) d0 / |d0|) / |d0|`, `|R| <= 0.6 |e|^2 / (|d0| - |e|)^2`
//!
//! where `j` is the unit vector along y and `e = d - d0`. The bound of `R` covers its rounding (docs/margins.md).
//!
//! The renderer computes `s` of rounded directions `d^` and `d0^`. Let `r` bound the error of a direction
//! ([`RayError::length`]). The formula holds for `d^` and `d0^` too, but `e = d^ - d0^` differs from `x dx + y dy` by
//! up to `2 r`. So `|e|` is larger by up to `2 r`. As `|g| <= 1 / |d0^|`, the linear term has an additional error of at
//! most `2 r / |d0^|`, which is at most twice [`RayError::turn`].

use crate::math::{vec3::Vec3, vec3::broadcast};
use crate::render::ray_error::RayError;
use crate::{geometry::camera::Camera, geometry::camera::HALF_PIXEL, math::real::Real};

/// Bounds of the directions of the camera rays through one pixel, which hold for every pixel of a picture.
#[derive(Clone, Copy, Debug)]
pub struct PixelReach<T = f64> {
    /// An upper bound of the distance between the computed directions through a point of a pixel and through the
    /// pixel's middle, in scene units. It bounds `|e|` in the documentation of [this module](self).
    radius: T,
    /// An upper bound of the error of the linear term that comes from the rounding of directions.
    linear: T,
}

broadcast!(PixelReach:; radius, linear);

impl PixelReach {
    /// Returns the bounds for a camera and the error of its rays.
    pub fn new(camera: &Camera, error: &RayError) -> Self {
        let half_sides = (camera.delta_x.length() + camera.delta_y.length()) / 2.0;
        Self { radius: half_sides + 2.0 * error.length, linear: 2.0 * error.turn }
    }
}

/// The derivative of `s` over a pixel, with a bound of the remaining error. The documentation of [this module](self)
/// defines `s`, from which each channel of the background follows. With lanes, each lane has its own pixel.
#[derive(Clone, Copy, Debug)]
pub struct DerivativeBound<T = f64> {
    /// `s(d0)`, the value at the pixel's centre.
    middle: T,
    /// `g.dx` and `g.dy`, the derivatives along the pixel's sides.
    along: [T; 2],
    /// An upper bound of `|R|` and of the errors that come from the rounding of directions.
    remainder: T,
}

impl<T: Real> DerivativeBound<T> {
    /// Returns the derivative bound of the pixel at `row` and `column`.
    #[inline(always)]
    pub fn new(camera: &Camera<T>, row: T, column: T, PixelReach { radius, linear }: PixelReach<T>) -> Self {
        let zero = T::of(0.0);
        let d0 = camera.ray(row, column, [zero; 2]).direction;
        let length = d0.length();
        let middle = d0.y / length;
        let g = (Vec3::new(zero, T::of(1.0), zero) - d0 * (middle / length)) / length;
        // A negative difference or NaN becomes 0, so that the bound is infinite.
        let closest = T::select(zero.less(length - radius), length - radius, zero);
        let share = radius / closest;
        let remainder = share * share * T::of(0.6) + linear;
        Self { middle, along: [g.dot(camera.delta_x), g.dot(camera.delta_y)], remainder }
    }

    /// Returns the four numbers, in the order of the arrays that store them.
    #[inline(always)]
    pub fn numbers(&self) -> [T; 4] {
        [self.middle, self.along[0], self.along[1], self.remainder]
    }

    /// Returns the middle and the radius of an interval that contains `s` for every point of the pixel.
    #[inline(always)]
    pub fn anywhere(&self) -> (T, T) {
        (self.middle, (self.along[0].abs() + self.along[1].abs()) * T::of(HALF_PIXEL) + self.remainder)
    }
}

impl DerivativeBound {
    /// Returns the derivative bound with these [numbers](DerivativeBound::numbers).
    #[inline(always)]
    pub(crate) fn of([middle, right, down, remainder]: [f64; 4]) -> Self {
        Self { middle, along: [right, down], remainder }
    }

    /// Whether `(s + 1) / 2`, the weight of `dark`, certainly is in `[0, 1]` at every point of the pixel, in spite of
    /// rounding.
    #[inline(always)]
    pub(crate) fn weight_is_in_unit_interval(&self) -> bool {
        let (middle, radius) = self.anywhere();
        middle.abs() + radius < 0.999
    }

    /// Returns the middle and the radius of an interval that contains the mean of `s` over samples. `offset` is the
    /// mean of the samples' offsets from the pixel's centre, in pixels.
    #[inline(always)]
    pub(crate) fn at(&self, offset: [f64; 2]) -> (f64, f64) {
        (self.middle + offset[0] * self.along[0] + offset[1] * self.along[1], self.remainder)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::config::Config;
    use crate::simd::instruction_set::InstructionSet;
    use crate::simd::{Kernel, Simd, SimdF64, columns::Columns};

    fn camera(text: &str) -> (Camera, PixelReach) {
        let config = Config::parse(text.as_bytes()).expect("the configuration is valid");
        let size = config.image_size().expect("it has a size");
        let camera = Camera::new(&config, size).expect("there is a window");
        (camera, PixelReach::new(&camera, &RayError::new(&camera, size)))
    }

    /// Counts the samples of a picture, and those in pixels whose bound is below 1/2. Fails if a sample is out of
    /// bounds.
    fn count_tight(text: &str) -> [u32; 2] {
        let (camera, reach) = camera(&format!("image_width: 12\ncamera_north: 1 2 0\n{text}"));
        let mut draws = crate::sampling::uniform::Uniform::new(3);
        let [mut tight, mut all] = [0; 2];
        for (row, column) in (0..6).flat_map(|row| (0..12).map(move |column| (f64::from(row), f64::from(column)))) {
            let bound = DerivativeBound::new(&camera, row, column, reach);
            let middle = camera.ray(row, column, [0.0; 2]).direction;
            for _ in 0..50 {
                let offset = [draws.draw(-0.5, 0.5), draws.draw(-0.5, 0.5)];
                let direction = camera.ray(row, column, offset).direction;
                assert!((direction - middle).length() <= reach.radius, "{text}, pixel {row}, {column}");
                let s = direction.y / direction.length();
                for (middle, radius) in [bound.anywhere(), bound.at(offset)] {
                    assert!((s - middle).abs() <= radius + 1e-14, "{text}, pixel {row}, {column}");
                }
                all += 1;
                tight += u32::from(bound.remainder < 0.5);
            }
        }
        [tight, all]
    }

    #[test]
    fn the_slope_bounds_rays_whose_direction_is_rounded_to_few_digits() {
        // In the first pictures the pixels are so small that most of the difference comes from rounding.
        for (distance, fov) in [("0.01", 5e-5), ("0.01", 0.05), ("0.01", 20.0), ("1e-4", 90.0)] {
            let camera = format!(
                "camera_position: 1e8 1e8 1e8\ncamera_target: 1e8 1e8 {}\nfield_of_view: {fov}\n",
                1e8 + distance.parse::<f64>().expect("it is a number")
            );
            let [tight, all] = count_tight(&camera);
            assert!(tight > all / 2, "the bound says nothing at a distance of {distance}");
        }
    }

    /// A kernel that computes the bounds of eight pixels of a row, in lanes.
    struct Row<'a>(&'a Camera, PixelReach);

    impl Kernel for Row<'_> {
        type Output = Columns<4, 16>;

        #[inline(always)]
        fn call<S: Simd>(self, _: S) -> Self::Output {
            let (camera, reach) = (self.0.lanes::<S::F64>(), self.1.lanes());
            let mut bounds = Columns::ZERO;
            for at in (0..8).step_by(S::F64::LANES) {
                let column = S::F64::of(40.0) + S::F64::load(&[0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0][at..]);
                bounds.store(at, DerivativeBound::new(&camera, S::F64::of(7.0), column, reach).numbers());
            }
            bounds
        }
    }

    #[test]
    fn bounds_in_lanes_are_those_of_single_pixels_on_every_instruction_set() {
        let (camera, reach) = camera("image_width: 100\ncamera_north: 1 2 0\n");
        for set in InstructionSet::available() {
            let bounds = set.run(Row(&camera, reach));
            for at in 0..8 {
                let single = DerivativeBound::new(&camera, 7.0, 40.0 + at as f64, reach);
                assert_eq!(DerivativeBound::of(bounds.get(at)).numbers(), single.numbers(), "{}, {at}", set.name());
            }
        }
    }

    #[test]
    fn a_pixel_around_the_camera_has_no_bound() {
        let camera = Camera { position: Vec3::ZERO, origin: Vec3::new(0.0, 0.0, 1.0), ..camera("").0 };
        for radius in [1.0, 2.0, f64::NAN] {
            let reach = PixelReach { radius, linear: 0.0 };
            let (_, radius) = DerivativeBound::new(&camera, 0.0, 0.0, reach).anywhere();
            assert!(!radius.is_finite(), "{reach:?}: {radius}");
        }
    }
}
