//! The texts of the WGSL modules in `shaders/wgsl`. This package reads no WGSL, so it is small enough for a web page.
//!
//! - [`module`] lists the modules and the modules that each one needs;
//! - [`features`] has the scene's needs as pipeline-overridable constants;
//! - [`precision`] is the number type of a composition.

pub mod features;
pub mod module;
pub mod precision;

pub use features::Features;
pub use module::{MODULES, Module, REALS};
pub use precision::Precision;
