//! The WGSL modules that the page composes and edits, as JSON.

use std::collections::BTreeMap;

use serde::Serialize;
use twin::module::{MODULES, REALS, needed};

/// A module as the page reads it.
#[derive(Serialize)]
struct Text {
    name: &'static str,
    path: String,
    source: &'static str,
    /// The names of the modules that a composition of this module joins, in their order, with this module as the last.
    needed: Vec<&'static str>,
}

/// Returns all modules as a JSON list. A composition begins with `real_f32`, which is the first module of the list.
pub fn json() -> Vec<u8> {
    let texts = REALS[..1].iter().chain(MODULES).map(|module| Text {
        name: module.name,
        path: format!("shaders/{}", module.path),
        source: module.source,
        needed: needed(module, &BTreeMap::new()).iter().map(|module| module.name).collect(),
    });
    // Serialising texts into memory never fails.
    serde_json::to_vec(&texts.collect::<Vec<_>>()).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_composition_joins_what_a_module_needs_with_the_module_as_the_last() {
        let list: serde_json::Value = serde_json::from_slice(&json()).expect("it is JSON");
        let of = |name: &str| {
            let list = list.as_array().expect("it is a list");
            list.iter().find(|text| text["name"] == name).expect("the module exists").clone()
        };
        assert_eq!(list[0]["name"], "real_f32");
        assert_eq!(of("sphere")["needed"], serde_json::json!(["vec3", "ray", "sphere"]));
        assert_eq!(of("kernels/image")["path"], "shaders/wgsl/kernels/image.wgsl");
        assert!(of("vec3")["source"].as_str().is_some_and(|source| source.contains("fn vec3_dot")));
    }
}
