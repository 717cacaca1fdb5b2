//! The width and height of a picture, within the limits of the specification.

use crate::input::error::{MAX_PIXELS, Picture};

/// The width and height of a picture in pixels. Each is at least 1, and their product is at most [`MAX_PIXELS`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Size {
    width: u32,
    height: u32,
}

impl Size {
    /// Returns the size of a picture with this width and height in pixels.
    ///
    /// # Errors
    /// [`Picture::TooLarge`] if there are more pixels than [`MAX_PIXELS`], or if `width` or `height` is 0.
    pub fn new(width: u64, height: u64) -> Result<Self, Picture> {
        let too_large = Picture::TooLarge { width, height };
        let pixels = width.checked_mul(height).ok_or(too_large)?;
        if !(1..=MAX_PIXELS).contains(&pixels) {
            return Err(too_large);
        }
        // Both sides are at most their product, which is at most 2^30.
        Ok(Self { width: width as u32, height: height as u32 })
    }

    /// Returns the number of columns.
    #[must_use]
    pub const fn width(self) -> usize {
        self.width as usize
    }

    /// Returns the number of rows.
    #[must_use]
    pub const fn height(self) -> usize {
        self.height as usize
    }

    /// Returns the number of pixels: columns times rows.
    #[must_use]
    pub const fn pixels(self) -> usize {
        self.width() * self.height()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_are_bounded() {
        let size = Size::new(3, 2).expect("six pixels are allowed");
        assert_eq!((size.width(), size.height(), size.pixels()), (3, 2, 6));
        assert!(Size::new(1 << 15, 1 << 15).is_ok());
        for (width, height) in [(0, 5), (5, 0), ((1 << 15) + 1, 1 << 15), (u64::MAX, 2), (1 << 32, 1)] {
            assert_eq!(Size::new(width, height), Err(Picture::TooLarge { width, height }));
        }
    }
}
