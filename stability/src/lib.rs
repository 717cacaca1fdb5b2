//! Holds the intersections of [`cpu`] against exact arithmetic.
pub mod observed;
