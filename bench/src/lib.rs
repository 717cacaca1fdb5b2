//! The shared code of the benchmarks.
//!
//! [`kernels`] are pieces of work that are small enough to be measured alone, by their time or their instructions.
//! [`time`] measures user time, which does not include the time of other processes. [`record`] stores dated times and
//! compares them.
//! [`nearest`] compares nearest hits with Embree's.

pub mod kernels;
pub mod nearest;
pub mod record;
pub mod time;
