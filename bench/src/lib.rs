//! The shared code of the benchmarks.
//!
//! [`kernels`] are pieces of work that are small enough to be timed alone, or to have their instructions counted.
//! [`time`] measures user time, which does not include the time of other processes. [`record`] keeps dated times and
//! compares them.

pub mod kernels;
pub mod record;
pub mod time;
