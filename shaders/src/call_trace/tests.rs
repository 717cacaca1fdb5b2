use super::*;
use crate::{Library, Precision};

#[test]
fn every_function_with_a_result_is_recorded_in_both_precisions() {
    for root in ["kernels/image", "kernels/steps", "kernels/samples", "kernels/cylinder"] {
        for precision in Precision::ALL {
            let composition = Library::standard().compose(root, precision).expect("it exists");
            let trace = composition.with_call_trace().expect("it is valid");
            let module = composition.validate().expect("it is valid").module;
            let with_result = module.functions.iter().filter(|(_, function)| function.result.is_some()).count();
            assert_eq!(trace.functions.len(), with_result, "{root}");
        }
    }
}

#[test]
fn a_record_names_its_numbers_and_lines() {
    let composition = Library::standard().compose("kernels/sphere", Precision::F64).expect("it exists");
    let CallTrace { composition: traced, functions, binding, .. } = composition.with_call_trace().expect("it is valid");
    assert_eq!(binding, 2, "the kernel has two buffers");
    let recorded = functions.iter().find(|function| function.name == "ray_at").expect("it is called");
    let names = |numbers: &[Number]| numbers.iter().map(|number| number.name.clone()).collect::<Vec<_>>().join(" ");
    assert_eq!(
        names(&recorded.arguments),
        "ray.origin.x ray.origin.y ray.origin.z ray.direction.x ray.direction.y ray.direction.z lambda"
    );
    assert_eq!(names(&recorded.results), "call_trace_result.x call_trace_result.y call_trace_result.z");
    let lines: Vec<_> = composition.source().lines().collect();
    let [first, last] = recorded.lines;
    assert!(lines[first - 1].starts_with("fn ray_at(") && lines[last - 1] == "}" && last == first + 2);
    // All lines have the same origins as before.
    assert_eq!(traced.origin(first), composition.origin(first));
    assert!(traced.source().lines().nth(first - 1).is_some_and(|line| line.starts_with("fn ray_at_called(")));
}

#[test]
fn comments_and_names_that_only_contain_the_name_are_no_declarations() {
    let source = "// fn f(\n/* fn f( */ fn ff(x: u32) -> u32 { return x; }\nfn f( // no { here\n x: u32) -> u32 { \
        if x > 0u { return ff(x); } return 1u; }\n@compute @workgroup_size(1) fn main() { _ = f(1u); }\n";
    let composition = Composition::of_file("my.wgsl", format!("alias real = f32;\n{source}"), Precision::F32);
    let trace = composition.with_call_trace().expect("it is valid");
    let places: Vec<_> = trace.functions.iter().map(|function| (function.name.as_str(), function.lines)).collect();
    assert_eq!(places, [("ff", [3, 3]), ("f", [4, 5])]);
}

#[test]
fn pointers_are_not_recorded() {
    let source = "alias real = f32;\nfn add(p: ptr<function, u32>) -> u32 { *p += 1u; return *p; }\n\
        @compute @workgroup_size(1) fn main() { var x = 1u; _ = add(&x); }\n";
    let trace = Composition::of_file("my.wgsl", source.to_owned(), Precision::F32).with_call_trace();
    assert_eq!(trace.map(|trace| trace.functions.len()), Ok(0));
}
