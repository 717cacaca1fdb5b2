//! Lowers f64 to integers: rewrites a valid module into one that has no f64, and computes the same bits.
//!
//! A value of type f64 becomes a `vec2<u32>`, the low word first, and a vector of f64 a structure of two to four of
//! them. So every buffer keeps its layout. An operation becomes a call of a function in `shaders/wgsl/f64`, which
//! computes with integers. WGSL defines integer arithmetic exactly, so the results are the same on every device, and no
//! driver may rewrite them. What cannot be lowered is refused with its place in the text.
//!
//! - [`arithmetic`] has the functions in WGSL;
//! - `module` goes through the parts of a module, and `lowering` knows what stands for each of them;
//! - `types` and `globals` copy what stands outside of functions, and `function` and `declared` copy the bodies;
//! - `expression`, `operators`, `math` and `convert` replace the operations on f64;
//! - `names` keeps the names of overrides and entry points;
//! - `layout` writes the sizes of structure members, which naga's writer leaves out.
//!
//! ```
//! use shaders::lower::{Arithmetic, lower_text};
//!
//! let source = "@group(0) @binding(0) var<storage, read_write> x: f64;\n\
//!     @compute @workgroup_size(1) fn double() { x = x + x; }";
//! let lowered = lower_text("double", source, &Arithmetic::standard())?;
//! assert!(lowered.contains("f64_add(") && !lowered.contains(": f64"));
//! # Ok::<(), shaders::Error>(())
//! ```

pub mod arithmetic;
mod block;
mod convert;
mod copy;
mod declared;
mod expression;
mod function;
mod globals;
mod layout;
mod lowering;
mod math;
mod module;
mod names;
mod operators;
mod prune;
mod refusal;
mod statement;
mod types;

pub use arithmetic::Arithmetic;

use naga::back::wgsl::{WriterFlags, write_string};
use naga::valid::{Capabilities, ValidationFlags, Validator};

use crate::validate::within_limits;
use crate::{Composition, Error, Precision, Validated};
use lowering::Lowering;

/// Returns the text of a module without f64 that computes what `source` computes. Messages show `path` as the file of
/// `source`.
///
/// # Errors
/// [`Error::Invalid`] if `source` is not valid WGSL, or calls a transcendental function of f64; [`Error::CannotLower`]
/// if it uses something that has no form in integers; [`Error::Lowering`] if naga cannot write the result.
pub fn lower_text(path: &str, source: &str, arithmetic: &Arithmetic) -> Result<String, Error> {
    lower(&Composition::of_file(path, source.to_owned(), Precision::F64), arithmetic)
}

/// Returns the lowered text of `composition`; see [`lower_text`].
pub(crate) fn lower(composition: &Composition, arithmetic: &Arithmetic) -> Result<String, Error> {
    within_limits(composition, || by_naga(composition, arithmetic))
}

fn by_naga(composition: &Composition, arithmetic: &Arithmetic) -> Result<String, Error> {
    let Validated { module: source, info, .. } = Validated::by_naga(composition, Capabilities::all())?;
    let (mut module, functions) = Lowering::new(&source, &info, arithmetic.module()?)
        .run()
        .map_err(|refusal| Error::CannotLower(Box::new(refusal.diagnostic(composition))))?;
    let failed = |message: String| Error::Lowering { message };
    let mut validator = Validator::new(ValidationFlags::all(), Capabilities::all() - Capabilities::FLOAT64);
    validator.validate(&module).map_err(|error| failed(error.emit_to_string("")))?;
    prune::prune(&mut module, &functions);
    names::free(&mut module);
    let info = validator.validate(&module).map_err(|error| failed(error.emit_to_string("")))?;
    let text = write_string(&module, &info, WriterFlags::empty()).map_err(|error| failed(error.to_string()))?;
    layout::with_sizes(&module, &text).and_then(|text| names::restore(&module, &text)).map_err(failed)
}
