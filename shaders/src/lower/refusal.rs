//! The reason why a module is not lowered, with its place.

use naga::Span;

use crate::{Composition, Diagnostic};

/// A part of the source that cannot be lowered.
#[derive(Clone, Debug)]
pub struct Refusal {
    /// The place in the source.
    span: Span,
    /// What cannot be lowered, as a noun phrase such as "`sin` of f64".
    what: String,
}

impl Refusal {
    /// Returns the refusal of `what`, a noun phrase.
    pub fn new(span: Span, what: impl Into<String>) -> Self {
        Self { span, what: what.into() }
    }

    /// Returns the message with its place in the file.
    pub fn diagnostic(&self, composition: &Composition) -> Diagnostic {
        let message = format!("{} cannot be lowered to integers", self.what);
        Diagnostic::of_span(message, self.span, composition)
    }
}

/// The result of lowering a part.
pub type Lowered<T> = Result<T, Refusal>;
