//! The renderer's mathematics in WGSL.
//!
//! One module per piece of maths, each the twin of a file in `cpu`: the same names, the same steps in the same order.
//! They are written over `real`, so that one text composes to `f64`, which a driver with that type runs to the bit like
//! `cpu`, and to `f32`, which every target of naga takes.
//!
//! - [`module`] lists the modules and what each needs;
//! - [`compose`] puts a module and its needs into one text, with any of them replaced;
//! - [`validate`] has naga read and check that text, and points at faults in the module's own file;
//! - [`limits`] bounds what naga is given;
//! - [`features`] are the scene's needs as pipeline-overridable constants;
//! - [`mod@translate`] writes the result for SPIR-V, Metal, Direct3D and OpenGL.
//!
//! ```
//! use shaders::{Library, Precision};
//!
//! let composition = Library::standard().compose("kernels/image", Precision::F32)?;
//! let validated = composition.validate()?;
//! assert_eq!(validated.entry_points(), ["image"]);
//! # Ok::<(), shaders::Error>(())
//! ```

pub mod compose;
pub mod diagnostic;
pub mod error;
pub mod features;
pub mod limits;
pub mod module;
pub mod precision;
pub mod translate;
pub mod validate;

pub use compose::{Composition, Library};
pub use diagnostic::Diagnostic;
pub use error::Error;
pub use features::Features;
pub use precision::Precision;
pub use translate::{Target, Translation, translate};
pub use validate::{Binding, Validated};
