//! Draws text on pictures: captions above panels, and numbers below a colour bar.
//!
//! A [`Canvas`] is a picture in memory with eight bits a channel. The letters come from the fixed-width font of
//! `embedded-graphics`, so a picture is the same on every machine.

use std::collections::TryReserveError;
use std::convert::Infallible;

use embedded_graphics::mono_font::MonoTextStyle;
use embedded_graphics::mono_font::iso_8859_1::FONT_7X13;
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::prelude::{Dimensions, DrawTarget, Drawable, OriginDimensions, Pixel, Point, RgbColor, Size};
use embedded_graphics::text::{Baseline, Text};

/// A colour: its red, green and blue component, each from 0 to 255.
pub type Color = [u8; 3];

/// The background colour of a canvas.
pub const PAPER: Color = [255; 3];
/// The colour in which [`Canvas::write`] draws text.
pub const INK: Color = [32; 3];
/// Height of a line of text in pixels, with the space above and below it.
pub const LINE: usize = 17;

/// A picture in memory on which the functions of this crate draw.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Canvas {
    /// Number of pixels in a row.
    pub width: usize,
    /// The colours of all pixels, row by row from the top left.
    pub pixels: Vec<Color>,
}

impl Canvas {
    /// Returns a canvas on which every pixel is [`PAPER`].
    ///
    /// # Errors
    /// An error if there is too little memory for the canvas.
    pub fn new(width: usize, height: usize) -> Result<Self, TryReserveError> {
        let mut pixels = Vec::new();
        // If the number of pixels does not fit in a `usize`, `try_reserve_exact` below returns an error.
        let count = width.saturating_mul(height);
        pixels.try_reserve_exact(count)?;
        pixels.resize(count, PAPER);
        Ok(Self { width, pixels })
    }

    /// Returns the height of the canvas in pixels.
    #[must_use]
    pub fn height(&self) -> usize {
        self.pixels.len().checked_div(self.width).unwrap_or(0)
    }

    /// Sets the colour of the pixel at `x` and `y`. Does nothing for a pixel outside the canvas.
    pub fn set(&mut self, x: usize, y: usize, color: Color) {
        if x < self.width && y < self.height() {
            self.pixels[y * self.width + x] = color;
        }
    }

    /// Copies `picture`, whose rows have `width` pixels, onto the canvas with its top left corner at `x` and `y`.
    /// Pixels outside the canvas are left out.
    pub fn paste(&mut self, (x, y): (usize, usize), picture: &[Color], width: usize) {
        for (index, color) in picture.iter().enumerate() {
            self.set(x + index % width, y + index / width, *color);
        }
    }

    /// Draws the text `words` with its top left corner at `x` and `y`. Pixels outside the canvas are left out.
    pub fn write(&mut self, (x, y): (usize, usize), words: &str) {
        let [red, green, blue] = INK;
        let style = MonoTextStyle::new(&FONT_7X13, Rgb888::new(red, green, blue));
        let place = Point::new(x as i32, y as i32);
        let Ok(_) = Text::with_baseline(words, place, style, Baseline::Top).draw(self);
    }
}

/// Returns the width of the text `words` in pixels.
#[must_use]
pub fn width_of(words: &str) -> usize {
    let style = MonoTextStyle::new(&FONT_7X13, Rgb888::BLACK);
    Text::new(words, Point::zero(), style).bounding_box().size.width as usize
}

/// Returns a canvas with several panels below each other, each with its caption above it. A panel is a caption and the
/// pixels of a picture. All panels are `width` pixels wide. The canvas is as wide as the panels or the widest caption.
///
/// # Errors
/// An error if there is too little memory for the canvas.
pub fn panels(panels: &[(&str, &[Color])], width: usize) -> Result<Canvas, TryReserveError> {
    let widest = panels.iter().map(|(caption, _)| width_of(caption) + 4).max().unwrap_or(0);
    let height: usize = panels.iter().map(|(_, picture)| LINE + picture.len() / width).sum();
    let mut canvas = Canvas::new(width.max(widest), height)?;
    let mut y = 0;
    for (caption, picture) in panels {
        canvas.write((2, y + 2), caption);
        canvas.paste((0, y + LINE), picture, width);
        y += LINE + picture.len() / width;
    }
    Ok(canvas)
}

/// Draws a colour bar from left to right, with five numbers below it: at both ends and at each quarter. `color` and
/// `number` take a position on the bar, from 0 (left) to 1 (right), and return its colour and its text.
pub fn color_bar(
    canvas: &mut Canvas,
    (x, y): (usize, usize),
    (width, height): (usize, usize),
    color: impl Fn(f64) -> Color,
    number: impl Fn(f64) -> String,
) {
    const STEPS: usize = 4;
    let last = width.saturating_sub(1).max(1);
    for column in 0..width {
        let color = color(column as f64 / last as f64);
        (0..height).for_each(|row| canvas.set(x + column, y + row, color));
    }
    for step in 0..=STEPS {
        let share = step as f64 / STEPS as f64;
        let middle = x + last * step / STEPS;
        (height..height + 4).for_each(|row| canvas.set(middle, y + row, INK));
        let words = number(share);
        // The first and the last number are moved to the inside, so that they lie within the canvas.
        let most = canvas.width.saturating_sub(width_of(&words));
        canvas.write((middle.saturating_sub(width_of(&words) / 2).min(most), y + height + 4), &words);
    }
}

impl OriginDimensions for Canvas {
    fn size(&self) -> Size {
        Size::new(self.width as u32, self.height() as u32)
    }
}

impl DrawTarget for Canvas {
    type Color = Rgb888;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb888>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        for Pixel(Point { x, y }, color) in pixels {
            if let (Ok(x), Ok(y)) = (usize::try_from(x), usize::try_from(y)) {
                self.set(x, y, [color.r(), color.g(), color.b()]);
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn panels_stand_below_their_captions() {
        let (black, red) = ([[0; 3]; 6], [[255, 0, 0]; 6]);
        let canvas = panels(&[("one", &black), ("another", &red)], 3).expect("it is small");
        assert_eq!((canvas.width, canvas.height()), (7 * 7 + 4, 2 * (LINE + 2)));
        assert_eq!(canvas.pixels[LINE * canvas.width], [0; 3]);
        assert_eq!(canvas.pixels[(2 * LINE + 2) * canvas.width], [255, 0, 0]);
        assert_eq!(canvas.pixels[(2 * LINE + 2) * canvas.width + 3], PAPER, "a picture has its own width");
        assert!(canvas.pixels[..LINE * canvas.width].contains(&INK), "the caption is written");
    }

    #[test]
    fn a_bar_goes_from_the_first_colour_to_the_last_with_numbers_below() {
        let mut canvas = Canvas::new(120, 40).expect("it is small");
        color_bar(&mut canvas, (10, 0), (100, 8), |share| [(255.0 * share) as u8; 3], |share| format!("{share}"));
        assert_eq!((canvas.pixels[10], canvas.pixels[109]), ([0; 3], [255; 3]));
        let words = &canvas.pixels[13 * 120..26 * 120];
        assert!(words.contains(&INK));
    }

    #[test]
    fn a_canvas_without_room_is_an_error() {
        assert!(Canvas::new(usize::MAX / 4, 2).is_err() && Canvas::new(usize::MAX, usize::MAX).is_err());
    }

    #[test]
    fn what_lies_outside_is_cut() {
        let mut canvas = Canvas::new(5, 5).expect("it is small");
        canvas.write((3, 3), "words that do not fit");
        canvas.paste((4, 4), &[[1; 3]; 4], 2);
        assert_eq!((canvas.pixels.len(), canvas.pixels[24]), (25, [1; 3]));
    }
}
