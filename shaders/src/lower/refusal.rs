//! The reason why a module is not lowered, with its place.

use naga::Span;

use crate::{Composition, Diagnostic};

/// A part of the source that cannot be lowered.
#[derive(Clone, Debug)]
pub struct Refusal {
    /// The place in the source.
    span: Span,
    /// The entry point that is refused, if the refusal has no place of its own.
    entry: Option<String>,
    /// What cannot be lowered, as a noun phrase such as "`sin` of f64".
    what: String,
}

impl Refusal {
    /// Returns the refusal of `what`, a noun phrase.
    pub fn new(span: Span, what: impl Into<String>) -> Self {
        Self { span, entry: None, what: what.into() }
    }

    /// Returns the refusal of `what` of the entry point `name`.
    pub fn of_entry_point(what: &str, name: &str) -> Self {
        Self { span: Span::UNDEFINED, entry: Some(name.to_owned()), what: format!("{what} of `{name}`") }
    }

    /// Returns the message with its place in the file.
    pub fn diagnostic(&self, composition: &Composition) -> Diagnostic {
        let message = format!("{} cannot be lowered to integers", self.what);
        Diagnostic::of_span(message, self.span, self.entry.as_deref(), composition)
    }
}

/// The result of lowering a part.
pub type Lowered<T> = Result<T, Refusal>;
