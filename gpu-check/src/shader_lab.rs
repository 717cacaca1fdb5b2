//! Trying one's own WGSL: what the program `shader-lab` does, in parts that tests can call.
//!
//! - [`args`] reads the command line, [`files`] and [`sources`] the person's files;
//! - [`guard`] compiles them in a process whose memory and time are limited;
//! - [`truth`] is the picture by the CPU, computed once for many trials;
//! - [`trial`] renders with the modules and measures the distance from it, [`differences`] shows it in colours;
//! - [`view`] shows in false colours what a ray meets, [`pixel`] one pixel's way on both sides;
//! - [`watch`] does it again when a file has changed.

pub mod args;
pub mod differences;
pub mod files;
pub mod guard;
pub mod pixel;
pub mod png;
pub mod progress;
pub mod sources;
pub mod trial;
pub mod truth;
pub mod view;
pub mod watch;

/// The module that `--template` writes: a picture of the normals, to be changed.
pub const TEMPLATE: &str = include_str!("../templates/normals.wgsl");
