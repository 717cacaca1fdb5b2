//! The errors of composing, validating and translating a module.

use crate::{Diagnostic, Precision, Target};

/// The reason why there is no composition, no valid shader or no translation.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Error {
    /// No module has this name.
    #[error("there is no WGSL module [{name}]; there are: {known}", known = known())]
    UnknownModule {
        /// The name that was asked for.
        name: String,
    },
    /// naga finds an error in the text, or the text exceeds the limits, or it calls a transcendental function of f64.
    #[error("{0}")]
    Invalid(Box<Diagnostic>),
    /// The text is valid, but a part of it has no form in integers.
    #[error("{0}")]
    CannotLower(Box<Diagnostic>),
    /// naga refuses or cannot write the module that was lowered.
    #[error("cannot write the lowered module: {message}")]
    Lowering {
        /// The error message of naga.
        message: String,
    },
    /// The system cannot start the thread on which naga runs.
    #[error(
        "no thread with a stack of {bytes} bytes can be started: {cause}; raise the limits on memory and processes"
    )]
    NoStack {
        /// Size of the stack in bytes.
        bytes: usize,
        /// The system's error message.
        cause: String,
    },
    /// The target language cannot calculate in this precision.
    #[error("{target} cannot take {precision}: {reason}; compose for f32 instead")]
    Unsupported {
        /// The target language.
        target: Target,
        /// The precision of the composition.
        precision: Precision,
        /// The reason: which feature the target lacks.
        reason: &'static str,
    },
    /// naga accepts the text, but cannot write it in the target language.
    #[error("cannot write {target}: {message}")]
    Write {
        /// The target language.
        target: Target,
        /// The error message of naga.
        message: String,
    },
}

fn known() -> String {
    crate::module::MODULES.iter().map(|module| module.name).collect::<Vec<_>>().join(", ")
}
