//! A fault in a shader, with its place in the file that the reader knows.

use std::error::Error as _;
use std::fmt;

use naga::SourceLocation;
use naga::WithSpan;
use naga::front::wgsl::ParseError;
use naga::valid::ValidationError;

use crate::Composition;
use crate::limits::Excess;

/// Most characters of a line that a message shows.
const SHOWN: usize = 160;

/// What naga found wrong, and where.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// naga's words, from the outermost cause to the innermost.
    pub message: String,
    /// Where, when naga knows.
    pub place: Option<Place>,
}

/// A place in a WGSL file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// The module's file.
    pub file: String,
    /// Line, from 1.
    pub line: usize,
    /// Column in characters, from 1.
    pub column: usize,
    /// Characters that are meant, on this line.
    pub length: usize,
    /// The line itself.
    pub text: String,
}

impl Diagnostic {
    pub(crate) fn of_parsing(error: &ParseError, composition: &Composition) -> Self {
        let mut message = error.message().to_owned();
        for detail in error.labels().map(|(_, label)| label).chain(error.notes()).filter(|text| !text.is_empty()) {
            message = format!("{message}: {detail}");
        }
        Self { message, place: Place::new(error.location(composition.source()), composition) }
    }

    pub(crate) fn of_excess(excess: &Excess, composition: &Composition) -> Self {
        // naga counts lines and bytes in lines from 1.
        let before = &composition.source()[..excess.offset];
        let line = before.bytes().filter(|&byte| byte == b'\n').count() + 1;
        let start = before.rfind('\n').map_or(0, |end| end + 1);
        let [line_number, line_position, offset] =
            [line, excess.offset - start + 1, excess.offset].map(|number| u32::try_from(number).unwrap_or(u32::MAX));
        let location = SourceLocation { line_number, line_position, offset, length: 1 };
        Self { message: excess.message.clone(), place: Place::new(Some(location), composition) }
    }

    pub(crate) fn of_validation(error: &WithSpan<ValidationError>, composition: &Composition) -> Self {
        let mut message = error.as_inner().to_string();
        let mut cause = error.as_inner().source();
        while let Some(inner) = cause {
            message = format!("{message}: {inner}");
            cause = inner.source();
        }
        // The first span is the outermost, usually a whole function; the last is the expression at fault.
        let span = error.spans().last().map(|(span, _)| span.location(composition.source()));
        Self { message, place: Place::new(span, composition) }
    }
}

impl Place {
    fn new(location: Option<SourceLocation>, composition: &Composition) -> Option<Self> {
        let location = location?;
        let (file, line) = composition.origin(location.line_number as usize);
        let text = composition.source().lines().nth(location.line_number as usize - 1)?;
        let before = (location.line_position as usize - 1).min(text.len());
        let column = text.get(..before)?.chars().count() + 1;
        let rest = text.chars().count() + 1 - column;
        let length = (location.length as usize).clamp(1, rest.max(1));
        Some(Self { file: file.to_owned(), line, column, length, text: text.to_owned() })
    }
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Some(place) = &self.place else { return f.write_str(&self.message) };
        writeln!(f, "{}:{}:{}: {}", place.file, place.line, place.column, self.message)?;
        let margin = format!("{} | ", place.line);
        // Of a long line, the part about the fault.
        let skipped = (place.column - 1).saturating_sub(SHOWN / 2);
        let text: String = place.text.chars().skip(skipped).take(SHOWN).collect();
        writeln!(f, "{margin}{text}")?;
        let (indent, room) = (place.column - 1 - skipped, SHOWN.saturating_sub(place.column - 1 - skipped));
        write!(f, "{:indent$}{}", "", "^".repeat(place.length.min(room.max(1))), indent = margin.len() + indent)
    }
}

#[cfg(test)]
mod tests {
    use crate::{Error, Library, Precision};

    fn message(source: &str) -> String {
        let mut library = Library::standard();
        library.replace("scatter", "mine.wgsl", source).expect("it exists");
        let error = library.compose("scatter", Precision::F32).expect("it exists").validate();
        match error.expect_err("the text is wrong") {
            Error::Invalid(diagnostic) => diagnostic.to_string(),
            other => panic!("{other}"),
        }
    }

    #[test]
    fn a_fault_of_grammar_is_shown_with_a_caret() {
        let message = message("// One.\nfn f() -> real {\n    return vec3_dat(1.0);\n}\n");
        assert!(message.starts_with("mine.wgsl:3:12: no definition in scope for identifier"), "{message}");
        assert!(message.ends_with("3 |     return vec3_dat(1.0);\n               ^^^^^^^^"), "{message}");
    }

    #[test]
    fn of_a_long_line_the_part_about_the_fault_is_shown() {
        let message =
            message(&format!("const a = {}; const b = missing; const c = {};", "1".repeat(999), "1".repeat(999)));
        let lines: Vec<_> = message.lines().collect();
        let [_, text, carets] = lines[..] else { panic!("{message}") };
        assert_eq!(text.chars().count(), "1 | ".len() + super::SHOWN, "{message}");
        let place = carets.find('^').expect("there is a caret");
        assert!(text[place..].starts_with('1') || text[place..].starts_with("missing"), "{message}");
    }

    #[test]
    fn a_fault_of_types_is_shown_with_a_caret() {
        let message = message("fn f(v: vec3<real>) -> real {\n    return v + v;\n}\n");
        assert!(message.starts_with("mine.wgsl:2:12: Function"), "{message}");
        assert!(message.ends_with("2 |     return v + v;\n               ^^^^^"), "{message}");
    }
}
