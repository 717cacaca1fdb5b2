//! The arithmetic that everything else is written in: numbers, vectors, and sums with their rounding errors.
//!
//! [`real`] is one number or several at once, so that a formula is written once for both; [`vec3`] are vectors over it;
//! [`rounding`] is arithmetic whose rounding is known, and [`error_free`] gives sums and products together with their
//! rounding errors. Uses nothing else of the library. Begin with [`real::Real`].

pub mod error_free;
pub mod real;
pub mod rounding;
pub mod vec3;
