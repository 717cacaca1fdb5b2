//! How this project measures time: user time, several things in turn, and the median with its bounds.
//!
//! [`clock`] reads the user time, which does not include the time of other processes. [`turns`] measures several pieces
//! of work in turn, so that a slow phase of the machine affects all of them. [`statistics`] has the median and its
//! bounds, [`busy`] the warning of a busy machine, and [`energy`] reads the processor's meter. All programs that
//! measure use this crate.

pub mod busy;
pub mod clock;
pub mod energy;
pub mod statistics;
pub mod turns;
