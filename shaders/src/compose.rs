//! Combines a module and all modules that it needs into one text.
//!
//! WGSL has no imports, and names are unique over all modules of this crate, so concatenating the texts is enough. Each
//! module appears once, after all modules that it needs. The composition stores which lines came from which file.

use std::borrow::Cow;
use std::collections::BTreeMap;

use crate::lower::{self, Arithmetic};
use crate::module::{self, Module};
use crate::{Error, Precision, Validated};

/// The texts of all modules: the crate's own texts, or the texts that replace some of them.
#[derive(Clone, Debug, Default)]
pub struct Library {
    replaced: BTreeMap<&'static str, Replacement>,
    /// Modules that are composed in the place of others, by the names of the others.
    instead: BTreeMap<&'static str, &'static Module>,
}

/// The text that replaces a module's own text, and the path that messages show for it.
#[derive(Clone, Debug)]
struct Replacement {
    path: String,
    source: String,
}

impl Library {
    /// Returns the crate's own modules, without replacements.
    #[must_use]
    pub fn standard() -> Self {
        Self::default()
    }

    /// Replaces the text of the module `name` by `source`. Error messages show `path` as its file.
    ///
    /// # Errors
    /// [`Error::UnknownModule`] if there is no module `name`.
    pub fn replace(&mut self, name: &str, path: &str, source: impl Into<String>) -> Result<(), Error> {
        let module = find(name)?;
        self.replaced.insert(module.name, Replacement { path: path.to_owned(), source: source.into() });
        Ok(())
    }

    /// Returns this library, changed so that rays find their closest hit in a hierarchy of boxes.
    #[must_use]
    pub fn in_hierarchy(mut self) -> Self {
        self.instead.extend(find("hierarchy").map(|module| ("closest_hit", module)));
        self
    }

    /// Whether rays find their closest hit in a hierarchy of boxes.
    #[must_use]
    pub fn has_hierarchy(&self) -> bool {
        self.instead.contains_key("closest_hit")
    }

    /// Whether the text of the module `name` is replaced.
    #[must_use]
    pub fn is_replaced(&self, name: &str) -> bool {
        self.replaced.contains_key(name)
    }

    /// Returns the text of the module `name` in this library: its replacement, if it has one, or its own text.
    ///
    /// # Errors
    /// [`Error::UnknownModule`] if there is no module `name`.
    pub fn source(&self, name: &str) -> Result<&str, Error> {
        Ok(self.text(find(name)?).1)
    }

    /// Returns the text of the module `root` and of all modules that it needs. In this text `real` has the given
    /// `precision`.
    ///
    /// # Errors
    /// [`Error::UnknownModule`] if there is no module `root`.
    pub fn compose(&self, root: &str, precision: Precision) -> Result<Composition, Error> {
        let root = find(root)?;
        let modules = std::iter::once(find(precision.module())?).chain(module::needed(root, &self.instead));
        let (mut source, mut parts, mut line) = (String::new(), Vec::new(), 1);
        for module in modules {
            let (path, text) = self.text(module);
            // If a text has no line end, the next module would begin in its last line.
            let end = if text.ends_with('\n') { "" } else { "\n" };
            let is_replaced = self.replaced.contains_key(module.name);
            let own = is_replaced.then_some(module.source);
            parts.push(Part { path: path.into_owned(), first_line: line, is_replaced, own });
            source.push_str(text);
            source.push_str(end);
            line += text.lines().count();
        }
        let (root, is_lowered, allows_transcendental_f64) = (root.name, false, false);
        Ok(Composition { source, precision, root, parts, is_lowered, allows_transcendental_f64 })
    }

    /// Returns the path and the text of `module`, replaced or not.
    fn text<'a>(&'a self, module: &'a Module) -> (Cow<'a, str>, &'a str) {
        match self.replaced.get(module.name) {
            Some(replacement) => (Cow::Borrowed(&replacement.path), &replacement.source),
            None => (Cow::Owned(format!("shaders/{}", module.path)), module.source),
        }
    }
}

fn find(name: &str) -> Result<&'static Module, Error> {
    module::find(name).ok_or_else(|| Error::UnknownModule { name: name.to_owned() })
}

/// The joined text of several modules, which naga can read. It knows the file of each line.
#[derive(Clone, Debug)]
pub struct Composition {
    source: String,
    precision: Precision,
    root: &'static str,
    parts: Vec<Part>,
    /// Whether integers replace all f64.
    is_lowered: bool,
    /// Whether the validation accepts transcendental functions of f64.
    allows_transcendental_f64: bool,
}

/// The lines of one file in a composition. They end where the next file's lines begin.
#[derive(Clone, Debug)]
struct Part {
    path: String,
    first_line: usize,
    /// Whether the lines come from a replacement. An error is most likely in such lines.
    is_replaced: bool,
    /// The text of the crate's module that is replaced.
    own: Option<&'static str>,
}

impl Composition {
    /// Returns a composition of a single text, which another process has composed. Messages call its file "standard
    /// input".
    #[must_use]
    pub fn of_text(source: String, precision: Precision) -> Self {
        Self::of_file("standard input", source, precision)
    }

    /// Returns a composition of a single text. Messages show `path` as its file.
    #[must_use]
    pub fn of_file(path: &str, source: String, precision: Precision) -> Self {
        let part = Part { path: path.to_owned(), first_line: 1, is_replaced: true, own: None };
        let root = "standard input";
        Self { source, precision, root, parts: vec![part], is_lowered: false, allows_transcendental_f64: false }
    }

    /// Returns this composition, changed so that [`Self::validate`] accepts transcendental functions of f64. Drivers
    /// calculate them wrongly or crash, so use it only to find out what a driver does with them.
    #[must_use]
    pub fn allow_transcendental_f64(self) -> Self {
        Self { allows_transcendental_f64: true, ..self }
    }

    /// Whether transcendental functions of f64 are accepted.
    pub(crate) const fn allows_transcendental_f64(&self) -> bool {
        self.allows_transcendental_f64
    }

    /// Returns this composition without f64: its numbers of type f64 are pairs of u32, and `arithmetic` calculates with
    /// them. The layout of buffers, and the bits in them, stay the same.
    ///
    /// # Errors
    /// The errors of [`crate::lower::lower_text`].
    pub fn lowered(&self, arithmetic: &Arithmetic) -> Result<Self, Error> {
        let source = lower::lower(self, arithmetic)?;
        let part = Part { path: format!("{} (lowered)", self.root), first_line: 1, is_replaced: false, own: None };
        Ok(Self { source, parts: vec![part], is_lowered: true, ..self.clone() })
    }

    /// Returns this composition with the text `source`, whose lines come from the same files, followed by `more`.
    pub(crate) fn changed(&self, source: String, more: &str) -> Self {
        let part = Part {
            path: "call trace".to_owned(),
            first_line: source.lines().count() + 1,
            is_replaced: false,
            own: None,
        };
        let parts = self.parts.iter().cloned().chain([part]).collect();
        Self { source: source + more, parts, ..self.clone() }
    }

    /// Whether a device needs f64 to run this composition.
    #[must_use]
    pub fn needs_f64(&self) -> bool {
        self.precision == Precision::F64 && !self.is_lowered
    }

    /// Whether integers calculate f64 in this composition.
    #[must_use]
    pub const fn is_lowered(&self) -> bool {
        self.is_lowered
    }

    /// Returns the whole text of the composition.
    #[must_use]
    pub fn source(&self) -> &str {
        &self.source
    }

    /// Returns the path and the text of each file, in order. The joined texts are equal to [`Self::source`].
    pub fn parts(&self) -> impl Iterator<Item = (&str, String)> {
        let ends = self.parts.iter().skip(1).map(|part| part.first_line).chain([usize::MAX]);
        self.parts.iter().zip(ends).map(|(part, end)| {
            let lines = self.source.split_inclusive('\n').skip(part.first_line - 1).take(end - part.first_line);
            (part.path.as_str(), lines.collect())
        })
    }

    /// Returns the precision of the number type `real` in this composition.
    #[must_use]
    pub const fn precision(&self) -> Precision {
        self.precision
    }

    /// Returns the name of the module that was passed to [`Library::compose`].
    #[must_use]
    pub const fn root(&self) -> &'static str {
        self.root
    }

    /// Returns the file from which line number `line` of the composition came, and its line number in that file. Lines
    /// count from 1.
    #[must_use]
    pub fn origin(&self, line: usize) -> (&str, usize) {
        let part = self.part(line);
        (&part.path, (line + 1).saturating_sub(part.first_line))
    }

    /// Whether line number `line` of the composition belongs to a replaced module.
    pub(crate) fn is_replaced(&self, line: usize) -> bool {
        self.part(line).is_replaced
    }

    /// Returns the text of the crate's module that is replaced by the module of line number `line`.
    pub(crate) fn replaced_by(&self, line: usize) -> Option<&'static str> {
        self.part(line).own
    }

    /// Returns the part that line number `line` of the composition belongs to.
    fn part(&self, line: usize) -> &Part {
        self.parts.iter().rev().find(|part| part.first_line <= line).unwrap_or(&self.parts[0])
    }

    /// Returns the lines of all replaced modules, with their numbers in the composition.
    pub(crate) fn replaced_lines(&self) -> impl Iterator<Item = (usize, &str)> {
        (1..).zip(self.source.lines()).filter(|(line, _)| self.is_replaced(*line))
    }

    /// Parses and validates the text with naga.
    ///
    /// # Errors
    /// [`Error::Invalid`], with the place in the module's own file, or [`Error::NoStack`].
    pub fn validate(&self) -> Result<Validated, Error> {
        Validated::new(self)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_composition_holds_what_it_needs_once_and_nothing_else() {
        let composition = Library::standard().compose("sphere", Precision::F64).expect("it exists");
        for text in ["alias real = f64;", "fn vec3_dot", "fn ray_at", "fn sphere_intersect"] {
            assert_eq!(composition.source().matches(text).count(), 1, "{text}");
        }
        assert!(!composition.source().contains("cylinder_intersect"));
    }

    #[test]
    fn the_parts_joined_are_the_source() {
        let composition = Library::standard().compose("kernels/image", Precision::F32).expect("it exists");
        let parts: Vec<_> = composition.parts().collect();
        assert!(parts.len() > 10);
        assert_eq!(parts.iter().map(|(_, text)| text.as_str()).collect::<String>(), composition.source());
        let (path, text) = &parts[1];
        assert_eq!((*path, text.as_str()), ("shaders/wgsl/vec3.wgsl", module::find("vec3").expect("it exists").source));
    }

    #[test]
    fn a_module_can_be_replaced() {
        let mut library = Library::standard();
        library.replace("background", "mine.wgsl", "const mine = 1;").expect("it exists");
        let composition = library.compose("background", Precision::F32).expect("it exists");
        assert!(composition.source().ends_with("const mine = 1;\n"));
        let last = composition.source().lines().count();
        assert_eq!(composition.origin(last), ("mine.wgsl", 1));
        assert_eq!(library.source("background"), Ok("const mine = 1;"));
    }

    #[test]
    fn an_unknown_module_is_named_and_the_others_listed() {
        let error = Library::standard().compose("torus", Precision::F32).expect_err("there is none");
        assert!(error.to_string().starts_with("there is no WGSL module [torus]; there are: vec3, "), "{error}");
    }
}
