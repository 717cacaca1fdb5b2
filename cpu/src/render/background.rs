//! The background: the colour of a ray that hits no object. It is a gradient along y (specification, section 8.4).

use crate::{input::config::Config, math::real::Real, math::vec3::Vec3, math::vec3::broadcast};

/// The two ends of the background's gradient: linear colours with channels in `[0, 1]`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Background<T = f64> {
    /// The colour of a ray straight along +y.
    pub dark: Vec3<T>,
    /// The colour of a ray straight along -y.
    pub light: Vec3<T>,
}

broadcast!(Background: dark, light;);

impl Background {
    /// Returns the background of a configuration.
    pub const fn new(config: &Config) -> Self {
        Self { dark: config.background_dark_color, light: config.background_light_color }
    }
}

impl<T: Real> Background<T> {
    /// Returns the colour of a ray along `direction`, which may have any length. It is `(1 - m) light + m dark` with
    /// `m = share_of_dark(unit(direction).y)`.
    #[inline(always)]
    pub fn color(&self, direction: Vec3<T>) -> Vec3<T> {
        let m = share_of_dark(direction.y / direction.length());
        self.light * (T::of(1.0) - m) + self.dark * m
    }
}

/// Returns the share of the dark colour in the gradient, for a direction of length one with this `y`.
#[inline(always)]
fn share_of_dark<T: Real>(y: T) -> T {
    (y + T::of(1.0)) / T::of(2.0)
}

/// Returns the lowest and the highest mean of a channel of background pixels, if the mean of `unit(direction).y` is at
/// most `radius` from `middle`. `dark` and `light` are the channel at the ends of the gradient. `rounding` is added on
/// both sides.
#[inline(always)]
pub fn interval<T: Real>(dark: f64, light: f64, (middle, radius): (T, T), rounding: f64) -> [T; 2] {
    let (light, difference) = (T::of(light), T::of(dark - light));
    let mean = light + difference * share_of_dark(middle);
    let radius = difference.abs() * (radius * T::of(0.5)) + T::of(rounding);
    [mean - radius, mean + radius]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_gradient_runs_from_light_below_to_dark_above() {
        let background = Background { dark: Vec3::new(1.0, 0.0, 0.5), light: Vec3::ZERO };
        assert_eq!(background.color(Vec3::new(0.0, 3.0, 0.0)), background.dark);
        assert_eq!(background.color(Vec3::new(0.0, -0.1, 0.0)), background.light);
        assert_eq!(background.color(Vec3::new(7.0, 0.0, 0.0)), background.dark * 0.5);
    }

    #[test]
    fn between_the_ends_both_colours_have_their_share() {
        let background = Background { dark: Vec3::new(1.0, 0.0, 0.5), light: Vec3::new(0.0, 1.0, 0.25) };
        // The direction's unit vector has y = 3 / 5, so the weight of `dark` is 4 / 5.
        let color = background.color(Vec3::new(4.0, 3.0, 0.0));
        assert!((color - Vec3::new(0.8, 0.2, 0.45)).length() < 1e-15, "{color:?}");
    }

    #[test]
    fn an_interval_reaches_the_scaled_radius_and_the_rounding_to_both_sides() {
        assert_eq!(interval(1.0, 0.0, (0.0, 0.5), 0.125), [0.125, 0.875]);
        assert_eq!(interval(0.25, 0.75, (0.5, 0.25), 0.0), [0.3125, 0.4375]);
    }

    #[test]
    fn a_null_direction_has_no_colour() {
        assert!(Background::new(&Config::default()).color(Vec3::ZERO).x.is_nan());
    }
}
