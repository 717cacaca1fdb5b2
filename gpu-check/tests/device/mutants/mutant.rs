//! Deliberate errors that the checks must notice: one operator, sign, comparison or constant changed in a module.
//!
//! A check that finds no error proves something only if it would find an existing one. Each mutant replaces a text that
//! occurs exactly once in its module.

use shaders::Library;

/// A mutant: a module with one deliberate error.
#[derive(Debug, serde::Deserialize)]
pub struct Mutant {
    /// The name of the module.
    pub module: String,
    /// The text of the module that the mutant replaces.
    pub from: String,
    /// The wrong text that replaces it.
    pub to: String,
}

/// Returns the mutants of the modules.
pub fn of_modules() -> Vec<Mutant> {
    read(include_str!("modules.csv"))
}

/// Returns the mutants of the arithmetic of f64 by integers, whose modules are the files of `shaders/wgsl/f64`.
pub fn of_arithmetic() -> Vec<Mutant> {
    read(include_str!("arithmetic.csv"))
}

fn read(table: &str) -> Vec<Mutant> {
    csv::Reader::from_reader(table.as_bytes()).deserialize().collect::<Result<_, _>>().expect("the table is valid")
}

impl Mutant {
    /// Returns the crate's modules with this error.
    ///
    /// # Errors
    /// [`shaders::Error::UnknownModule`] if there is no such module.
    ///
    /// # Panics
    /// If the text to replace does not occur exactly once in the module.
    pub fn library(&self) -> Result<Library, shaders::Error> {
        let mut library = Library::standard();
        let changed = self.changed(library.source(&self.module)?);
        library.replace(&self.module, &format!("{} (mutant)", self.module), changed)?;
        Ok(library)
    }

    /// Returns the module's text with this error.
    ///
    /// # Panics
    /// If the text to replace does not occur exactly once.
    pub fn changed(&self, source: &str) -> String {
        let count = source.matches(&self.from).count();
        assert_eq!(count, 1, "[{}] stands {count} times in {}", self.from, self.module);
        source.replace(&self.from, &self.to)
    }
}
