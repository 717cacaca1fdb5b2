//! Pictures: what both layouts of their pixels can do, how a mean becomes a byte ([`quantize`]), and the text of a file
//! ([`ppm`]).
//!
//! Uses [`input`](crate::input). Begin with [`quantize`].

pub mod ppm;
pub mod quantize;

use crate::{input::error::Error, input::error::with_room, input::size::Size};

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

/// `count` default values.
///
/// # Errors
/// [`Error::OutOfMemory`].
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
