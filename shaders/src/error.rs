//! Why a module cannot be composed, validated or translated.

use crate::{Diagnostic, Precision, Target};

/// Why there is no composition, no valid shader or no translation.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Error {
    /// No module has this name.
    #[error("there is no WGSL module [{name}]; there are: {known}", known = known())]
    UnknownModule {
        /// The unknown name.
        name: String,
    },
    /// naga does not accept the text.
    #[error("{0}")]
    Invalid(Box<Diagnostic>),
    /// There is no memory for the thread that naga runs on.
    #[error(
        "no thread with a stack of {bytes} bytes can be started: {cause}; raise the limits on memory and processes"
    )]
    NoStack {
        /// Bytes of the stack.
        bytes: usize,
        /// The system's message.
        cause: String,
    },
    /// The target cannot calculate in this precision.
    #[error("{target} cannot take {precision}: {reason}; compose for f32 instead")]
    Unsupported {
        /// The target.
        target: Target,
        /// The composition's precision.
        precision: Precision,
        /// What the target lacks.
        reason: &'static str,
    },
    /// naga accepts the text, but cannot write it for the target.
    #[error("cannot write {target}: {message}")]
    Write {
        /// The target.
        target: Target,
        /// naga's message.
        message: String,
    },
}

fn known() -> String {
    crate::module::MODULES.iter().map(|module| module.name).collect::<Vec<_>>().join(", ")
}
