//! The loops of the WGSL port in Rust, for any number type. It needs no device, so it also runs in a web page.
//!
//! - [`float`] has the number types;
//! - [`picture`] is a scene in one of them, and [`packed`] and [`head`] write it into the shaders' buffers;
//! - [`hierarchy`] is a tree of boxes over the objects of a picture;
//! - [`trace`] renders pixels, and [`steps`] records their paths.

pub mod float;
pub mod head;
pub mod hierarchy;
pub mod packed;
pub mod picture;
pub mod steps;
pub mod trace;

pub use float::Float;
pub use picture::{Error, Picture, features_of};
