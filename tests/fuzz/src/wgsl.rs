//! The fuzz target `wgsl`: uses any bytes as a WGSL module that replaces one of the project's, as `shader-lab` does.
//!
//! It runs every step from the user's text to the translations that a driver would get. It runs nothing on a device.

use naga::ShaderStage;
use naga::back::pipeline_constants::process_overrides;
use shaders::module::MODULES;
use shaders::{Error, Features, Library, Precision, Target, Validated, translate};

/// The name of the file with the user's text.
const FILE: &str = "mine.wgsl";

/// Checks that a text is valid, or that its error has a place that exists in the text. For a valid text, any constants
/// must cause no panic, and each target must translate it or refuse it with a message.
///
/// The first byte of `bytes` chooses the module. The second byte chooses the precision, whether the text replaces the
/// module or is appended to it, and a value for the constants.
///
/// # Panics
/// If a check fails.
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

/// Returns one of eight values for a constant of a shader. A user can set these values with `--set NAME=VALUE`.
fn value(choice: u8) -> f64 {
    const VALUES: [f64; 8] = [0.0, 1.0, -1.0, 1e308, f64::NAN, f64::INFINITY, 4_294_967_295.0, 0.1];
    VALUES[usize::from(choice) % VALUES.len()]
}

/// Sets every constant of a shader to `value`, as `--set` does.
fn specialise(shader: &Validated, value: f64) {
    let names = shader.module.overrides.iter().filter_map(|(_, constant)| constant.name.clone());
    let constants = names.map(|name| (name, value)).collect();
    for entry in shader.entry_points() {
        let entry = Some((ShaderStage::Compute, entry));
        // A value that the type of a constant cannot hold must give an error, not a panic.
        let _ = process_overrides(&shader.module, &shader.info, entry, &constants);
    }
}
