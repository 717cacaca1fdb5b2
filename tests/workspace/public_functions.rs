//! Checks that every public function of `cpu` and `cli` is named by a unit test, by a test program of its crate, or by
//! an example of the documentation.

use std::collections::BTreeSet;

use test_support::project_root;

use crate::files;

/// Returns the name of the public function that begins in this line.
fn public_function(line: &str) -> Option<&str> {
    let (before, after) = line.trim_start().strip_prefix("pub ")?.split_once("fn ")?;
    let end = after.find(|letter: char| !(letter.is_alphanumeric() || letter == '_'))?;
    before.split_whitespace().all(|word| ["const", "unsafe"].contains(&word)).then_some(&after[..end])
}

/// Divides a source into code and unit tests. The examples of the documentation count as tests.
fn divided(source: &str) -> (&str, String) {
    let (code, tests) = source.split_once("#[cfg(test)]\nmod tests {").unwrap_or((source, ""));
    let comments: String = code.lines().filter(|line| line.trim_start().starts_with("//")).collect();
    (code, comments.split("```").skip(1).step_by(2).chain([tests]).collect())
}

/// Returns the public functions of these sources that no test names. A source of tests is marked by true.
fn unnamed(sources: &[(bool, String)]) -> Vec<String> {
    let (mut functions, mut tests) = (BTreeSet::new(), String::new());
    for (is_tests, source) in sources {
        let (code, own_tests) = if *is_tests { ("", source.clone()) } else { divided(source) };
        functions.extend(code.lines().filter_map(public_function));
        tests += &own_tests;
    }
    let is_part = |letter: char| letter.is_alphanumeric() || letter == '_';
    let named: BTreeSet<&str> = tests.split(|letter| !is_part(letter)).collect();
    functions.difference(&named).map(|&name| name.to_owned()).collect()
}

#[test]
fn every_public_function_of_cpu_and_cli_is_named_by_a_test_of_its_crate() {
    for name in ["cpu", "cli"] {
        let folders = ["src", "tests"].map(|folder| project_root().join(name).join(folder));
        let paths = folders.iter().flat_map(|folder| files(folder).into_keys());
        let sources = paths.map(|path| {
            let own = path.strip_prefix(project_root()).expect("it is in the project");
            let is_tests = own.iter().any(|part| part == "tests" || part == "tests.rs");
            (is_tests, std::fs::read_to_string(&path).expect("a source is text"))
        });
        assert_eq!(unnamed(&sources.collect::<Vec<_>>()), [""; 0], "{name}");
    }
    let source = "pub const fn a() {}\npub(crate) fn b() {}\n/// ```\n/// c();\n/// ```\npub fn c() {}\npub fn e() {}\n\
        #[cfg(test)]\nmod tests { e(); }";
    assert_eq!(unnamed(&[(false, source.to_owned()), (true, "f();".to_owned())]), ["a"]);
}
