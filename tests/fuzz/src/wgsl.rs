//! Any bytes as a module that stands in for one of the project's own, as `shader-lab` takes it.
//!
//! The device is left out: everything before it is here, from the person's text to what a driver would be handed.

use naga::ShaderStage;
use naga::back::pipeline_constants::process_overrides;
use shaders::module::MODULES;
use shaders::{Error, Features, Library, Precision, Target, Validated, translate};

/// What a person calls the file.
const FILE: &str = "mine.wgsl";

/// A text is refused with a place that exists, or it is valid; a valid one takes any constants and is translated, or
/// refused in words, for every target.
///
/// The first byte chooses the module, the second the precision, whether the text replaces the module or is added to it,
/// and a value for its constants.
///
/// # Panics
/// When it does not hold.
pub fn check(bytes: &[u8]) {
    let [which, how, text @ ..] = bytes else { return };
    let module = &MODULES[usize::from(*which) % MODULES.len()];
    let precision = if how & 1 == 0 { Precision::F32 } else { Precision::F64 };
    let text = String::from_utf8_lossy(text);
    let text = if how & 2 == 0 { text.into_owned() } else { format!("{}\n{text}", module.source) };
    let mut library = Library::standard();
    library.replace(module.name, FILE, text.as_str()).expect("the module is from the list");
    let composition = library.compose(module.name, precision).expect("the module is from the list");
    match composition.validate() {
        Ok(shader) => {
            specialise(&shader, value(how >> 2));
            for target in Target::ALL {
                match translate(&shader, target, &Features::all(3)) {
                    Ok(_) => {}
                    Err(error) => assert!(!error.to_string().is_empty()),
                }
            }
        }
        Err(Error::Invalid(diagnostic)) => {
            assert!(!diagnostic.to_string().is_empty());
            let Some(place) = &diagnostic.place else { return };
            let files: Vec<_> = composition.parts().collect();
            let file = files.iter().find(|(path, _)| *path == place.file).expect("the place is in a file of it");
            let line = file.1.lines().nth(place.line - 1).expect("the file has that line");
            assert_eq!(line, place.text);
            assert!(place.column >= 1 && place.column <= line.chars().count() + 1);
        }
        Err(error) => panic!("{error}"),
    }
}

/// What a constant may be set to on the command line.
fn value(choice: u8) -> f64 {
    const VALUES: [f64; 8] = [0.0, 1.0, -1.0, 1e308, f64::NAN, f64::INFINITY, 4_294_967_295.0, 0.1];
    VALUES[usize::from(choice) % VALUES.len()]
}

/// Gives every constant the same value, as `--set` may.
fn specialise(shader: &Validated, value: f64) {
    let names = shader.module.overrides.iter().filter_map(|(_, constant)| constant.name.clone());
    let constants = names.map(|name| (name, value)).collect();
    for entry in shader.entry_points() {
        let entry = Some((ShaderStage::Compute, entry));
        // A value that a constant's type does not have is refused, not a panic.
        let _ = process_overrides(&shader.module, &shader.info, entry, &constants);
    }
}
