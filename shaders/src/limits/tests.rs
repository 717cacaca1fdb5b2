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

/// The kinds of parts that can be nested or chained, and a text of each: its start, the part, the text between all
/// parts and their ends, the end of a part, and the end of the text.
const KINDS: [(&str, [&str; 5]); 9] = [
    ("not", ["fn f(b: bool) -> bool { return ", "!", "b; }", "", ""]),
    ("complement", ["fn f(b: i32) -> i32 { return ", "~", "b; }", "", ""]),
    ("sum", ["fn f(b: f32) -> f32 { return ", "1.0+", "b; }", "", ""]),
    ("parentheses", ["fn f(b: f32) -> f32 { return ", "(", "b", ")", "; }"]),
    ("calls", ["fn f(b: f32) -> f32 { return ", "abs(", "b", ")", "; }"]),
    ("else if", ["fn f(b: bool) { if b {} ", "else if b {} ", "}", "", ""]),
    ("blocks", ["fn f() { ", "{", "", "}", " }"]),
    ("else if with conditions", ["fn f(b: f32) { if true {} ", "else if (b+b < b) {} ", "}", "", ""]),
    ("arrays", ["const c = ", "array(", "1", ")", ";"]),
];

#[test]
fn naga_survives_every_nesting_up_to_the_limit_and_one_more_is_refused_with_its_place() {
    for (kind, [start, part, between, part_end, end]) in KINDS {
        let nested = |count| [start, &part.repeat(count), between, &part_end.repeat(count), end].concat();
        let excess = (1..=MAX_NESTING + 1).find(|&count| check(&nested(count)).is_err()).expect(kind);
        assert!(excess > MAX_NESTING / 10, "{kind}: {excess}");
        // naga may find the text invalid, but its stack must not overflow.
        if let Err(Error::Invalid(diagnostic)) = validate(&nested(excess - 1)) {
            assert!(!diagnostic.message.contains("nested in one statement"), "{kind}: {diagnostic}");
        }
        for count in [excess, 30_000] {
            let error = validate(&nested(count)).expect_err("it is nested too deeply").to_string();
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
