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
    ($($name:literal in $path:literal needs [$($need:literal)*];)*) => {
        /// All modules except the two that define `real`. [`crate::Precision`] chooses one of those two. Each module
        /// comes after all modules that it needs.
        pub const MODULES: &[Module] = &[$(Module {
            name: $name,
            path: $path,
            source: include_str!(concat!("../../", $path)),
            needs: &[$($need),*],
        }),*];
    };
}

modules! {
    "vec3" in "wgsl/vec3.wgsl" needs [];
    "exact" in "wgsl/exact.wgsl" needs [];
    "ray" in "wgsl/ray.wgsl" needs ["vec3"];
    "sphere" in "wgsl/sphere.wgsl" needs ["ray"];
    "unit_and_length" in "wgsl/unit_and_length.wgsl" needs ["vec3"];
    "tie" in "wgsl/tie.wgsl" needs [];
    "cylinder" in "wgsl/cylinder.wgsl" needs ["ray" "unit_and_length" "tie"];
    "projected" in "wgsl/projected.wgsl" needs ["sphere" "cylinder"];
    "camera" in "wgsl/camera.wgsl" needs ["ray"];
    "background" in "wgsl/background.wgsl" needs ["vec3"];
    "scatter" in "wgsl/scatter.wgsl" needs ["vec3"];
    "material" in "wgsl/material.wgsl" needs [];
    "features" in "wgsl/features.wgsl" needs [];
    "layout" in "wgsl/layout.wgsl" needs ["ray"];
    "picture" in "wgsl/picture.wgsl" needs ["layout" "sphere" "cylinder" "camera" "background" "material"];
    "surface" in "wgsl/surface.wgsl" needs ["picture" "features"];
    "every_object" in "wgsl/every_object.wgsl" needs ["surface"];
    "closest_hit" in "wgsl/closest_hit.wgsl" needs ["every_object"];
    "hierarchy" in "wgsl/hierarchy.wgsl" needs ["every_object"];
    "bounce" in "wgsl/bounce.wgsl" needs ["closest_hit" "scatter"];
    "trace" in "wgsl/trace.wgsl" needs ["bounce"];
    "uniform" in "wgsl/uniform.wgsl" needs [];
    "scatter_vectors" in "wgsl/scatter_vectors.wgsl" needs ["picture" "uniform"];
    "trace_samples" in "wgsl/trace_samples.wgsl" needs ["bounce" "scatter_vectors"];
    "exact/error_free" in "wgsl/exact/error_free.wgsl" needs ["exact"];
    "exact/error_bound" in "wgsl/exact/error_bound.wgsl" needs ["cylinder"];
    "exact/sphere" in "wgsl/exact/sphere.wgsl" needs ["sphere" "exact/error_bound"];
    "exact/compensated_roots" in "wgsl/exact/compensated_roots.wgsl"
        needs ["exact/sphere" "exact/error_free"];
    "exact/compensated_sphere" in "wgsl/exact/compensated_sphere.wgsl"
        needs ["exact/compensated_roots" "exact/error_free"];
    "exact/cylinder_side" in "wgsl/exact/cylinder_side.wgsl" needs ["exact/error_bound"];
    "exact/cap" in "wgsl/exact/cap.wgsl" needs ["exact/cylinder_side"];
    "exact/cylinder" in "wgsl/exact/cylinder.wgsl" needs ["exact/cap"];
    "exact/compensated_cylinder" in "wgsl/exact/compensated_cylinder.wgsl"
        needs ["exact/cylinder" "exact/compensated_roots" "exact/error_free"];
    "exact/order" in "wgsl/exact/order.wgsl" needs [];
    "kernels/hit_report" in "wgsl/kernels/hit_report.wgsl" needs ["layout"];
    "kernels/sphere" in "wgsl/kernels/sphere.wgsl" needs ["sphere" "kernels/hit_report"];
    "kernels/cylinder" in "wgsl/kernels/cylinder.wgsl" needs ["cylinder" "kernels/hit_report"];
    "kernels/projected_sphere" in "wgsl/kernels/projected_sphere.wgsl" needs ["projected" "kernels/hit_report"];
    "kernels/projected_cylinder" in "wgsl/kernels/projected_cylinder.wgsl" needs ["projected" "kernels/hit_report"];
    "kernels/camera" in "wgsl/kernels/camera.wgsl" needs ["camera" "layout"];
    "kernels/background" in "wgsl/kernels/background.wgsl" needs ["background" "layout"];
    "kernels/matte" in "wgsl/kernels/matte.wgsl" needs ["scatter" "layout"];
    "kernels/reflection" in "wgsl/kernels/reflection.wgsl" needs ["scatter" "layout"];
    "kernels/metal" in "wgsl/kernels/metal.wgsl" needs ["scatter" "layout"];
    "kernels/refraction" in "wgsl/kernels/refraction.wgsl" needs ["scatter" "layout"];
    "kernels/two_sum" in "wgsl/kernels/two_sum.wgsl" needs ["exact"];
    "kernels/mul_add" in "wgsl/kernels/mul_add.wgsl" needs ["exact/error_free"];
    "kernels/exact_report" in "wgsl/kernels/exact_report.wgsl" needs ["exact/error_bound"];
    "kernels/exact_sphere" in "wgsl/kernels/exact_sphere.wgsl"
        needs ["layout" "exact/compensated_sphere" "kernels/exact_report"];
    "kernels/exact_cylinder" in "wgsl/kernels/exact_cylinder.wgsl"
        needs ["layout" "exact/compensated_cylinder" "kernels/exact_report"];
    "kernels/exact_order" in "wgsl/kernels/exact_order.wgsl" needs ["layout" "exact/sphere" "exact/order"];
    "kernels/image" in "wgsl/kernels/image.wgsl" needs ["trace"];
    "kernels/steps" in "wgsl/kernels/steps.wgsl" needs ["bounce"];
    "kernels/samples" in "wgsl/kernels/samples.wgsl" needs ["trace_samples"];
    "kernels/means" in "wgsl/kernels/means.wgsl" needs ["layout"];
    "kernels/draws" in "wgsl/kernels/draws.wgsl" needs ["uniform"];
    "kernels/rays" in "wgsl/kernels/rays.wgsl" needs ["trace"];
}

/// The two modules that define the number type `real`.
pub const REALS: [Module; 2] = [
    Module {
        name: "real_f32",
        path: "wgsl/real_f32.wgsl",
        source: include_str!("../../wgsl/real_f32.wgsl"),
        needs: &[],
    },
    Module {
        name: "real_f64",
        path: "wgsl/real_f64.wgsl",
        source: include_str!("../../wgsl/real_f64.wgsl"),
        needs: &[],
    },
];

/// Returns the module with this name, or `None` if there is none.
#[must_use]
pub fn find(name: &str) -> Option<&'static Module> {
    MODULES.iter().chain(&REALS).find(|module| module.name == name)
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
                    assert!(MODULES.iter().chain(&REALS).any(|module| module.path == path), "{path} is not listed");
                    files += 1;
                }
            }
        }
        assert_eq!(files, MODULES.len() + REALS.len());
    }
}
