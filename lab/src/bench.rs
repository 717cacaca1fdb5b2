//! Measures user time, in turn, and the error against a converged picture.
//!
//! [`matrix`] lists what is measured. [`timing`] and [`error`] measure it. [`results`] stores the measured data and the
//! machine. [`fit`] derives other figures from the data, and [`diff`] compares two records of times. [`mechanisms`]
//! measures what each mechanism of the renderer gains.
//!
//! [`commands`] measures other programs. The other times are the user time of this process, which has one thread.
//! Work of other processes is not counted, but a busy machine still makes the times longer.

pub mod commands;
pub mod diff;
pub mod error;
pub mod fit;
pub mod machine;
pub mod matrix;
pub mod mechanisms;
pub mod results;
pub mod scenes;
pub mod timing;
