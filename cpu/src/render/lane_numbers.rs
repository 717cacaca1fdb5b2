//! Whole numbers in lanes. Lanes and queues hold only `f64`, so a type for each of these numbers converts it. Lanes
//! move a sample's index and never calculate with it, so it is stored as bits. An object's number is compared, so it is
//! stored as a value.

use crate::{accel::object::ObjectId, math::real::Real};

/// The number of an object, as a whole number. It is negative where no object is hit.
#[derive(Clone, Copy, Debug)]
pub struct ObjectNumber<T = f64>(pub T);

impl<T: Real> ObjectNumber<T> {
    /// Returns the number of the object `id`.
    #[inline(always)]
    pub(crate) fn of(id: ObjectId) -> Self {
        Self(T::of(f64::from(id)))
    }
}

impl ObjectNumber {
    /// Returns the object, which must be one.
    #[inline(always)]
    pub(crate) fn id(self) -> ObjectId {
        debug_assert!(self.0 >= 0.0);
        self.0 as ObjectId
    }
}

/// The index of a sample in its span, as the bits of an `f64`.
#[derive(Clone, Copy, Debug)]
pub struct SampleIndex<T = f64>(pub T);

impl SampleIndex {
    /// Returns `index` in this form.
    pub(crate) const fn new(index: usize) -> Self {
        Self(f64::from_bits(index as u64))
    }

    /// Returns the index.
    #[inline(always)]
    pub(crate) const fn get(self) -> usize {
        self.0.to_bits() as usize
    }
}
