//! What the benchmarks share.
//!
//! [`kernels`] are pieces of work small enough to be timed alone, or to have their instructions counted; [`time`]
//! measures the time that this process computed, whatever else the machine does; [`record`] keeps dated times and
//! compares them.

pub mod kernels;
pub mod record;
pub mod time;
