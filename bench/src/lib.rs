//! What the benchmarks share.
//!
//! `kernels`, with the feature of that name, are pieces of work small enough to be timed alone, or to have their
//! instructions counted; [`time`] measures the time that this process computed, whatever else the machine does.

#[cfg(feature = "kernels")]
pub mod kernels;
pub mod time;
