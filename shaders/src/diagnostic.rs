//! A fault in a shader, with its place in the file that the reader knows.

use std::error::Error as _;
use std::fmt;

use naga::SourceLocation;
use naga::WithSpan;
use naga::front::wgsl::ParseError;
use naga::valid::ValidationError;

use crate::Composition;

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
        let place = Place::new(error.location(composition.source()), composition);
        Self { message: plain(&message), place: place.or_else(|| Place::first(composition)) }
    }

    pub(crate) fn of_validation(error: &WithSpan<ValidationError>, composition: &Composition) -> Self {
        let mut message = error.as_inner().to_string();
        let mut cause = error.as_inner().source();
        while let Some(inner) = cause {
            message = format!("{message}: {inner}");
            cause = inner.source();
        }
        // The first span is the outermost, usually a whole function; the last is the expression at fault, or a type
        // that it has, which may be defined in another file. What a person wrote comes first.
        let spans: Vec<_> = error.spans().map(|(span, _)| span.location(composition.source())).collect();
        let is_theirs = |span: &&SourceLocation| composition.is_replaced(span.line_number as usize);
        let span = spans.iter().rev().find(is_theirs).copied();
        let place = Place::new(span, composition)
            .or_else(|| Place::of_function(&message, composition))
            .or_else(|| Place::new(spans.last().copied(), composition))
            .or_else(|| Place::first(composition));
        Self { message: plain(&message), place }
    }
}

/// naga's words without its own numbers for things, and with types as WGSL writes them.
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
    // naga says which entries of its lists do not match, or None where nothing is returned.
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

/// The text without ` [12]`, which is a place in naga's own lists.
fn without_handles(text: &str) -> String {
    let mut result = String::new();
    let mut rest = text;
    while let Some(start) = rest.find(" [") {
        let (before, bracket) = rest.split_at(start);
        result.push_str(before);
        let digits = bracket[2..].bytes().take_while(u8::is_ascii_digit).count();
        rest = match bracket[2 + digits..].strip_prefix(']') {
            Some(after) if digits > 0 => after,
            _ => {
                result.push_str(" [");
                &bracket[2..]
            }
        };
    }
    result + rest
}

impl Place {
    /// The first line of the first replaced module: all that is known where naga says no place.
    fn first(composition: &Composition) -> Option<Self> {
        let (line, text) = composition.replaced_lines().next()?;
        Some(Self::of_line(line, text, composition))
    }

    /// The line of a replaced module that begins the function which a message names, as in `Function [7] 'f' is invalid`.
    fn of_function(message: &str, composition: &Composition) -> Option<Self> {
        let (_, rest) = message.split_once('\'')?;
        let (name, _) = rest.split_once('\'')?;
        let begins = |text: &str| {
            text.trim_start().strip_prefix("fn ").is_some_and(|rest| {
                rest.trim_start().strip_prefix(name).is_some_and(|rest| rest.trim_start().starts_with('('))
            })
        };
        let (line, text) = composition.replaced_lines().find(|(_, text)| begins(text))?;
        Some(Self::of_line(line, text, composition))
    }

    /// A whole line of the composition.
    fn of_line(line: usize, text: &str, composition: &Composition) -> Self {
        let (file, line) = composition.origin(line);
        let column = text.chars().take_while(|character| character.is_whitespace()).count() + 1;
        let length = text.trim().chars().count().max(1);
        Self { file: file.to_owned(), line, column, length, text: text.to_owned() }
    }

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
        writeln!(f, "{margin}{}", place.text)?;
        write!(f, "{:indent$}{}", "", "^".repeat(place.length), indent = margin.len() + place.column - 1)
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
    fn every_fault_of_a_person_names_their_file_and_wgsls_own_types() {
        let faults = [
            "fn f() -> real {\n    return 1u;\n}\n",
            "fn f() -> vec3<real> {\n    return real(1.0);\n}\n",
            "fn f() -> real {\n    let x = 1u;\n}\n",
            "fn g(x: real) -> real { return x; }\nfn f() -> real {\n    return g(vec3<real>());\n}\n",
            "fn f() {\n    if real(1.0) { return; }\n}\n",
            "var<private> x: real = 1u;\n",
            "struct S { x: array<real> , y: real }\n",
            "fn f() -> real {\n    var x: vec2<real>;\n    x.x = 1u;\n    return x.x;\n}\n",
            "@compute @workgroup_size(1) fn f(x: real) {}\n",
            "fn f() -> bool {\n    return real(1.0);\n}\n",
            "fn f() -> real {",
            "fn f(x: nothing) {}",
            "fn f() -> real { return f(); }",
        ];
        for precision in Precision::ALL {
            for fault in faults {
                let mut library = Library::standard();
                library.replace("scatter", "mine.wgsl", fault).expect("it exists");
                let result = library.compose("scatter", precision).expect("it exists").validate();
                let message = result.err().unwrap_or_else(|| panic!("{fault} is wrong")).to_string();
                println!("{fault}{message}\n");
                assert!(message.starts_with("mine.wgsl:"), "{fault}{message}");
                let first = message.lines().next().unwrap_or_default();
                assert!(
                    !first.contains("kind:")
                        && !first.contains("Scalar")
                        && !first.contains("Some(")
                        && !first.contains(" ["),
                    "{message}"
                );
                if first.contains("real_") || precision == Precision::F32 {
                    assert!(!first.contains("f64"), "{message}");
                }
            }
        }
    }

    #[test]
    fn a_type_is_named_as_wgsl_names_it() {
        let naga = "Vector { size: Tri, scalar: Scalar { kind: Float, width: 8 } } for Function [7] 'f' of [x]";
        assert_eq!(super::plain(naga), "vec3<f64> for Function 'f' of [x]");
        assert_eq!(super::plain("Scalar(Scalar { kind: Uint, width: 4 })"), "u32");
    }

    #[test]
    fn a_fault_of_types_is_shown_with_a_caret() {
        let message = message("fn f(v: vec3<real>) -> real {\n    return v + v;\n}\n");
        assert!(message.starts_with("mine.wgsl:2:12: Function"), "{message}");
        assert!(message.ends_with("2 |     return v + v;\n               ^^^^^"), "{message}");
    }
}
