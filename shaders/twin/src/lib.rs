//! The loops of the WGSL port in Rust, for any number type. It needs no device, so it also runs in a web page.
//!
//! - [`module`] lists the texts of the WGSL modules in `shaders/wgsl`, and the modules that each one needs;
//! - [`features`] has the scene's needs as pipeline-overridable constants, and [`precision`] the type of a composition;
//! - [`float`] has the number types;
//! - [`picture`] is a scene in one of them, and [`packed`] and [`head`] write it into the shaders' buffers;
//! - [`hierarchy`] is a tree of boxes over the objects of a picture;
//! - [`trace`] renders pixels, and [`steps`] records their paths.

pub mod features;
pub mod float;
pub mod head;
pub mod hierarchy;
pub mod module;
pub mod packed;
pub mod picture;
pub mod precision;
pub mod steps;
pub mod trace;

pub use features::Features;
pub use float::Float;
pub use module::{MODULES, Module, REALS};
pub use picture::{Error, Picture, features_of};
pub use precision::Precision;
