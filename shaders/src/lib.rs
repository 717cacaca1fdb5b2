//! The renderer's mathematics in WGSL.
//!
//! Each module with formulas is the twin of a file in `cpu`: it has that file's names, and its steps in their order.
//! Where the comment of a WGSL function begins with a Rust name, as in `Ray::at: ...`, that name is its twin. The
//! modules use the number type `real`, so that one text composes to `f64` and to `f32`. In `f64` the lavapipe driver
//! gives the bits of `cpu`. Every target of naga takes the text in `f32`.
//!
//! - [`module`] lists the modules and what each needs;
//! - [`compose`] puts a module and the modules that it needs into one text, and can replace any of them;
//! - [`validate`] has naga read and check that text, and points at faults in the module's own file;
//! - [`limits`] bounds the size and the nesting of the texts that naga is given;
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
