//! Draws the differences between two pictures as a heat map, with the scale of its colours below.

use colorous::{Gradient, INFERNO, RED_BLUE};
use format::annotate::Canvas;

use crate::difference::{distance, of_pixels};
use crate::picture::floats::Floats;
use crate::picture::{Picture, with_room};

/// The mapping from differences to colours of the heat map.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    /// The smallest difference with the last colour, in levels from 0 to 255, or in the unit of the numbers. Larger
    /// differences have that colour too.
    pub most: f64,
    /// Whether the colours show the sign: red for pixels that are brighter in the second picture, blue for darker ones.
    pub is_signed: bool,
}

/// Height of the legend in pixels: the colour bar with its caption and numbers.
const LEGEND: usize = 60;
/// Smallest width of a canvas in pixels on which the text of the legend fits.
const LEAST_WIDTH: usize = 370;
/// Captions of the legend: the first for a scale without signs, the second for a scale with signs.
const CAPTIONS: [&str; 2] = ["difference, mean over channels", "second minus first, mean over channels"];
/// The colour of pixels that have no number in one of the pictures or in both.
pub(crate) const NOTHING: [u8; 3] = [70; 3];
const BAR: usize = 12;
const MARGIN: usize = 10;

impl Scale {
    /// Returns the scale whose last colour belongs to the largest of `differences`. If all are 0, it belongs to 1.
    fn of(differences: impl Iterator<Item = f64>, is_signed: bool) -> Self {
        let most = differences.map(f64::abs).fold(0.0, f64::max);
        Self { most: if most > 0.0 { most } else { 1.0 }, is_signed }
    }

    /// Returns the scale whose last colour belongs to the largest difference of the two pictures. If the pictures are
    /// equal, it belongs to a difference of one level.
    pub fn automatic(first: &Picture, second: &Picture, is_signed: bool) -> Self {
        Self::of(first.pixels.iter().zip(&second.pixels).map(|(&a, &b)| difference(a, b, is_signed)), is_signed)
    }

    /// Returns the colour for a difference. Without signs, the colours are matplotlib's Inferno, from dark to light.
    /// With signs, they are red and blue of ColorBrewer, with white between them.
    fn color(&self, difference: f64) -> [u8; 3] {
        if difference.is_nan() {
            NOTHING
        } else if self.is_signed {
            color_at(RED_BLUE, 0.5 - difference / self.most / 2.0)
        } else {
            color_at(INFERNO, difference / self.most)
        }
    }

    /// Returns the colour at the position `share` of the colour bar (from 0 to 1), and the difference that has this
    /// colour.
    fn bar(&self, share: f64) -> ([u8; 3], f64) {
        if self.is_signed {
            (color_at(RED_BLUE, 1.0 - share), self.most * (2.0 * share - 1.0))
        } else {
            (color_at(INFERNO, share), self.most * share)
        }
    }
}

/// Returns the mean of the channels of `second` minus the mean of the channels of `first`, in levels.
fn signed(first: [u8; 3], second: [u8; 3]) -> f64 {
    let sum = |pixel: [u8; 3]| pixel.iter().map(|&channel| i32::from(channel)).sum::<i32>();
    f64::from(sum(second) - sum(first)) / 3.0
}

/// Returns the difference of two pixels in levels, with or without a sign.
fn difference(first: [u8; 3], second: [u8; 3], is_signed: bool) -> f64 {
    if is_signed { signed(first, second) } else { of_pixels(first, second) }
}

/// Returns the colour of `map` at a position from 0 to 1. All pictures with a scale take their colours from here.
pub(crate) fn color_at(map: Gradient, position: f64) -> [u8; 3] {
    let color = map.eval_continuous(position.clamp(0.0, 1.0));
    [color.r, color.g, color.b]
}

/// Returns the heat map of the differences between two pictures of equal size, with its legend below.
///
/// # Errors
/// An error if there is too little memory for the heat map.
pub fn heatmap(first: &Picture, second: &Picture, scale: Scale) -> Result<Picture, String> {
    let pairs = first.pixels.iter().zip(&second.pixels);
    map(pairs.map(|(&a, &b)| difference(a, b, scale.is_signed)), first.width, scale, ", in levels")
}

/// Returns the heat map of the differences between two pictures of numbers of equal shape. Pixels with a number in only
/// one of them are grey. `most` is the difference of the last colour, and the largest one if it is `None`.
///
/// # Errors
/// An error if there is too little memory for the heat map.
pub fn of_numbers(first: &Floats, second: &Floats, most: Option<f64>, is_signed: bool) -> Result<Picture, String> {
    let channels = first.channels;
    let of = |a: f32, b: f32| if is_signed { f64::from(b) - f64::from(a) } else { distance(a, b) };
    let mean = |(a, b): (&[f32], &[f32])| {
        let sum = a.iter().zip(b).map(|(&a, &b)| of(a, b)).sum::<f64>() / channels as f64;
        if sum.is_finite() { sum } else { f64::NAN }
    };
    let differences = || first.values.chunks_exact(channels).zip(second.values.chunks_exact(channels)).map(mean);
    let automatic = Scale::of(differences(), is_signed);
    let scale = Scale { most: most.unwrap_or(automatic.most), ..automatic };
    let nothing = if differences().any(f64::is_nan) { "; grey: none" } else { "" };
    map(differences(), first.width, scale, nothing)
}

fn map(
    differences: impl ExactSizeIterator<Item = f64>,
    width: usize,
    scale: Scale,
    what: &str,
) -> Result<Picture, String> {
    let mut colors = with_room(differences.len())?;
    colors.extend(differences.map(|difference| scale.color(difference)));
    // All numbers below the bar have as many decimals as give the largest number two significant digits.
    let digits = (1.0 - scale.most.log10().floor()).clamp(0.0, 9.0) as usize;
    let number = |share: f64| format!("{:.digits$}", scale.bar(share).1);
    framed(&colors, width, &format!("{}{what}", CAPTIONS[usize::from(scale.is_signed)]), |canvas, place, size| {
        format::annotate::color_bar(canvas, place, size, |share| scale.bar(share).0, number);
    })
}

/// Returns a picture whose rows have `width` pixels, with its legend below: the caption, and what `draw` draws. `draw`
/// gets the place and the size of the colour bar.
///
/// # Errors
/// An error if memory is short.
pub(crate) fn framed(
    colors: &[[u8; 3]],
    width: usize,
    caption: &str,
    draw: impl FnOnce(&mut Canvas, (usize, usize), (usize, usize)),
) -> Result<Picture, String> {
    let height = colors.len() / width;
    let canvas = Canvas::new(width.max(LEAST_WIDTH), height + LEGEND);
    let mut canvas = canvas.map_err(|_| "not enough memory for the picture and its scale".to_owned())?;
    canvas.paste((0, 0), colors, width);
    canvas.write((MARGIN, height + 4), caption);
    let size = (canvas.width - 2 * MARGIN, BAR);
    draw(&mut canvas, (MARGIN, height + 4 + format::annotate::LINE), size);
    Ok(Picture { width: canvas.width, height: canvas.height(), pixels: canvas.pixels })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn picture(pixels: &[[u8; 3]]) -> Picture {
        Picture { width: pixels.len(), height: 1, pixels: pixels.to_vec() }
    }

    #[test]
    fn the_automatic_scale_ends_at_the_largest_difference() {
        let (first, second) = (picture(&[[5; 3], [5; 3]]), picture(&[[5; 3], [2; 3]]));
        for is_signed in [false, true] {
            assert_eq!(Scale::automatic(&first, &second, is_signed), Scale { most: 3.0, is_signed });
            assert_eq!(Scale::automatic(&first, &first, is_signed).most, 1.0);
        }
    }

    #[test]
    fn the_legend_stands_below_the_map() {
        let (first, second) = (picture(&[[5; 3], [5; 3]]), picture(&[[5; 3], [9; 3]]));
        let scale = Scale::automatic(&first, &second, false);
        let map = heatmap(&first, &second, scale).expect("it is small");
        assert_eq!((map.width, map.height), (LEAST_WIDTH, 1 + LEGEND));
        assert_eq!((map.pixels[0], map.pixels[1]), (color_at(INFERNO, 0.0), color_at(INFERNO, 1.0)));
        let longest =
            CAPTIONS.iter().map(|caption| format::annotate::width_of(&format!("{caption}; grey: none"))).max();
        assert!(longest.is_some_and(|longest| longest + MARGIN <= LEAST_WIDTH), "{longest:?}");
        let below = &map.pixels[map.width..];
        assert!(below.contains(&format::annotate::INK) && below.contains(&color_at(INFERNO, 1.0)));
    }
}
