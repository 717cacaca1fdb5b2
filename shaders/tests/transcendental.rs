//! Transcendental functions of f64 are refused with their place, by the validation and by the lowering. Those of f32
//! are accepted.

use shaders::lower::{Arithmetic, lower_text};
use shaders::{Composition, Precision};

/// Functions of one argument.
const OF_ONE: [&str; 16] = [
    "sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "asinh", "acosh", "atanh", "exp", "exp2",
    "log", "log2",
];
/// Functions of two arguments.
const OF_TWO: [&str; 2] = ["atan2", "pow"];

/// Returns a call of each function with the variable `a` for all arguments.
fn calls() -> impl Iterator<Item = (&'static str, String)> {
    let of_one = OF_ONE.into_iter().map(|name| (name, format!("{name}(a)")));
    of_one.chain(OF_TWO.into_iter().map(|name| (name, format!("{name}(a, a)"))))
}

fn composition(source: &str) -> Composition {
    Composition::of_file("my.wgsl", source.to_owned(), Precision::F64)
}

#[test]
fn every_function_of_f64_is_refused_once_with_its_place() {
    let mut refused = 0;
    for (name, call) in calls() {
        for ty in ["f64", "vec3<f64>"] {
            let source = format!("fn f(a: {ty}) -> {ty} {{\n    return a +\n        {call};\n}}\n");
            let message = composition(&source).validate().expect_err("it is refused").to_string();
            let expected = format!(
                "my.wgsl:3:9: `{name}` of f64 is refused, because drivers calculate it wrongly or crash: compute it on \
                 the CPU or in f32\n3 |         {call};\n            {}",
                "^".repeat(name.len())
            );
            assert_eq!(message, expected);
            let lowered = lower_text("my.wgsl", &source, &Arithmetic::standard()).expect_err("it is refused");
            assert_eq!(lowered.to_string(), expected);
            refused += 1;
        }
    }
    assert_eq!(refused, 36);
}

#[test]
fn a_call_in_an_entry_point_is_refused_and_the_first_call_is_shown() {
    let source = "@group(0) @binding(0) var<storage, read_write> x: f64;\n\
        @compute @workgroup_size(1) fn main() {\n  x = f(x) + cos(x);\n}\n\
        fn f(a: f64) -> f64 {\n  return log(a);\n}\n";
    let message = composition(source).validate().expect_err("it is refused").to_string();
    assert!(message.starts_with("my.wgsl:3:14: `cos` of f64 is refused"), "{message}");
}

#[test]
fn functions_of_f32_and_other_functions_of_f64_are_accepted() {
    for (_, call) in calls() {
        let source = format!("fn f(a: f32, b: f64) -> f64 {{ return sqrt(b) + f64({call}); }}");
        composition(&source).validate().unwrap_or_else(|error| panic!("{error}"));
    }
}

#[test]
fn a_caller_can_allow_them_to_examine_a_driver() {
    let source = "fn f(a: f64) -> f64 { return sin(a); }";
    composition(source).allow_transcendental_f64().validate().expect("it is accepted");
}
