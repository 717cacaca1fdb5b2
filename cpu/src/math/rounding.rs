//! What formulas that know their own rounding errors ask of the arithmetic that they are written over.

use std::ops::{BitAnd, BitOr};

use crate::math::real::Real;

/// Masks that can be combined: `bool`, and what lanes compare to.
pub trait Logic: Copy + BitAnd<Output = Self> + BitOr<Output = Self> {}

impl<M: Copy + BitAnd<Output = Self> + BitOr<Output = Self>> Logic for M {}

/// Arithmetic of known precision.
pub trait Rounding: Real<Mask: Logic> {
    /// The largest relative error of an operation.
    const UNIT_ROUNDOFF: f64;
    /// How many times worse conditioned than in f64 a root may be that is accepted.
    const LENIENCE: f64;
}

impl Rounding for f64 {
    const UNIT_ROUNDOFF: f64 = f64::EPSILON / 2.0;
    const LENIENCE: f64 = 1.0;
}
