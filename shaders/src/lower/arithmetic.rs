//! The arithmetic of binary64 in integers: the files of `shaders/wgsl/f64`.

use naga::Module;

use crate::{Composition, Diagnostic, Error, Precision};

/// The files, with their names. Each holds one idea, and uses those before it.
const FILES: [(&str, &str); 10] = [
    ("integers", include_str!("../../wgsl/f64/integers.wgsl")),
    ("parts", include_str!("../../wgsl/f64/parts.wgsl")),
    ("add", include_str!("../../wgsl/f64/add.wgsl")),
    ("multiply", include_str!("../../wgsl/f64/multiply.wgsl")),
    ("fma", include_str!("../../wgsl/f64/fma.wgsl")),
    ("whole", include_str!("../../wgsl/f64/whole.wgsl")),
    ("divide", include_str!("../../wgsl/f64/divide.wgsl")),
    ("square_root", include_str!("../../wgsl/f64/square_root.wgsl")),
    ("compare", include_str!("../../wgsl/f64/compare.wgsl")),
    ("convert", include_str!("../../wgsl/f64/convert.wgsl")),
];

/// The texts of the arithmetic. Tests change one of them to see that the change is noticed.
#[derive(Clone, Debug)]
pub struct Arithmetic {
    files: Vec<(&'static str, String)>,
}

impl Arithmetic {
    /// Returns the crate's own arithmetic.
    #[must_use]
    pub fn standard() -> Self {
        Self { files: FILES.iter().map(|(name, text)| (*name, (*text).to_owned())).collect() }
    }

    /// Returns the names of the files, without their ending.
    pub fn names(&self) -> impl Iterator<Item = &'static str> {
        self.files.iter().map(|(name, _)| *name)
    }

    /// Returns the text of the file `name`, or `None` if there is no such file.
    #[must_use]
    pub fn source(&self, name: &str) -> Option<&str> {
        self.files.iter().find(|(file, _)| *file == name).map(|(_, text)| text.as_str())
    }

    /// Replaces the text of the file `name`. Does nothing if there is no such file.
    pub fn replace(&mut self, name: &str, source: String) {
        if let Some((_, text)) = self.files.iter_mut().find(|(file, _)| *file == name) {
            *text = source;
        }
    }

    /// Returns all files as one module.
    pub(crate) fn module(&self) -> Result<Module, Error> {
        let source: String = self.files.iter().map(|(_, text)| text.as_str()).collect();
        let composition = Composition::of_file("shaders/wgsl/f64", source, Precision::F32);
        naga::front::wgsl::parse_str(composition.source())
            .map_err(|error| Error::Invalid(Box::new(Diagnostic::of_parsing(&error, &composition))))
    }
}
