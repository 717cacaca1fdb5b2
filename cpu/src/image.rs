//! Pictures: the trait [`Image`] of both layouts, the rule from a mean to a byte ([`quantize`]), and the text of a file
//! ([`ppm`]).
//!
//! Uses [`input`](crate::input). Begin with [`quantize`].

pub mod ppm;
pub mod quantize;

use crate::{input::error::Error, input::error::with_room, input::size::Size};

/// The colour of a pixel: red, green and blue, each from 0 to 255.
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

/// A picture in any layout. The index of a pixel is `row * width + column`, where row 0 is at the top and column 0 at
/// the left.
pub trait Image: Sized {
    /// Returns a black picture of this size.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`] if memory is short.
    fn black(size: Size) -> Result<Self, Error>;
    /// Returns the size of the picture.
    fn size(&self) -> Size;
    /// Returns the pixel at `index`.
    ///
    /// # Panics
    /// If there is no such pixel.
    fn pixel(&self, index: usize) -> Rgb;
    /// Replaces the pixel at `index`.
    ///
    /// # Panics
    /// If there is no such pixel.
    fn set_pixel(&mut self, index: usize, color: Rgb);
}

/// Returns a list of `count` default values.
///
/// # Errors
/// [`Error::OutOfMemory`] if memory is short.
pub(crate) fn zeroed<T: Clone + Default>(count: usize) -> Result<Vec<T>, Error> {
    let mut values = with_room(count, "the image")?;
    values.resize(count, T::default());
    Ok(values)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_allocation_that_cannot_be_is_an_error() {
        assert!(matches!(zeroed::<u64>(usize::MAX / 8), Err(Error::OutOfMemory { .. })));
        assert_eq!(zeroed::<u8>(3).map_err(|error| error.to_string()), Ok(vec![0, 0, 0]));
    }
}
