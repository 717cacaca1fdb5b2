//! The background around pixels, to first order: what their bytes can be told from without rays.
//!
//! With `s(d) = d.y / |d|` for a direction `d`, a channel of the background is `light + (dark - light) (s + 1) / 2`.
//! Over a pixel, `d = d0 + x dx + y dy` with `x, y` in `[-1/2, 1/2]`, and Taylor's theorem gives
//!
//! `s(d) = s(d0) + x g.dx + y g.dy + R`, `g = (j - s(d0) d0 / |d0|) / |d0|`, `|R| <= 3 |e|^2 / (|d0| - |e|)^2`
//!
//! where `j` is the unit vector along y, `e = d - d0`, and the bound uses that the second derivative of `s` is at most
//! `6 / |d|^2`.

use crate::geometry::camera::Camera;
use crate::math::real::Real;
use crate::math::vec3::Vec3;
use crate::render::span::WIDEST;
use crate::simd::SimdF64;

/// `s` over a pixel, or over a lane of them.
#[derive(Clone, Copy, Debug)]
pub struct DerivativeBound<T = f64> {
    /// `s(d0)`.
    middle: T,
    /// `g.dx` and `g.dy`.
    along: [T; 2],
    /// Bound of `|R|`.
    rest: T,
}

impl<T: Real> DerivativeBound<T> {
    /// Over the pixel at `row` and `column`, if no point of a pixel is farther from its middle than `reach`.
    #[inline(always)]
    fn new(camera: &Camera<T>, row: T, column: T, reach: T) -> Self {
        let zero = T::of(0.0);
        let d0 = camera.ray(row, column, [zero; 2]).direction;
        let length = d0.length();
        let middle = d0.y / length;
        let g = (Vec3::new(zero, T::of(1.0), zero) - d0 * (middle / length)) / length;
        // Not negative, and then the bound is infinite; so it is where the length is not a number.
        let closest = T::select(zero.less(length - reach), length - reach, zero);
        let share = reach / closest;
        let rest = share * share * T::of(3.0 * (1.0 + 1e-9));
        Self { middle, along: [g.dot(camera.delta_x), g.dot(camera.delta_y)], rest }
    }

    /// `s` over all samples of the pixel: its mean lies this far from the first number at most.
    #[inline(always)]
    pub fn anywhere(&self) -> (T, T) {
        (self.middle, (self.along[0].abs() + self.along[1].abs()) * T::of(0.5) + self.rest)
    }
}

impl DerivativeBound {
    /// Whether `(s + 1) / 2`, as it is computed, is in `[0, 1]` all over the pixel.
    #[inline(always)]
    pub fn is_slanted(&self) -> bool {
        let (middle, radius) = self.anywhere();
        middle.abs() + radius < 0.999
    }

    /// `s` over samples with these mean offsets.
    #[inline(always)]
    pub fn at(&self, offset: [f64; 2]) -> (f64, f64) {
        (self.middle + offset[0] * self.along[0] + offset[1] * self.along[1], self.rest)
    }
}

/// The slopes of pixels side by side.
#[derive(Debug)]
pub struct DerivativeBounds {
    /// The largest `|e|`.
    reach: f64,
    middle: [f64; WIDEST],
    along: [[f64; WIDEST]; 2],
    rest: [f64; WIDEST],
}

impl DerivativeBounds {
    /// Of no pixel yet.
    pub fn new(camera: &Camera) -> Self {
        let reach = (camera.delta_x.length() + camera.delta_y.length()) / 2.0;
        Self { reach, middle: [0.0; WIDEST], along: [[0.0; WIDEST]; 2], rest: [0.0; WIDEST] }
    }

    /// Finds those of `count` pixels of a row, from the column `first` on: as many at once as there are lanes.
    #[inline(always)]
    pub fn find<V: SimdF64>(&mut self, camera: &Camera, row: usize, first: usize, count: usize) {
        let (camera, row, reach) = (camera.lanes::<V>(), V::of(row as f64), V::of(self.reach));
        for at in (0..count).step_by(V::LANES) {
            let column = V::of(first as f64) + V::load(&FROM_ZERO[at..]);
            let DerivativeBound { middle, along: [right, down], rest } =
                DerivativeBound::new(&camera, row, column, reach);
            middle.store(&mut self.middle[at..]);
            right.store(&mut self.along[0][at..]);
            down.store(&mut self.along[1][at..]);
            rest.store(&mut self.rest[at..]);
        }
    }

    /// Those of the pixels found from `at` on, a lane each.
    #[inline(always)]
    pub fn lanes<V: SimdF64>(&self, at: usize) -> DerivativeBound<V> {
        let along = [V::load(&self.along[0][at..]), V::load(&self.along[1][at..])];
        DerivativeBound { middle: V::load(&self.middle[at..]), along, rest: V::load(&self.rest[at..]) }
    }

    /// That of one of the pixels found.
    #[inline(always)]
    pub fn of(&self, at: usize) -> DerivativeBound {
        let along = [self.along[0][at], self.along[1][at]];
        DerivativeBound { middle: self.middle[at], along, rest: self.rest[at] }
    }
}

/// 0, 1, 2, and so on: the columns of a span.
const FROM_ZERO: [f64; WIDEST] = {
    let mut numbers = [0.0; WIDEST];
    let mut at = 0;
    while at < WIDEST {
        numbers[at] = at as f64;
        at += 1;
    }
    numbers
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::config::Config;
    use crate::simd::instruction_set::InstructionSet;
    use crate::simd::{Kernel, Simd};

    /// Finds the slopes of a row's pixels.
    struct Row<'a> {
        slopes: &'a mut DerivativeBounds,
        camera: &'a Camera,
        row: usize,
        first: usize,
        count: usize,
    }

    impl Kernel for Row<'_> {
        type Output = ();

        #[inline(always)]
        fn call<S: Simd>(self, _: S) {
            let Self { slopes, camera, row, first, count } = self;
            slopes.find::<S::F64>(camera, row, first, count);
        }
    }

    fn camera(text: &str) -> Camera {
        let config = Config::parse(text.as_bytes()).expect("the configuration is valid");
        Camera::new(&config, config.image_size().expect("it has a size")).expect("there is a window")
    }

    #[test]
    fn the_slope_bounds_the_background_over_the_pixel() {
        let mut draws = crate::sampling::uniform::Uniform::new(3);
        for fov in [1.0, 20.0, 90.0, 150.0, 175.0] {
            let camera = camera(&format!("image_width: 12\nfield_of_view: {fov}\ncamera_north: 1 2 0\n"));
            let mut slopes = DerivativeBounds::new(&camera);
            let (mut tight, mut all) = (0, 0);
            for row in 0..6 {
                InstructionSet::best().run(Row { slopes: &mut slopes, camera: &camera, row, first: 0, count: 12 });
                for column in 0..12 {
                    let slope = slopes.of(column);
                    for _ in 0..50 {
                        let offset = [draws.draw(-0.5, 0.5), draws.draw(-0.5, 0.5)];
                        let direction = camera.ray(row as f64, column as f64, offset).direction;
                        let s = direction.y / direction.length();
                        for (middle, radius) in [slope.anywhere(), slope.at(offset)] {
                            assert!((s - middle).abs() <= radius + 1e-14, "{fov} degrees, pixel {row}, {column}");
                        }
                        all += 1;
                        tight += u32::from(slope.rest < 0.5);
                    }
                }
            }
            assert!(fov > 90.0 || tight > all / 2, "the bound says nothing at {fov} degrees");
        }
    }

    #[test]
    fn slopes_found_side_by_side_are_those_found_alone_on_every_instruction_set() {
        let camera = camera("image_width: 100\ncamera_north: 1 2 0\n");
        for set in InstructionSet::ALL.into_iter().filter(|set| set.is_available()) {
            let mut slopes = DerivativeBounds::new(&camera);
            set.run(Row { slopes: &mut slopes, camera: &camera, row: 7, first: 40, count: 29 });
            for at in 0..29 {
                let (found, alone) =
                    (slopes.of(at), DerivativeBound::new(&camera, 7.0, 40.0 + at as f64, slopes.reach));
                let numbers = |slope: &DerivativeBound| [slope.middle, slope.along[0], slope.along[1], slope.rest];
                assert_eq!(numbers(&found), numbers(&alone), "{}, {at}", set.name());
            }
        }
    }

    #[test]
    fn a_pixel_around_the_camera_has_no_bound() {
        let camera = Camera { position: Vec3::ZERO, origin: Vec3::new(0.0, 0.0, 1.0), ..camera("") };
        for reach in [1.0, 2.0, f64::NAN] {
            let (_, radius) = DerivativeBound::new(&camera, 0.0, 0.0, reach).anywhere();
            assert!(!radius.is_finite(), "{reach}: {radius}");
        }
    }
}
