//! Tests modules whose f64 is lowered to integers: layout, names, translations, and refusals with their place.

use naga::valid::{Capabilities, ValidationFlags, Validator};
use naga::{ArraySize, Module, Scalar, Type, TypeInner};
use shaders::lower::{Arithmetic, lower_text};
use shaders::module::MODULES;
use shaders::{Composition, Error, Features, Library, Precision, Target, Translation, translate};

const EVERYTHING: &str = include_str!("lowered/everything.wgsl");

fn lower(source: &str) -> Result<String, Error> {
    lower_text("my.wgsl", source, &Arithmetic::standard())
}

/// Returns the module of a text that has no f64.
fn module_without_f64(text: &str) -> Module {
    let module = naga::front::wgsl::parse_str(text).unwrap_or_else(|error| panic!("{}", error.emit_to_string(text)));
    let capabilities = Capabilities::all() - Capabilities::FLOAT64;
    let mut validator = Validator::new(ValidationFlags::all(), capabilities);
    validator.validate(&module).unwrap_or_else(|error| panic!("{}", error.emit_to_string(text)));
    module
}

/// Returns the offset and the size of every number in a value of type `ty`. An array has the numbers of two elements,
/// and the last number is the size of the value.
fn numbers(module: &Module, ty: &Type) -> Vec<[u32; 2]> {
    let mut found = Vec::new();
    let inside = |offset: u32, ty: &Type| {
        numbers(module, ty).into_iter().map(move |[inner, size]| [offset + inner, size]).collect::<Vec<_>>()
    };
    match &ty.inner {
        TypeInner::Struct { members, span } => {
            let is_pair_of_words = |ty: &Type| matches!(ty.inner, TypeInner::Vector { scalar: Scalar::U32, .. });
            // A vector of f64 has become a structure of pairs of words. It takes no more than they do.
            let is_vector = members.iter().all(|member| is_pair_of_words(&module.types[member.ty]));
            for member in members {
                let mut own = inside(member.offset, &module.types[member.ty]);
                own.retain(|[_, size]| *size > 0);
                found.extend(own);
            }
            if !is_vector {
                found.push([*span, 0]);
            }
        }
        TypeInner::Array { base, size, stride } => {
            let count = if *size == ArraySize::Dynamic { 2 } else { 3 };
            for element in 0..count {
                let mut own = inside(element * stride, &module.types[*base]);
                own.retain(|[_, size]| *size > 0);
                found.extend(own);
            }
        }
        TypeInner::Vector { size, scalar: Scalar::F64 } => found.extend((0..*size as u32).map(|place| [8 * place, 8])),
        other => found.push([0, other.size(module.to_ctx())]),
    }
    found
}

/// Returns the numbers of every buffer of a module.
fn layout(module: &Module) -> Vec<(u32, Vec<[u32; 2]>)> {
    let of = |variable: &naga::GlobalVariable| {
        variable.binding.map(|binding| (binding.binding, numbers(module, &module.types[variable.ty])))
    };
    module.global_variables.iter().filter_map(|(_, variable)| of(variable)).collect()
}

#[test]
fn every_number_keeps_its_place_in_the_buffers() {
    let uniform = "struct Row { a: vec2<f64>, b: vec3<f64>, c: vec4<f64>, @size(64) d: f32, e: array<vec3<f64>, 3> }\n\
        @group(0) @binding(3) var<uniform> row: Row;\n@group(0) @binding(4) var<uniform> alone: vec3<f64>;\n\
        @compute @workgroup_size(1) fn main() { _ = row.e[1].x + alone.y; }\n";
    for source in [EVERYTHING, uniform] {
        let before = naga::front::wgsl::parse_str(source).expect("it is valid");
        let after = module_without_f64(&lower(source).expect("it can be lowered"));
        let (before, after) = (layout(&before), layout(&after));
        assert!(before.iter().map(|(_, numbers)| numbers.len()).sum::<usize>() > 15);
        assert_eq!(before, after);
    }
}

#[test]
fn programs_find_overrides_and_entry_points_by_their_names() {
    let module = module_without_f64(&lower(EVERYTHING).expect("it can be lowered"));
    let overrides: Vec<_> = module.overrides.iter().filter_map(|(_, constant)| constant.name.as_deref()).collect();
    assert_eq!(overrides, ["scale2", "n", "flag"]);
    assert_eq!(module.entry_points[0].name, "every2");
    assert_eq!(module.entry_points[0].workgroup_size, [64, 1, 1]);
}

#[test]
fn what_a_program_may_use_stays_and_unused_arithmetic_goes() {
    let source = "override unused: u32 = 1u;\n@group(0) @binding(7) var<storage> nothing: array<f64>;\n\
        fn helper(a: f64) -> f64 { return a + 1.0lf; }\n";
    let lowered = lower(source).expect("it can be lowered");
    for kept in ["override unused: u32", "@binding(7)", "fn helper(", "fn f64_add("] {
        assert!(lowered.contains(kept), "{kept} is missing:\n{lowered}");
    }
    assert!(!lowered.contains("f64_divide") && !lowered.contains("keeper"), "{lowered}");
}

#[test]
fn every_kernel_can_be_translated_into_every_language() {
    let (library, arithmetic) = (Library::standard(), Arithmetic::standard());
    let mut translated = 0;
    for module in MODULES.iter().filter(|module| module.name.starts_with("kernels/")) {
        let composition = library.compose(module.name, Precision::F64).and_then(|whole| whole.lowered(&arithmetic));
        let composition = composition.unwrap_or_else(|error| panic!("{error}"));
        assert!(!composition.needs_f64());
        let shader = composition.validate().unwrap_or_else(|error| panic!("{}: {error}", module.name));
        if shader.entry_points().is_empty() {
            continue;
        }
        for target in Target::ALL {
            match translate(&shader, target, &Features::all(5)).unwrap_or_else(|error| panic!("{error}")) {
                Translation::Text(text) => {
                    // The names of the exact modules have the word "double" too, so whole names are compared.
                    let mut names = text.split(|letter: char| !letter.is_alphanumeric() && letter != '_');
                    let is_wide = |name: &str| name.trim_end_matches(['2', '3', '4']) == "double";
                    assert!(!names.any(is_wide), "{} in {target}", module.name);
                }
                Translation::Words(words) => {
                    // OpCapability Float64 would be the words 0x00020011 and 10.
                    assert!(!words.windows(2).any(|pair| pair == [0x0002_0011, 10]), "{}", module.name);
                }
            }
            translated += 1;
        }
    }
    println!("{translated} translations");
    assert!(translated >= 60);
}

#[test]
fn what_has_no_form_in_integers_or_is_not_valid_is_refused_with_its_place() {
    const NONE: &str = "cannot be lowered to integers";
    let expression = |body: &str| format!("\nfn f(x: f64, n: u32) -> f64 {{\n  return {body};\n}}");
    for (text, place, what) in [
        (&*expression("ldexp(x, 3)"), "3:10", "`ldexp` of f64 cannot be lowered to integers"),
        (&expression("f64(i64(x))"), "3:14", "a conversion of f64 to i64 cannot be lowered to integers"),
        (&expression("f64(u64(n))"), "3:10", "a conversion of u64 to f64 cannot be lowered to integers"),
        ("\nvar<private> m: mat3x3<f64>;", "2:1", NONE),
        ("\noverride n = 3u;\nvar<workgroup> a: array<f64, n>;", "3:1", NONE),
        ("\noverride a: f64 = 1.0lf;", "2:1", NONE),
        ("\nstruct S { a: vec3<f64>, b: f64 }\n@group(0) @binding(0) var<uniform> s: S;", "3:23", NONE),
        ("\nfn f() {\n  let m = mat2x2<f64>(1.0lf, 2.0lf, 3.0lf, 4.0lf);\n}", "3:11", NONE),
        ("\nfn f() {\n  var m: array<mat2x3<f64>, 2>;\n}", "3:3", NONE),
        ("\nfn f(a: f64,\n     m: ptr<function, mat4x4<f64>>) {}", "3:6", NONE),
        ("const a = 1;\nstruct S { a: f64,\n  m: mat2x2<f64> }\nvar<private> s: S;", "2:1", NONE),
        ("\nvar<workgroup> a: atomic<u32>;", "2:1", NONE),
        ("@group(0) @binding(0) var t: texture_2d<f32>;", "1:23", NONE),
        ("\nfn f(x: f32) -> f32 {\n  return dpdx(x);\n}", "3:10", NONE),
        ("\nvar<workgroup> a: u32;\nfn f() -> u32 {\n  return workgroupUniformLoad(&a);\n}", "4:10", NONE),
        ("override n = 3u;\n@compute @workgroup_size(n) fn main() {}", "2:1", NONE),
        ("fn f() -> f64 { return 1.0lf + }", "1:32", "expected expression"),
        ("\nvar<private> small: u32;\nvar<private> a: array<u32, 4294967295>;", "3:1", "Size exceeds"),
        ("\n\nfn f() {\n  var a: array<u32, 4294967295>;\n}", "4:3", "Size exceeds"),
        ("\n@compute\n@workgroup_size(0)\nfn main() {}", "4:1", "orkgroup"),
    ] {
        let error = lower(text).expect_err("it is refused").to_string();
        assert!(error.starts_with(&format!("my.wgsl:{place}: ")) && error.contains(what), "{place}: {error}");
    }
}

#[test]
fn a_text_that_is_too_deep_for_naga_is_refused_with_its_place() {
    for (start, part) in [("\nfn f(x: f32) -> f32 {\n  return ", "("), ("\nfn f(x: f32) -> f32 {\n  return ", "abs(")] {
        let text = |count: usize| format!("{start}{}x{}; }}", part.repeat(count), ")".repeat(count));
        let most = (1..250).rfind(|&count| lower(&text(count)).is_ok()).expect("a few are accepted");
        let error = lower(&text(most + 1)).expect_err("it is too deep").to_string();
        println!("{most} {error}");
        // The innermost parenthesis or its operand is the first that is too deep.
        let [first, last] = [most, most + 1].map(|count| "  return ".len() + part.len() * count + 1);
        let columns = error.strip_prefix("my.wgsl:3:").and_then(|rest| rest.split(':').next()?.parse().ok());
        let column: usize = columns.unwrap_or_else(|| panic!("{error}"));
        assert!((first..=last).contains(&column), "{column} {error}");
        assert!(error.contains("this is nested too deeply for naga; use several statements"), "{error}");
    }
}

#[test]
fn changed_texts_are_lowered_or_refused_without_a_panic() {
    let words: Vec<_> = EVERYTHING.split_inclusive(|character: char| !character.is_alphanumeric()).collect();
    let (mut lowered, mut refused) = (0, 0);
    for place in (0..words.len()).step_by(3) {
        let mut changed = words.clone();
        let other = words[(place * 7 + 3) % words.len()];
        changed[place] = if place % 2 == 0 { other } else { "" };
        match lower(&changed.concat()) {
            Ok(text) => {
                module_without_f64(&text);
                lowered += 1;
            }
            Err(_) => refused += 1,
        }
    }
    println!("{lowered} changed texts lowered, {refused} refused");
    assert!(lowered > 20 && refused > 100);
}

#[test]
fn a_lowered_text_has_nothing_to_lower() {
    let once = lower(EVERYTHING).expect("it can be lowered");
    let twice = lower(&once).expect("it is valid");
    assert_eq!(once.matches("fn ").count(), twice.matches("fn ").count());
    let composition = Composition::of_file("once.wgsl", once, Precision::F32);
    composition.validate().unwrap_or_else(|error| panic!("{error}"));
}
