//! Draws a quantity of each pixel with colours, and its scale below.

use colorous::{TABLEAU10, VIRIDIS};
use format::annotate::Canvas;

use super::Quantity;
use crate::heatmap::{NOTHING, color_at, framed};
use crate::picture::floats::Floats;
use crate::picture::{Picture, with_room};
use crate::report::style::short;

/// A scale is logarithmic if its largest number is so many times the smallest positive one.
const WIDE: f64 = 8.0;
/// A logarithmic scale begins at this part of its largest number, or above it.
const SMALLEST_SHARE: f64 = 1e-4;

impl Quantity {
    /// Draws the quantity, with its scale below. `Cost` gives two pictures below each other.
    ///
    /// # Errors
    /// An error if memory is short.
    pub fn draw(self, floats: &Floats) -> Result<Picture, String> {
        let channel = |channel: usize| move |pixel: &[f32]| f64::from(pixel[channel]);
        match self {
            Self::Depth => scaled(floats, "distance from the camera, scene units", channel(0)),
            Self::Lambda => scaled(floats, "lambda, lengths of the direction", channel(0)),
            Self::Samples => scaled(floats, "samples", channel(0)),
            Self::Variance => {
                let mean = |pixel: &[f32]| pixel.iter().map(|&value| f64::from(value)).sum::<f64>() / 3.0;
                scaled(floats, "variance, mean of the channels", mean)
            }
            Self::Cost => {
                let mut both = scaled(floats, "rays a pixel", channel(0))?;
                both.pixels.extend(scaled(floats, "intersections a pixel", channel(2))?.pixels);
                both.height *= 2;
                Ok(both)
            }
            Self::Normal => {
                let color = |pixel: &[f32]| [0, 1, 2].map(|axis| (127.5 * pixel[axis] + 127.5) as u8);
                let axis = |at: usize, sign: f32| [0, 1, 2].map(|axis| if axis == at { sign } else { 0.0 });
                let names = ["+x", "-x", "+y", "-y", "+z", "-z"];
                let place = |(at, name): (usize, &&str)| {
                    ((*name).to_owned(), color(&axis(at / 2, if at % 2 == 0 { 1.0 } else { -1.0 })))
                };
                named(floats, "normal", color, &names.iter().enumerate().map(place).collect::<Vec<_>>())
            }
            Self::Object | Self::Material => {
                let most = floats.values.iter().copied().fold(0.0, f32::max) as usize;
                let names: Vec<_> = (0..=most.min(9)).map(|at| (at.to_string(), swatch(at))).collect();
                let what = if self == Self::Object { "object" } else { "material" };
                let digit = if most > 9 { ", last digit of its number" } else { "" };
                named(floats, &format!("{what}{digit}"), |pixel| swatch(pixel[0] as usize), &names)
            }
            Self::Part => {
                let names = ["sphere", "side", "top", "bottom"].into_iter().enumerate();
                let names: Vec<_> = names.map(|(at, name)| (name.to_owned(), swatch(at))).collect();
                named(floats, "part", |pixel| swatch(pixel[0] as usize), &names)
            }
        }
    }
}

/// Returns the colour of a number that is a name. Numbers with the same last digit have the same colour.
fn swatch(number: usize) -> [u8; 3] {
    let color = TABLEAU10[number % 10];
    [color.r, color.g, color.b]
}

/// Returns the picture of a number of each pixel, with a colour bar from its smallest to its largest value.
fn scaled(floats: &Floats, caption: &str, number: impl Fn(&[f32]) -> f64) -> Result<Picture, String> {
    let numbers = || floats.values.chunks_exact(floats.channels).map(&number);
    let known = || numbers().filter(|value| value.is_finite());
    let most = known().fold(0.0, f64::max);
    let positive = known().filter(|&value| value > 0.0).fold(most, f64::min);
    let is_wide = most > WIDE * positive;
    let least = if is_wide { positive.max(most * SMALLEST_SHARE) } else { known().fold(most, f64::min) };
    // The position of a number on the bar from 0 to 1, and the number at a position.
    let share = |value: f64| match (is_wide, most > least) {
        (true, _) => (value / least).ln() / (most / least).ln(),
        (false, true) => (value - least) / (most - least),
        (false, false) => 0.0,
    };
    let value = |share: f64| if is_wide { least * (most / least).powf(share) } else { least + (most - least) * share };
    let mut colors = with_room(floats.width * floats.height)?;
    colors.extend(numbers().map(|value| if value.is_nan() { NOTHING } else { color_at(VIRIDIS, share(value)) }));
    let kind = if is_wide { ", logarithmic" } else { "" };
    let caption = format!("{caption}{kind}{}", grey(numbers().any(f64::is_nan)));
    framed(&colors, floats.width, &caption, |canvas, place, size| {
        format::annotate::color_bar(canvas, place, size, |share| color_at(VIRIDIS, share), |share| short(value(share)));
    })
}

const fn grey(is_there: bool) -> &'static str {
    if is_there { "; grey: none" } else { "" }
}

/// Returns the picture of colours that have names, which stand below it.
fn named(
    floats: &Floats,
    caption: &str,
    color: impl Fn(&[f32]) -> [u8; 3],
    names: &[(String, [u8; 3])],
) -> Result<Picture, String> {
    const GAP: usize = 4;

    let mut colors = with_room(floats.width * floats.height)?;
    let pixels = floats.values.chunks_exact(floats.channels);
    colors.extend(pixels.map(|pixel| if pixel[0].is_nan() { NOTHING } else { color(pixel) }));
    let caption = format!("{caption}{}", grey(colors.contains(&NOTHING)));
    framed(&colors, floats.width, &caption, |canvas: &mut Canvas, (x, y), (width, height)| {
        let step = (width / names.len()).min(80);
        for (at, (name, color)) in names.iter().enumerate() {
            let left = x + at * step;
            canvas.paste((left, y), &vec![*color; (step - GAP) * height], step - GAP);
            canvas.write((left, y + height + GAP), name);
        }
    })
}

#[cfg(test)]
mod tests {
    use clap::ValueEnum;

    use super::*;

    #[test]
    fn every_quantity_has_a_picture_even_without_a_hit() {
        for &quantity in Quantity::value_variants() {
            let mut floats = Floats::zeros(2, 1, quantity.channels()).expect("it is small");
            floats.values.fill(f32::NAN);
            let picture = quantity.draw(&floats).expect("it is small");
            assert_eq!(picture.pixels[0], NOTHING, "{quantity:?}");
            assert_eq!(picture.pixels.len(), picture.width * picture.height);
        }
    }
}
