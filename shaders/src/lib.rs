//! The renderer's mathematics in WGSL.
//!
//! Each module with formulas has a twin, a Rust file in `cpu` with the same names, and the same steps in the same
//! order. If the comment of a WGSL function begins with a Rust name, such as `Ray::at: ...`, that name is its twin. The
//! modules use the number type `real`, so that one text composes to `f64` and to `f32`. In `f64` the lavapipe driver
//! gives the bits of `cpu`. naga can translate the `f32` text for every target.
//!
//! - the package [`twin`] lists the modules and the modules that each one needs;
//! - [`compose`] joins a module and the modules that it needs into one text, and can replace any of them;
//! - [`validate`] checks that text with naga, and reports errors with their places in the module's own file;
//! - [`limits`] limits the size and the nesting of the texts that naga reads;
//! - `transcendental` refuses functions of f64 that drivers calculate wrongly;
//! - [`call_trace`] records every call of a function with its arguments and its result;
//! - [`lower`] replaces f64 by integers, for devices and languages without f64;
//! - [`as_written`] writes SPIR-V whose arithmetic a driver must not rewrite;
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

pub mod as_written;
pub mod call_trace;
pub mod compose;
pub mod diagnostic;
pub mod error;
pub mod limits;
pub mod lower;
mod transcendental;
pub mod translate;
pub mod validate;

pub use call_trace::CallTrace;
pub use compose::{Composition, Library};
pub use diagnostic::Diagnostic;
pub use error::Error;
pub use translate::{Target, Translation, translate};
pub use twin::{Features, Precision, features, module, precision};
pub use validate::{Binding, Validated};

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn the_shader_has_these_constants_and_no_others() {
        let composition = Library::standard().compose("features", Precision::F32).expect("it exists");
        let overrides = composition.validate().expect("it is valid").module.overrides;
        let in_shader: BTreeSet<_> = overrides.iter().filter_map(|(_, constant)| constant.name.as_deref()).collect();
        let here = BTreeSet::from(Features::all(5).constants().map(|(name, _)| name));
        assert_eq!(in_shader, here);
    }
}
