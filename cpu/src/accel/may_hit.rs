//! Conservative tests: which objects a ray may hit, one object or several at once, in double or in single precision.
//!
//! Begin with [`conservative`]. Its tests take an object as a [`target`]. [`object_lanes`] has several objects for
//! these tests. [`filter_ray`] has other tests, in single precision.

pub mod conservative;
pub mod filter_ray;
pub mod object_lanes;
pub mod target;
