//! Tests that texts at each limit are accepted, and that texts beyond it are refused.

use super::*;
use crate::module::MODULES;
use crate::{Error, Library, Precision};

/// Validates `text` in place of the module `scatter`, together with the modules that `scatter` needs.
fn validate(text: &str) -> Result<(), Error> {
    let mut library = Library::standard();
    library.replace("scatter", "mine.wgsl", text).expect("the module exists");
    library.compose("scatter", Precision::F32).expect("the module exists").validate().map(drop)
}

/// Returns a text in which `count` operators, brackets or branches of the kind `kind` are nested or chained.
fn nested(kind: &str, count: usize) -> String {
    let chain = |part: &str| part.repeat(count);
    match kind {
        "not" => format!("fn f(b: bool) -> bool {{ return {}b; }}", chain("!")),
        "complement" => format!("fn f(b: i32) -> i32 {{ return {}b; }}", chain("~")),
        "sum" => format!("fn f(b: f32) -> f32 {{ return {}b; }}", chain("1.0+")),
        "parentheses" => format!("fn f(b: f32) -> f32 {{ return {}b{}; }}", chain("("), chain(")")),
        "calls" => format!("fn f(b: f32) -> f32 {{ return {}b{}; }}", chain("abs("), chain(")")),
        "else if" => format!("fn f(b: bool) {{ if b {{}} {} }}", chain("else if b {} ")),
        "blocks" => format!("fn f() {{ {}{} }}", chain("{"), chain("}")),
        "else if with conditions" => format!("fn f(b: f32) {{ if true {{}} {} }}", chain("else if (b+b < b) {} ")),
        _ => format!("const c = {}1{};", chain("array("), chain(")")),
    }
}

const KINDS: [&str; 9] =
    ["not", "complement", "sum", "parentheses", "calls", "else if", "blocks", "else if with conditions", "arrays"];

/// Returns the largest count of nested parts of the kind `kind` that [`check`] accepts.
fn largest(kind: &str) -> usize {
    let excess = (1..=MAX_NESTING + 1).find(|&count| check(&nested(kind, count)).is_err());
    excess.unwrap_or_else(|| panic!("{kind}: any count is taken")) - 1
}

#[test]
fn naga_survives_every_nesting_up_to_the_limit() {
    for kind in KINDS {
        let most = largest(kind);
        assert!(most >= MAX_NESTING / 10, "{kind}: {most}");
        // naga may find the text invalid, but its stack must not overflow.
        if let Err(Error::Invalid(diagnostic)) = validate(&nested(kind, most)) {
            assert!(!diagnostic.message.contains("nested in one statement"), "{kind}: {diagnostic}");
        }
    }
}

#[test]
fn one_nesting_more_is_refused_with_its_place() {
    for kind in KINDS {
        for count in [largest(kind) + 1, 30_000] {
            let error = validate(&nested(kind, count)).expect_err("it is nested too deeply").to_string();
            assert!(error.starts_with("mine.wgsl:1:"), "{kind}: {error}");
            assert!(error.contains("more than 500 brackets, operators or branches"), "{kind}: {error}");
        }
    }
}

#[test]
fn the_longest_chain_of_constants_is_read_in_either_order() {
    // The modules that the composition needs use up a part of the tokens.
    let scatter = Library::standard().compose("scatter", Precision::F32).expect("the module exists");
    let room = MAX_TOKENS - tokens(scatter.source().as_bytes()).count();
    let chain: Vec<String> = (1..room / 5).map(|i| format!("const a{i} = a{};\n", i - 1)).collect();
    let backwards: String = chain.iter().rev().map(String::as_str).collect();
    for text in [format!("const a0 = 1;\n{}", chain.concat()), format!("{backwards}const a0 = 1;\n")] {
        validate(&text).unwrap_or_else(|error| panic!("{error}"));
    }
}

#[test]
fn the_number_of_tokens_is_counted_exactly() {
    assert_eq!(check(&";".repeat(MAX_TOKENS)), Ok(()));
    let excess = check(&"; ".repeat(MAX_TOKENS + 1)).expect_err("it has one too many");
    assert_eq!(excess.offset, 2 * MAX_TOKENS);
}

#[test]
fn statements_elements_and_comments_do_not_nest() {
    let texts = [
        format!("fn f() {{ {} }}", "if true { let a = 1 + 2; } ".repeat(2000)),
        format!("const a = array({});", "-1.0, ".repeat(2000)),
        format!("// {}\n/* {} /* ( */ {} */", "(".repeat(2000), "!".repeat(2000), "[".repeat(2000)),
        "struct s { a: f32 }\n".repeat(2000),
    ];
    for text in texts {
        assert_eq!(check(&text), Ok(()), "{}", &text[..40]);
    }
}

#[test]
fn operators_after_a_deep_operand_count_in_addition_to_its_nesting() {
    let deep = format!("{}1{}", "(".repeat(MAX_NESTING - 10), ")".repeat(MAX_NESTING - 10));
    assert_eq!(check(&format!("const a = {deep};")), Ok(()));
    assert!(check(&format!("const a = {deep}{};", " + 1".repeat(20))).is_err());
}

#[test]
fn brackets_that_do_not_match_are_left_to_naga() {
    for text in [")", "}}}}((", "(]", "/* never closed", "*/"] {
        assert_eq!(check(text), Ok(()), "{text}");
    }
}

#[test]
fn the_crates_own_modules_stay_far_below_the_limits() {
    let library = Library::standard();
    let mut most = 0;
    for module in MODULES {
        let composition = library.compose(module.name, Precision::F64).expect("the module exists");
        assert_eq!(check(composition.source()), Ok(()), "{}", module.name);
        most = most.max(tokens(composition.source().as_bytes()).count());
    }
    assert!((1000..MAX_TOKENS / 2).contains(&most), "{most}");
}
