use super::*;
use crate::kernel::Reader;
use crate::kernels::KERNELS;
use shaders::{Library, Precision};

/// Functions without a twin: parts of functions that have one, and functions that read buffers.
const WITHOUT: [&str; 20] = [
    "bounce_attenuated",
    "cylinder_closer",
    "cylinder_side",
    "cylinder_with_caps",
    "hit_report",
    "hit_report_none",
    "intersect_cylinder",
    "intersect_every_object",
    "intersect_sphere",
    "is_closer",
    "projected_crossings",
    "sample_camera_ray",
    "scatter_vector_in_cube",
    "scatter_vector_next",
    "scatter_vector_published",
    "scatter_word",
    "sphere_first_root",
    "surface_at",
    "tie_is_closer",
    "tie_rank",
];

#[test]
fn every_function_has_a_twin_with_as_many_numbers_or_is_listed() {
    let mut names = Vec::new();
    let pictures = ["kernels/image", "kernels/steps", "kernels/samples"];
    for kernel in KERNELS.iter().map(|kernel| kernel.module).chain(pictures) {
        let composition = Library::standard().compose(kernel, Precision::F64).expect("it exists");
        for function in composition.with_call_trace().expect("it is valid").functions {
            let Some(twin) = twin::<f64>(&function.name) else {
                names.push(function.name);
                continue;
            };
            let arguments = vec![0.5; function.arguments.len()];
            // Functions of a picture have no result without one.
            if let Some(numbers) = twin(None, Arguments(Reader(&arguments))) {
                assert_eq!(numbers.len(), function.results.len(), "{}", function.name);
            }
        }
    }
    names.sort_unstable();
    names.dedup();
    assert_eq!(names, WITHOUT);
}
