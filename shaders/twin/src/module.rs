//! The list of the WGSL modules, with the modules that each one needs.

use std::collections::{BTreeMap, BTreeSet};

/// A WGSL module, which is one file of the folder `wgsl`.
#[derive(Clone, Copy, Debug)]
pub struct Module {
    /// The module's name: the file's path in the folder `wgsl` without its ending, such as `kernels/image`.
    pub name: &'static str,
    /// The file's path, relative to the folder `shaders`.
    pub path: &'static str,
    /// The text of the file.
    pub source: &'static str,
    /// Names of the modules whose functions, types or constants this module uses. The modules that those modules need
    /// are not listed.
    pub needs: &'static [&'static str],
}

macro_rules! modules {
    ($($name:literal needs [$($need:literal)*];)*) => {
        &[$(Module {
            name: $name,
            path: concat!("wgsl/", $name, ".wgsl"),
            source: include_str!(concat!("../../wgsl/", $name, ".wgsl")),
            needs: &[$($need),*],
        }),*]
    };
}

/// All modules except the two that define `real`. [`crate::Precision`] chooses one of those two. Each module comes
/// after all modules that it needs.
pub const MODULES: &[Module] = modules! {
    "vec3" needs [];
    "exact" needs [];
    "ray" needs ["vec3"];
    "sphere" needs ["ray"];
    "unit_and_length" needs ["vec3"];
    "tie" needs [];
    "cylinder" needs ["ray" "unit_and_length" "tie"];
    "projected" needs ["sphere" "cylinder"];
    "camera" needs ["ray"];
    "background" needs ["vec3"];
    "scatter" needs ["vec3"];
    "material" needs [];
    "features" needs [];
    "layout" needs ["ray"];
    "picture" needs ["layout" "sphere" "cylinder" "camera" "background" "material"];
    "surface" needs ["picture" "features"];
    "every_object" needs ["surface"];
    "closest_hit" needs ["every_object"];
    "hierarchy" needs ["every_object"];
    "bounce" needs ["closest_hit" "scatter"];
    "trace" needs ["bounce"];
    "uniform" needs [];
    "scatter_vectors" needs ["picture" "uniform"];
    "trace_samples" needs ["bounce" "scatter_vectors"];
    "exact/error_free" needs ["exact"];
    "exact/error_bound" needs ["cylinder"];
    "exact/sphere" needs ["sphere" "exact/error_bound"];
    "exact/compensated_roots" needs ["exact/sphere" "exact/error_free"];
    "exact/compensated_sphere" needs ["exact/compensated_roots" "exact/error_free"];
    "exact/cylinder_side" needs ["exact/error_bound"];
    "exact/cap" needs ["exact/cylinder_side"];
    "exact/cylinder" needs ["exact/cap"];
    "exact/compensated_cylinder" needs ["exact/cylinder" "exact/compensated_roots" "exact/error_free"];
    "exact/order" needs [];
    "kernels/hit_report" needs ["layout"];
    "kernels/sphere" needs ["sphere" "kernels/hit_report"];
    "kernels/cylinder" needs ["cylinder" "kernels/hit_report"];
    "kernels/projected_sphere" needs ["projected" "kernels/hit_report"];
    "kernels/projected_cylinder" needs ["projected" "kernels/hit_report"];
    "kernels/camera" needs ["camera" "layout"];
    "kernels/background" needs ["background" "layout"];
    "kernels/matte" needs ["scatter" "layout"];
    "kernels/reflection" needs ["scatter" "layout"];
    "kernels/metal" needs ["scatter" "layout"];
    "kernels/refraction" needs ["scatter" "layout"];
    "kernels/two_sum" needs ["exact"];
    "kernels/mul_add" needs ["exact/error_free"];
    "kernels/exact_report" needs ["exact/error_bound"];
    "kernels/exact_sphere" needs ["layout" "exact/compensated_sphere" "kernels/exact_report"];
    "kernels/exact_cylinder" needs ["layout" "exact/compensated_cylinder" "kernels/exact_report"];
    "kernels/exact_order" needs ["layout" "exact/sphere" "exact/order"];
    "kernels/image" needs ["trace"];
    "kernels/steps" needs ["bounce"];
    "kernels/samples" needs ["trace_samples"];
    "kernels/means" needs ["layout"];
    "kernels/draws" needs ["uniform"];
    "kernels/rays" needs ["trace"];
};

/// The two modules that define the number type `real`.
pub const REALS: &[Module] = modules! {
    "real_f32" needs [];
    "real_f64" needs [];
};

/// Returns the module with this name, or `None` if there is none.
#[must_use]
pub fn find(name: &str) -> Option<&'static Module> {
    MODULES.iter().chain(REALS).find(|module| module.name == name)
}

/// Returns the modules that `root` needs, directly or indirectly, and `root` itself. Each module comes after all
/// modules that it needs. If `instead` has another module for a name, that one is taken in its place.
#[must_use]
pub fn needed(root: &Module, instead: &BTreeMap<&str, &'static Module>) -> Vec<&'static Module> {
    let mut names = BTreeSet::new();
    add_needed(root.name, instead, &mut names);
    MODULES.iter().filter(|module| names.contains(module.name)).collect()
}

fn add_needed(name: &'static str, instead: &BTreeMap<&str, &'static Module>, names: &mut BTreeSet<&'static str>) {
    if names.insert(name) {
        let needs = find(name).map_or(&[][..], |module| module.needs);
        let taken = needs.iter().map(|need| instead.get(need).map_or(*need, |module| module.name));
        taken.for_each(|need| add_needed(need, instead, names));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_module_stands_after_what_it_needs() {
        assert!(MODULES.len() > 20);
        for (place, module) in MODULES.iter().enumerate() {
            for need in module.needs {
                assert!(MODULES[..place].iter().any(|earlier| earlier.name == *need), "{} needs {need}", module.name);
            }
        }
    }

    #[test]
    fn every_file_is_a_module() {
        let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        let mut files = 0;
        for inner in ["wgsl", "wgsl/exact", "wgsl/kernels"] {
            for entry in std::fs::read_dir(folder.join(inner)).expect("the folder is there") {
                let name = entry.expect("the folder is readable").file_name().into_string().expect("names are ASCII");
                if name.ends_with(".wgsl") {
                    let path = format!("{inner}/{name}");
                    assert!(MODULES.iter().chain(REALS).any(|module| module.path == path), "{path} is not listed");
                    files += 1;
                }
            }
        }
        assert_eq!(files, MODULES.len() + REALS.len());
    }
}
