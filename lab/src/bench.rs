//! Measures user time of interleaved repeats, error against a converged picture, and energy where there is a meter.
//!
//! [`matrix`] says what is measured, [`timing`], [`error`], [`intersections`] and [`energy`] measure it, [`results`]
//! keeps the figures with the machine, and [`statistics`], [`fit`] and [`gain`] derive other figures from them. Times
//! are the user time of this process, which has one thread. Work of other processes is not counted, but a busy machine
//! still makes the times longer.

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
