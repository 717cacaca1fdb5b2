//! Deliberate errors that the checks must notice: one operator, sign, comparison or constant changed in a module.
//!
//! A check that finds no error proves something only if it would find an existing one. Each mutant replaces a text that
//! occurs exactly once in its module. [`Examiner`] runs the suite's checks with fewer cases, and returns the first
//! check that notices the mutant.

mod examiner;
mod table;

pub use examiner::Examiner;
use table::{MUTANTS, exact};

use shaders::Library;

/// A mutant: a module with one deliberate error.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Mutant {
    /// The name of the module.
    pub module: &'static str,
    /// The text of the module that the mutant replaces.
    pub from: &'static str,
    /// The wrong text that replaces it.
    pub to: &'static str,
}

/// Returns all mutants that the checks must notice.
pub fn all() -> impl Iterator<Item = &'static Mutant> {
    MUTANTS.iter().chain(exact::MUTANTS)
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
        let changed = self.changed(library.source(self.module)?);
        library.replace(self.module, &format!("{} (mutant)", self.module), changed)?;
        Ok(library)
    }

    /// Returns the module's text with this error.
    ///
    /// # Panics
    /// If the text to replace does not occur exactly once.
    pub(crate) fn changed(&self, source: &str) -> String {
        let count = source.matches(self.from).count();
        assert_eq!(count, 1, "[{}] stands {count} times in {}", self.from, self.module);
        source.replace(self.from, self.to)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use shaders::module::MODULES;

    #[test]
    fn every_module_with_a_formula_has_a_mutant() {
        // Kernels only pass numbers to a formula and back, and features.wgsl has only declarations.
        let formulas =
            MODULES.iter().filter(|module| !module.name.starts_with("kernels/") && module.name != "features");
        for module in formulas {
            assert!(all().any(|mutant| mutant.module == module.name), "{} has none", module.name);
        }
    }
}
