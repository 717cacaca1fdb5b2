//! Measures three things: user time, in turn; the error against a converged picture; and energy, if the machine can
//! measure it.
//!
//! [`matrix`] lists what is measured. [`timing`], [`error`] and [`energy`] measure it. [`results`] stores the measured
//! data and the machine. [`fit`] derives other figures from the data. Times are the user time of this process, which
//! has one thread. Work of other processes is not counted, but a busy machine still makes the times longer.

pub mod energy;
pub mod error;
pub mod fit;
pub mod machine;
pub mod matrix;
pub mod progress;
pub mod results;
pub mod scenes;
pub mod timing;
