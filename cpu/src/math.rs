//! The arithmetic of all other modules: numbers, vectors, and sums with their rounding errors.
//!
//! A formula over the trait of [`real`] is written once, and works on one number or on several at once. [`vec3`] has
//! vectors of such numbers. [`rounding`] adds the size of the rounding errors to the trait. [`error_free`] computes
//! sums and products together with their rounding errors. This module uses no other one. Begin with [`real::Real`].

pub mod error_free;
pub mod real;
pub mod rounding;
pub mod vec3;
