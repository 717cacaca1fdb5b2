//! A value on the heap. Its allocation may fail with an error.

use std::ops::{Deref, DerefMut};

use crate::input::error::{Error, with_room};

/// A value on the heap, like `Box<T>`. `Box::new` ends the process if memory is short. [`Boxed::new`] returns an error.
#[derive(Debug)]
pub struct Boxed<T>(Vec<T>);

impl<T> Boxed<T> {
    /// Calls `make` once, and places its result on the heap. The parameter is a function and not the value, because the
    /// compiler would make a value on the stack and then copy it. The largest one has 180 KiB.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`] if memory is short.
    pub(crate) fn new(make: impl FnMut() -> T) -> Result<Self, Error> {
        let mut list = with_room(1, "the samples of a span")?;
        list.resize_with(1, make);
        Ok(Self(list))
    }
}

impl<T> Deref for Boxed<T> {
    type Target = T;

    #[inline(always)]
    fn deref(&self) -> &T {
        &self.0[0]
    }
}

impl<T> DerefMut for Boxed<T> {
    #[inline(always)]
    fn deref_mut(&mut self) -> &mut T {
        &mut self.0[0]
    }
}
