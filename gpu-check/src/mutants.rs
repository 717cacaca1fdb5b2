//! Faults that the checks must notice: one operator, sign, comparison or constant changed in a module.
//!
//! A check that finds no fault proves something only if it finds the faults that there are. Each mutant replaces a text
//! that stands in its module exactly once. [`Examiner`] runs the suite's checks with fewer cases, and tells which check
//! was the first to notice the mutant.

mod examiner;
mod table;

pub use examiner::Examiner;
pub use table::MUTANTS;

use shaders::Library;

/// A module with one fault.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Mutant {
    /// The module's name.
    pub module: &'static str,
    /// The text that is replaced.
    pub from: &'static str,
    /// The text that replaces it.
    pub to: &'static str,
}

impl Mutant {
    /// The crate's modules with this fault.
    ///
    /// # Errors
    /// [`shaders::Error::UnknownModule`].
    ///
    /// # Panics
    /// When the text to replace does not stand in the module exactly once.
    pub fn library(&self) -> Result<Library, shaders::Error> {
        let mut library = Library::standard();
        let source = library.source(self.module)?;
        let count = source.matches(self.from).count();
        assert_eq!(count, 1, "[{}] stands {count} times in {}", self.from, self.module);
        let changed = source.replace(self.from, self.to);
        library.replace(self.module, &format!("{} (mutant)", self.module), changed)?;
        Ok(library)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use shaders::Precision;
    use shaders::module::MODULES;
    use std::collections::BTreeSet;

    #[test]
    fn every_mutant_is_a_valid_and_different_shader() {
        for mutant in MUTANTS {
            assert_ne!(mutant.from, mutant.to);
            let library = mutant.library().expect("its module exists");
            for precision in Precision::ALL {
                let result = library.compose(mutant.module, precision).and_then(|composition| composition.validate());
                result.unwrap_or_else(|error| panic!("{mutant:?}: {error}"));
            }
        }
        assert!(MUTANTS.len() >= 25);
        let different: BTreeSet<_> = MUTANTS.iter().map(|mutant| (mutant.module, mutant.from, mutant.to)).collect();
        assert_eq!(different.len(), MUTANTS.len());
    }

    #[test]
    fn every_module_with_a_formula_has_a_mutant() {
        // Kernels only carry numbers to a formula and back, and features.wgsl holds declarations alone.
        let formulas =
            MODULES.iter().filter(|module| !module.name.starts_with("kernels/") && module.name != "features");
        for module in formulas {
            assert!(MUTANTS.iter().any(|mutant| mutant.module == module.name), "{} has none", module.name);
        }
    }
}
