//! Measuring: user time of interleaved repeats, error against a converged picture, energy where there is a meter.
//!
//! [`matrix`] says what is measured, [`timing`], [`error`], [`intersections`] and [`energy`] measure it, [`results`]
//! keeps it with the machine that it was measured on, and [`statistics`], [`fit`] and [`gain`] say what follows. Times
//! are this process' user time: rendering has one thread, so nobody else's work is in it, though noisy neighbours still
//! slow it down.

pub mod energy;
pub mod error;
pub mod fit;
pub mod gain;
pub mod intersections;
pub mod machine;
pub mod matrix;
pub mod progress;
pub mod results;
pub mod statistics;
pub mod timing;
