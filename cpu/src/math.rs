//! The arithmetic of all other modules: numbers, vectors, sums with their rounding errors, more precise numbers, and
//! two correctly rounded functions.
//!
//! A formula over the trait of [`real`] is written once, and works on one number or on several at once. [`vec3`] has
//! vectors of such numbers. [`rounding`] adds the size of the rounding errors to the trait. [`error_free`] computes
//! sums and products together with their rounding errors, and [`exact_sum`] adds without any. [`double_double`] and
//! [`dyadic`] are more precise numbers. [`tangent`](tangent::tangent) and [`power`](power::power) replace the functions
//! of the system's library, because the last bits of their results differ between systems. This module uses no other
//! one. Begin with [`real::Real`].

pub mod double_double;
pub mod dyadic;
pub mod error_free;
pub(crate) mod exact_sum;
pub mod fixed_point;
pub(crate) mod limbs;
pub(crate) mod nearest;
pub mod power;
pub mod real;
pub mod rounding;
pub mod tangent;
pub mod vec3;
