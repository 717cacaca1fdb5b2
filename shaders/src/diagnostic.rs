//! An error in a shader, with its place in the module's own file.

pub(crate) mod places;

use std::error::Error as _;
use std::fmt;

use naga::front::wgsl::ParseError;
use naga::valid::ValidationError;
use naga::{Module, SourceLocation, Span, WithSpan};

use crate::Composition;
use crate::limits::{Excess, tokens};

/// Largest number of characters of a line that a message shows.
const SHOWN: usize = 160;

/// Parts of naga's messages whose advice does not help in a module, and the messages in their place.
const OWN: [(&str, &str); 2] = [
    (
        "found a global directive",
        "a module can have no directive such as `enable`, because other modules stand before it in one text; \
         leave it out",
    ),
    (
        "enable extension is not enabled",
        "this needs an extension, which a module cannot enable; use f32, i32, u32 or `real`, and what WGSL has without \
         extensions",
    ),
];

/// The error that naga found, and its place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// naga's messages, from the outermost cause to the innermost.
    pub message: String,
    /// The place of the error; `None` if it is unknown.
    pub place: Option<Place>,
}

/// A place in a WGSL file: some characters of one line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// The path of the WGSL file.
    pub file: String,
    /// Line number, from 1.
    pub line: usize,
    /// Column of the first wrong character, from 1.
    pub column: usize,
    /// Number of wrong characters on this line.
    pub length: usize,
    /// The text of the line.
    pub text: String,
}

impl Diagnostic {
    pub(crate) fn of_parsing(error: &ParseError, composition: &Composition) -> Self {
        if places::is_too_deep(error) {
            let place = places::of_deep_nesting(composition.source()).and_then(|offset| Place::at(offset, composition));
            return Self { message: places::NESTED_TOO_DEEPLY.to_owned(), place };
        }
        let mut message = error.message().to_owned();
        // naga labels an error by "see msg" if its message says all.
        let says_more = |text: &&str| !["", "see msg"].contains(text);
        for detail in error.labels().map(|(_, label)| label).chain(error.notes()).filter(says_more) {
            // Some labels repeat a part of the message.
            if !message.contains(detail) {
                message = format!("{message}: {detail}");
            }
        }
        if let Some((_, own)) = OWN.iter().find(|(part, _)| message.contains(part)) {
            (*own).clone_into(&mut message);
        }
        let is_placed = error.labels().next().is_some_and(|(span, _)| span.is_defined());
        // Without its last brace, a module goes on in the next one, where naga finds the error.
        let is_in_replaced = |place: SourceLocation| composition.is_replaced(place.line_number as usize);
        if let Some(place) = Place::of_open_brace(composition)
            && !error.location(composition.source()).is_some_and(is_in_replaced)
        {
            return Self { message: "the `{` of this line has no `}`".to_owned(), place: Some(place) };
        }
        let place = match is_placed {
            true => Place::new(error.location(composition.source()), composition),
            false => Place::of_largest_array(composition),
        };
        Self { message: plain(&message), place: place.or_else(|| Place::first(composition)) }
    }

    pub(crate) fn of_excess(excess: &Excess, composition: &Composition) -> Self {
        Self { message: excess.message.clone(), place: Place::at(excess.offset, composition) }
    }

    /// Returns the message with the place of `span`, or with the place of the function `function`.
    pub(crate) fn of_span(message: String, span: Span, function: Option<&str>, composition: &Composition) -> Self {
        let location = span.is_defined().then(|| span.location(composition.source()));
        let place = Place::new(location, composition)
            .or_else(|| Place::of_function(function?, composition))
            .or_else(|| Place::first(composition));
        Self { message, place }
    }

    /// Returns the message for an error in `module`, which naga has read from `composition`.
    pub(crate) fn of_validation(error: &WithSpan<ValidationError>, module: &Module, composition: &Composition) -> Self {
        let mut message = error.as_inner().to_string();
        let mut cause = error.as_inner().source();
        while let Some(inner) = cause {
            message = format!("{message}: {inner}");
            cause = inner.source();
        }
        // The first span is the outermost, usually a whole function. The last span is the wrong expression or its type,
        // which may be defined in another file. A span in a replaced module is preferred, since the error is most
        // likely there.
        let spans: Vec<_> = error.spans().map(|(span, _)| span.location(composition.source())).collect();
        let in_replaced = |span: &&SourceLocation| composition.is_replaced(span.line_number as usize);
        let span = spans.iter().rev().find(in_replaced).copied();
        let place = Place::new(span, composition)
            .or_else(|| Place::of_function(message.split('\'').nth(1)?, composition))
            .or_else(|| Place::new(spans.last().copied(), composition))
            .or_else(|| Place::of_named(error.as_inner(), module, composition))
            .or_else(|| Place::first(composition));
        Self { message: plain(&message), place }
    }
}

/// Returns naga's message without indices into naga's own lists, and with types as WGSL writes them.
fn plain(message: &str) -> String {
    let scalars = [
        ("Float", 8, "f64"),
        ("Float", 4, "f32"),
        ("Float", 2, "f16"),
        ("Sint", 4, "i32"),
        ("Uint", 4, "u32"),
        ("Bool", 1, "bool"),
    ];
    let mut text = message.to_owned();
    for (kind, width, name) in scalars {
        let [fields, scalar] = [format!("kind: {kind}, width: {width}"), format!("Scalar({name})")];
        text = text.replace(&format!("Scalar {{ {fields} }}"), name).replace(&scalar, name).replace(&fields, name);
        for (size, count) in [("Bi", 2), ("Tri", 3), ("Quad", 4)] {
            let vector = format!("Vector {{ size: {size}, scalar: {name} }}");
            text = text.replace(&vector, &format!("vec{count}<{name}>"));
        }
    }
    // For a wrong return, naga shows two indices into its lists, or None if the function returns nothing. Words replace
    // both.
    let returns = "The `return` expression ";
    if let Some(start) = text.find(returns).filter(|_| text.contains("does not match the declared return type")) {
        let is_missing = text[start + returns.len()..].starts_with("None");
        text.truncate(start);
        text.push_str(if is_missing {
            "it ends without a `return` of the type that it declares"
        } else {
            "the `return` expression is not of the type that the function declares"
        });
    }
    without_handles(&text)
}

/// Returns the text without indices into naga's own lists, such as ` [12]`. An index that stands for a noun, as in `the
/// type of [12]`, is replaced by words. An index after a noun, as in `Function [12]`, is removed.
fn without_handles(text: &str) -> String {
    /// Words that need a noun after them, and the noun.
    const NOUNS: [(&str, &str); 7] = [
        (" in", " the target"),
        (" to", " the function"),
        (" match the type", " of the parameter"),
        (" of", " the value"),
        (" for", " the value"),
        (" with", " the operand"),
        (" and", " the operand"),
    ];
    let mut result = String::new();
    let mut rest = text;
    while let Some(start) = rest.find(" [") {
        let (before, bracket) = rest.split_at(start);
        result.push_str(before);
        let digits = bracket[2..].bytes().take_while(u8::is_ascii_digit).count();
        rest = match bracket[2 + digits..].strip_prefix(']') {
            Some(after) if digits > 0 => {
                let noun = NOUNS.iter().find(|(words, _)| before.ends_with(words));
                result.push_str(noun.map_or("", |(_, noun)| noun));
                after
            }
            _ => {
                result.push_str(" [");
                &bracket[2..]
            }
        };
    }
    result.push_str(rest);
    // The removal of an index may leave `, has type` at the end of the message, which is removed too.
    result.strip_suffix(", has type").map_or(result.clone(), str::to_owned)
}

impl Place {
    /// Returns the first line of the first replaced module, or `None` if no module is replaced. This is the place of an
    /// error for which naga gives no place.
    fn first(composition: &Composition) -> Option<Self> {
        let (line, text) = composition.replaced_lines().next()?;
        Some(Self::of_line(line, text, composition))
    }

    /// Returns the line of the first `{` that has no `}` in its replaced module, or `None` if there is none.
    fn of_open_brace(composition: &Composition) -> Option<Self> {
        let lines: Vec<_> = composition.replaced_lines().collect();
        lines.chunk_by(|(one, _), (next, _)| composition.origin(*one).0 == composition.origin(*next).0).find_map(
            |file| {
                // The lines are joined, because a comment may have several.
                let text = file.iter().map(|(_, text)| *text).collect::<Vec<_>>().join("\n");
                let mut open = Vec::new();
                for (at, token) in tokens(text.as_bytes()) {
                    match token {
                        b"{" => open.push(at),
                        b"}" => drop(open.pop()),
                        _ => {}
                    }
                }
                let (line, text) = file[text[..*open.first()?].matches('\n').count()];
                Some(Self::of_line(line, text, composition))
            },
        )
    }

    /// Returns the place behind the last word of the last replaced module, for an error at the end of the text.
    fn end(composition: &Composition) -> Option<Self> {
        let (line, text) = composition.replaced_lines().filter(|(_, text)| !text.trim().is_empty()).last()?;
        let place = Self::of_line(line, text, composition);
        Some(Self { column: place.column + place.length, length: 1, ..place })
    }

    /// Returns the line of a replaced module that begins the function `name`, or `None` if no replaced module has it.
    fn of_function(name: &str, composition: &Composition) -> Option<Self> {
        let begins = |text: &str| {
            let words: Vec<_> = tokens(text.as_bytes()).map(|(_, word)| word).collect();
            words.windows(2).any(|pair| pair == [b"fn", name.as_bytes()])
        };
        let (line, text) = composition.replaced_lines().find(|(_, text)| begins(text))?;
        Some(Self::of_line(line, text, composition))
    }

    /// Returns the line of a replaced module with the largest array, or `None` without an array. naga has no place of a
    /// type that is too large, which only an array can be.
    fn of_largest_array(composition: &Composition) -> Option<Self> {
        let size = |text: &str| {
            let mut words = tokens(text.as_bytes()).skip_while(|(_, word)| *word != b"array").peekable();
            words.peek()?;
            let number = |word| str::from_utf8(word).ok()?.trim_end_matches(['i', 'u']).parse::<u64>().ok();
            words.map(|(_, word)| number(word).unwrap_or(0)).max()
        };
        let (line, text) = composition.replaced_lines().max_by_key(|(_, text)| size(text))?;
        size(text).map(|_| Self::of_line(line, text, composition))
    }

    /// Returns the place of the character at `offset`, in bytes from the start of the composition.
    fn at(offset: usize, composition: &Composition) -> Option<Self> {
        let offset = u32::try_from(offset).ok()?;
        Self::new(Some(Span::new(offset, offset + 1).location(composition.source())), composition)
    }

    /// Returns the place of the entry point or the type that `error` is about.
    fn of_named(error: &ValidationError, module: &Module, composition: &Composition) -> Option<Self> {
        let ty = match error {
            ValidationError::EntryPoint { name, .. } => return Self::of_function(name, composition),
            ValidationError::Type { handle, .. } => *handle,
            ValidationError::Layouter(error) => error.ty,
            _ => return None,
        };
        let span = places::of_type(ty, module, None);
        Self::new(span.is_defined().then(|| span.location(composition.source())), composition)
    }

    /// Returns the place that covers a whole line of the composition, without the blanks at its ends.
    fn of_line(line: usize, text: &str, composition: &Composition) -> Self {
        let (file, line) = composition.origin(line);
        let column = text.chars().take_while(|character| character.is_whitespace()).count() + 1;
        let length = text.trim().chars().count().max(1);
        Self { file: file.to_owned(), line, column, length, text: text.to_owned() }
    }

    fn new(location: Option<SourceLocation>, composition: &Composition) -> Option<Self> {
        let location = location?;
        let (file, line) = composition.origin(location.line_number as usize);
        let Some(text) = composition.source().lines().nth(location.line_number as usize - 1) else {
            return Self::end(composition);
        };
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
        // If a line is long, only the part around the error is shown.
        let skipped = (place.column - 1).saturating_sub(SHOWN / 2);
        let text: String = place.text.chars().skip(skipped).take(SHOWN).collect();
        writeln!(f, "{margin}{text}")?;
        let (indent, room) = (place.column - 1 - skipped, SHOWN.saturating_sub(place.column - 1 - skipped));
        write!(f, "{:indent$}{}", "", "^".repeat(place.length.min(room.max(1))), indent = margin.len() + indent)
    }
}

#[cfg(test)]
mod tests;
