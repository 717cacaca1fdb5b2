//! Parses and validates a composition with naga.

use naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};
use naga::{AddressSpace, Module, ResourceBinding, StorageAccess, Type};

use crate::{Composition, Diagnostic, Error, Precision, limits, transcendental};

/// A buffer that a shader uses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Binding {
    /// The buffer's number in group 0.
    pub number: u32,
    /// Whether the shader writes to the buffer.
    pub written: bool,
    /// The least number of bytes that the buffer must have. An array without a length counts as one element.
    pub least_bytes: u64,
}

/// Returns every buffer that `module` binds.
pub(crate) fn bindings(module: &Module) -> impl Iterator<Item = Binding> {
    module.global_variables.iter().filter_map(|(_, variable)| {
        let written = match variable.space {
            AddressSpace::Storage { access } => access.contains(StorageAccess::STORE),
            _ => false,
        };
        let least_bytes = u64::from(module.types[variable.ty].inner.size(module.to_ctx()));
        variable.binding.map(|binding| Binding { number: binding.binding, written, least_bytes })
    })
}

/// A composition that naga has parsed and found valid.
#[derive(Clone, Debug)]
pub struct Validated {
    /// The parsed module, as naga represents it.
    pub module: Module,
    /// Results of naga's validator, which naga's writers need.
    pub info: ModuleInfo,
    /// The precision of `real`.
    pub precision: Precision,
    /// Whether a device needs f64 to run the shader.
    pub needs_f64: bool,
}

impl Validated {
    pub(crate) fn new(composition: &Composition) -> Result<Self, Error> {
        // f64 is allowed only where it is needed, so that other compositions run on devices without f64.
        let capabilities = if composition.needs_f64() { Capabilities::FLOAT64 } else { Capabilities::empty() };
        within_limits(composition, || Self::by_naga(composition, capabilities))
    }

    /// Returns the parsed module if it needs nothing but `capabilities`. Call it in [`within_limits`].
    pub(crate) fn by_naga(composition: &Composition, capabilities: Capabilities) -> Result<Self, Error> {
        let module = naga::front::wgsl::parse_str(composition.source())
            .map_err(|error| Error::Invalid(Box::new(Diagnostic::of_parsing(&error, composition))))?;
        refuse_foreign(&module, composition)?;
        let info = Validator::new(ValidationFlags::all(), capabilities)
            .validate(&module)
            .map_err(|error| Error::Invalid(Box::new(Diagnostic::of_validation(&error, &module, composition))))?;
        if !composition.allows_transcendental_f64() {
            transcendental::refuse(&module, &info, composition).map_err(Error::Invalid)?;
        }
        let (precision, needs_f64) = (composition.precision(), composition.needs_f64());
        Ok(Self { module, info, precision, needs_f64 })
    }

    /// Returns every buffer that the shader binds in group 0.
    pub fn bindings(&self) -> impl Iterator<Item = Binding> {
        bindings(&self.module)
    }

    /// Returns the size in bytes of the structure with this name, including the padding at its end. Returns `None` if
    /// there is no such structure.
    #[must_use]
    pub fn size_of(&self, structure: &str) -> Option<u32> {
        let is_it = |inner: &Type| inner.name.as_deref() == Some(structure);
        self.module
            .types
            .iter()
            .find(|(_, inner)| is_it(inner))
            .map(|(_, inner)| inner.inner.size(self.module.to_ctx()))
    }

    /// Returns the names of the entry points.
    #[must_use]
    pub fn entry_points(&self) -> Vec<&str> {
        self.module.entry_points.iter().map(|entry| entry.name.as_str()).collect()
    }
}

/// Refuses a buffer of a module that replaces another one, if the other module does not have it: nothing is bound to
/// it.
fn refuse_foreign(module: &Module, composition: &Composition) -> Result<(), Error> {
    for (handle, variable) in module.global_variables.iter() {
        let Some(ResourceBinding { group, binding }) = variable.binding else { continue };
        let span = module.global_variables.get_span(handle);
        let line = span.location(composition.source()).line_number;
        let Some(own) = composition.replaced_by(line as usize) else { continue };
        if group != 0 || !own.contains(&format!("@binding({binding})")) {
            let message = format!(
                "the module that this file replaces has no buffer @group({group}) @binding({binding}), so nothing is \
                 bound to [{}]; use a constant, or an `override` with --set",
                variable.name.as_deref().unwrap_or_default()
            );
            return Err(Error::Invalid(Box::new(Diagnostic::of_span(message, span, None, composition))));
        }
    }
    Ok(())
}

/// Checks the limits on the text of `composition`, and runs `work` on a thread with a stack of [`limits::STACK_BYTES`],
/// because the caller's stack may be too small for naga. Returns the result of `work`, or an error if a limit is
/// exceeded or if the thread cannot be started.
pub(crate) fn within_limits<R: Send>(
    composition: &Composition,
    work: impl FnOnce() -> Result<R, Error> + Send,
) -> Result<R, Error> {
    limits::check(composition.source())
        .map_err(|excess| Error::Invalid(Box::new(Diagnostic::of_excess(&excess, composition))))?;
    std::thread::scope(|scope| {
        let thread = std::thread::Builder::new().name("naga".to_owned()).stack_size(limits::STACK_BYTES);
        match thread.spawn_scoped(scope, work) {
            Ok(thread) => thread.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)),
            Err(cause) => Err(Error::NoStack { bytes: limits::STACK_BYTES, cause: cause.to_string() }),
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Library;
    use crate::module::MODULES;

    #[test]
    fn every_module_is_valid_with_what_it_needs_in_both_precisions_and_a_kernel_has_the_name_of_its_file() {
        let mut kernels = 0;
        for module in MODULES {
            for precision in Precision::ALL {
                let result = Library::standard().compose(module.name, precision).and_then(|whole| whole.validate());
                let shader = result.unwrap_or_else(|error| panic!("{} over {precision}:\n{error}", module.name));
                if let Some(name) = module.name.strip_prefix("kernels/").filter(|name| !name.ends_with("_report")) {
                    assert_eq!(shader.entry_points(), [name]);
                    kernels += 1;
                }
            }
        }
        assert!(kernels >= 20, "{kernels} kernels");
    }

    /// Whether the module `root` is valid if `text` stands in for the module `vec3`.
    fn is_valid(root: &str, text: &str, precision: Precision) -> bool {
        let mut library = Library::standard();
        library.replace("vec3", "mine.wgsl", text).expect("it exists");
        library.compose(root, precision).expect("it exists").validate().is_ok()
    }

    #[test]
    fn a_needed_module_that_is_not_listed_is_noticed() {
        // If a module is composed without one of the modules that it needs, it uses an unknown name, and naga refuses
        // it. So the test above finds a module missing from a list of needs.
        assert!(!is_valid("ray", "", Precision::F32));
    }

    #[test]
    fn a_buffer_that_the_replaced_module_lacks_is_shown_at_its_line() {
        let own = crate::module::find("trace").expect("it exists").source;
        let said = |more: &str| {
            let mut library = Library::standard();
            library.replace("trace", "my.wgsl", format!("{more}{own}")).expect("it exists");
            let whole = library.compose("kernels/image", Precision::F32).expect("it exists");
            whole.validate().map(drop).map_err(|error| error.to_string())
        };
        assert_eq!(said("// its own buffers\n"), Ok(()));
        for place in ["@group(0) @binding(9)", "@group(0) @binding(0)", "@group(1) @binding(5)"] {
            let message = said(&format!("\n{place} var<storage, read> mine: array<u32>;\n")).expect_err(place);
            assert!(
                message.starts_with("my.wgsl:2:") && message.contains(&format!("has no buffer {place}")),
                "{message}"
            );
        }
    }

    #[test]
    fn bindings_tell_what_is_written() {
        let composition = Library::standard().compose("kernels/sphere", Precision::F32).expect("it exists");
        let bindings: Vec<_> = composition.validate().expect("it is valid").bindings().collect();
        // A case has ten numbers of four bytes, and so has a result.
        let binding = |number, written| Binding { number, written, least_bytes: 40 };
        assert_eq!(bindings, [binding(0, false), binding(1, true)]);
    }

    #[test]
    fn the_f32_composition_uses_no_f64() {
        // The validator does not allow f64 in an f32 composition, so it refuses a literal of type f64.
        assert_eq!(Precision::ALL.map(|precision| is_valid("vec3", "const wide = 0.1lf;", precision)), [false, true]);
    }
}
