//! Tests of the messages for errors in a module, and of the places that the messages show.

use crate::{Error, Library, Precision};

/// Returns the message for the module `scatter` if `source` stands in for `module`, which it needs or is.
fn message_of(module: &str, source: &str, precision: Precision) -> String {
    let mut library = Library::standard();
    library.replace(module, "mine.wgsl", source).expect("it exists");
    let error = library.compose("scatter", precision).expect("it exists").validate();
    match error.expect_err(source) {
        Error::Invalid(diagnostic) => diagnostic.to_string(),
        other => panic!("{other}"),
    }
}

fn message(source: &str) -> String {
    message_of("scatter", source, Precision::F32)
}

#[test]
fn a_fault_of_grammar_or_of_types_is_shown_with_a_caret() {
    let grammar = message("// One.\nfn f() -> real {\n    return vec3_dat(1.0);\n}\n");
    assert!(grammar.starts_with("mine.wgsl:3:12: no definition in scope for identifier"), "{grammar}");
    assert!(grammar.ends_with("3 |     return vec3_dat(1.0);\n               ^^^^^^^^"), "{grammar}");
    let types = message("fn f(v: vec3<real>) -> real {\n    return v + v;\n}\n");
    assert!(types.starts_with("mine.wgsl:2:12: Function"), "{types}");
    assert!(types.ends_with("2 |     return v + v;\n               ^^^^^"), "{types}");
}

#[test]
fn a_brace_that_is_not_closed_is_shown_in_its_own_module() {
    let library = Library::standard();
    let text = library.source("vec3").expect("it exists").trim_end().strip_suffix('}').expect("a function ends it");
    let message = message_of("vec3", text, Precision::F32);
    assert!(message.starts_with("mine.wgsl:") && message.contains(": the `{` of this line has no `}`\n"), "{message}");
    let place: usize = message.split(':').nth(1).and_then(|line| line.parse().ok()).expect("it is a number");
    let lines = text.lines().count();
    assert!((lines - 5..=lines).contains(&place), "{message}");
}

#[test]
fn of_a_long_line_the_part_about_the_fault_is_shown() {
    let message = message(&format!("const a = {}; const b = missing; const c = {};", "1".repeat(999), "1".repeat(999)));
    let lines: Vec<_> = message.lines().collect();
    let [_, text, carets] = lines[..] else { panic!("{message}") };
    assert_eq!(text.chars().count(), "1 | ".len() + super::SHOWN, "{message}");
    let place = carets.find('^').expect("there is a caret");
    assert!(text[place..].starts_with('1') || text[place..].starts_with("missing"), "{message}");
}

#[test]
fn every_fault_in_a_replaced_module_is_shown_with_its_file_and_the_types_of_wgsl() {
    let faults = [
        "fn f() -> real {\n    return 1u;\n}\n",
        "fn f() -> vec3<real> {\n    return real(1.0);\n}\n",
        "fn f() -> real {\n    let x = 1u;\n}\n",
        "fn g(x: real) -> real { return x; }\nfn f() -> real {\n    return g(vec3<real>());\n}\n",
        "fn f() {\n    if real(1.0) { return; }\n}\n",
        "var<private> x: real = 1u;\n",
        "struct S { x: array<real> , y: real }\n",
        "fn f() -> real {\n    var x: vec2<real>;\n    x.x = 1u;\n    return x.x;\n}\n",
        "@compute @workgroup_size(1) fn f(x: real) {}\n",
        "fn f() -> bool {\n    return real(1.0);\n}\n",
        "fn f() -> real {",
        "fn f(x: nothing) {}",
        "fn f() -> real { return f(); }",
        "fn f(v: vec3<real>) -> vec3<real> {\n    return v * 1u;\n}\n",
        "fn f(v: vec3<real>) -> bool {\n    return v == 1u;\n}\n",
        "fn f(v: vec3<real>) -> vec3<real> {\n    return !v;\n}\n",
        "fn f(v: real) {\n    var x = vec2<real>();\n    x = v;\n}\n",
        "fn f(v: vec3<real>) -> real {\n    return v.w;\n}\n",
    ];
    for precision in Precision::ALL {
        for fault in faults {
            let message = message_of("scatter", fault, precision);
            assert!(message.starts_with("mine.wgsl:"), "{fault}{message}");
            let first = message.lines().next().unwrap_or_default();
            let of_naga = ["kind:", "Scalar", "Some(", " ["];
            assert!(!of_naga.iter().any(|word| first.contains(word)), "{message}");
            // An index that was left out leaves no hole after a word that needs a noun.
            for word in [" of", " in", " to", " with", " and", " for", " type"] {
                for hole in [" (", " doesn't", " can't", " is"] {
                    assert!(!first.contains(&format!("{word}{hole}")), "{message}");
                }
                assert!(!first.ends_with(word), "{message}");
            }
            if first.contains("real_") || precision == Precision::F32 {
                assert!(!first.contains("f64"), "{message}");
            }
        }
    }
}

#[test]
fn advice_that_leads_nowhere_is_not_repeated() {
    let cases = [
        ("// One.\nfn f() {", "mine.wgsl:2:9: expected statement, found \"\"\n"),
        ("enable f16;", "mine.wgsl:1:1: a module can have no directive such as `enable`, "),
        ("const a: f16 = 1.0h;", "mine.wgsl:1:16: this needs an extension, which a module cannot enable; use f32, "),
        ("const a = sqrt(-1.0);", "mine.wgsl:1:11: sqrt built-in function argument is out of valid range\n"),
        ("const a = 1 / 0;", "mine.wgsl:1:11: Division by zero\n"),
        ("\n@compute @workgroup_size(0)\nfn f() {}", "mine.wgsl:3:1: Entry point f at Compute is invalid: "),
        ("\nvar<private> big: array<u32, 1000000000>;", "mine.wgsl:2:1: Error laying out type: Size exceeds limit"),
        (
            "var<private> a: array<u32, 3>;\n\nvar<private> b: array<u32, 2000000000u>;\nvar<private> c: array<u32, 4>;",
            "mine.wgsl:3:1: type is too large: ",
        ),
    ];
    for (text, start) in cases {
        assert!(message(text).starts_with(start), "{text}: {}", message(text));
    }
    let nested = message(&format!("\nconst a = {}1{};", "(".repeat(300), ")".repeat(300)));
    assert!(nested.starts_with("mine.wgsl:2:") && nested.contains("nested too deeply"), "{nested}");
}

#[test]
fn a_type_is_named_as_wgsl_names_it() {
    let naga = "Vector { size: Tri, scalar: Scalar { kind: Float, width: 8 } } for Function [7] 'f' of [x]";
    assert_eq!(super::plain(naga), "vec3<f64> for Function 'f' of [x]");
    assert_eq!(super::plain("Scalar(Scalar { kind: Uint, width: 4 })"), "u32");
    assert_eq!(
        super::plain("The type of [3] doesn't match the type stored in [12]"),
        "The type of the value doesn't match the type stored in the target"
    );
    assert_eq!(
        super::plain("Operation Multiply can't work with [3] (of type u32) and [4] (of type f64)"),
        "Operation Multiply can't work with the operand (of type u32) and the operand (of type f64)"
    );
}
