//! The parts of the program `shader-lab`, which renders with WGSL modules of the user.
//!
//! - [`args`] reads the command line; [`files`] and [`sources`] read the user's files;
//! - [`guard`] compiles the modules in a process whose memory and time are limited;
//! - [`truth`] holds the picture by the CPU, which is computed once for many trials;
//! - [`trial`] renders with the modules and compares the picture with the CPU's; [`differences`] draws the differences;
//! - [`pixel`] prints one pixel's path by WGSL and by the CPU;
//! - [`watch`] renders again when a file has changed.

pub mod args;
pub mod differences;
pub mod files;
pub mod guard;
pub mod pixel;
pub mod png;
mod rendered;
pub mod sources;
pub mod trial;
pub mod truth;
pub mod watch;

/// The text of the module that `--template` writes: it draws a picture of the normals, and the user can change it.
pub const TEMPLATE: &str = include_str!("../templates/normals.wgsl");
