//! Pictures in memory: their size, and what both layouts of their pixels can do.

use crate::error::{Error, Picture};

/// Most pixels that an image may have: 2^30, three bytes each.
pub const MAX_PIXELS: u64 = 1 << 30;

/// Width and height of a picture, at least one pixel each and at most [`MAX_PIXELS`] together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Size {
    width: u32,
    height: u32,
}

impl Size {
    /// The size, when an image may have it.
    ///
    /// # Errors
    /// [`Picture::TooLarge`] for more pixels than [`MAX_PIXELS`] or a side of none.
    pub fn new(width: u64, height: u64) -> Result<Self, Picture> {
        let too_large = Picture::TooLarge { width, height };
        let pixels = width.checked_mul(height).ok_or(too_large)?;
        if !(1..=MAX_PIXELS).contains(&pixels) {
            return Err(too_large);
        }
        // Both sides are at most their product, which is at most 2^30.
        Ok(Self { width: width as u32, height: height as u32 })
    }

    /// Columns.
    #[must_use]
    pub const fn width(self) -> usize {
        self.width as usize
    }

    /// Rows.
    #[must_use]
    pub const fn height(self) -> usize {
        self.height as usize
    }

    /// Columns times rows.
    #[must_use]
    pub const fn pixels(self) -> usize {
        self.width() * self.height()
    }
}

/// A pixel's red, green and blue.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(C)]
pub struct Rgb {
    /// Red.
    pub red: u8,
    /// Green.
    pub green: u8,
    /// Blue.
    pub blue: u8,
}

/// Pixels in rows from the top left, however they are laid out in memory. A pixel's index is `row * width + column`.
pub trait Image: Sized {
    /// A black picture.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`].
    fn black(size: Size) -> Result<Self, Error>;
    /// Its size.
    fn size(&self) -> Size;
    /// The pixel at `index`.
    ///
    /// # Panics
    /// When there is none.
    fn pixel(&self, index: usize) -> Rgb;
    /// Replaces the pixel at `index`.
    ///
    /// # Panics
    /// When there is none.
    fn set_pixel(&mut self, index: usize, color: Rgb);
}

/// `count` default values, without dying when memory is short.
///
/// # Errors
/// [`Error::OutOfMemory`].
pub(crate) fn zeroed<T: Clone + Default>(count: usize) -> Result<Vec<T>, Error> {
    let mut values = Vec::new();
    values.try_reserve_exact(count).map_err(|_| Error::OutOfMemory { what: "the image" })?;
    values.resize(count, T::default());
    Ok(values)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_are_bounded() {
        let size = Size::new(3, 2).expect("six pixels are few");
        assert_eq!((size.width(), size.height(), size.pixels()), (3, 2, 6));
        assert!(Size::new(1 << 15, 1 << 15).is_ok());
        for (width, height) in [(0, 5), (5, 0), ((1 << 15) + 1, 1 << 15), (u64::MAX, 2), (1 << 32, 1)] {
            assert_eq!(Size::new(width, height), Err(Picture::TooLarge { width, height }));
        }
    }

    #[test]
    fn an_allocation_that_cannot_be_is_an_error() {
        assert!(matches!(zeroed::<u64>(usize::MAX / 8), Err(Error::OutOfMemory { .. })));
        assert_eq!(zeroed::<u8>(3).map_err(|error| error.to_string()), Ok(vec![0, 0, 0]));
    }
}
