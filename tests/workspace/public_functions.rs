//! Checks that every public function of `cpu`, `cli` and `output` is called by a unit test, by a test program of its
//! crate, or by an example of the documentation.

use std::collections::BTreeSet;

use test_support::project_root;

use crate::files;

/// Returns the text without the angle brackets with which it may begin.
fn without_parameters(text: &str) -> &str {
    let mut depth = 0;
    text.trim_start_matches(|letter| {
        depth += i32::from(letter == '<') - i32::from(letter == '>');
        depth > 0 || (depth == 0 && letter == '>')
    })
}

/// Returns the type to whose methods the block belongs that begins in this line, if it is an `impl`.
fn implemented(line: &str) -> Option<&str> {
    let rest = without_parameters(line.strip_prefix("impl")?);
    let path = rest.split_once(" for ").map_or(rest, |(_, path)| path).trim_start();
    path.split(|letter: char| !(letter.is_alphanumeric() || letter == '_')).next()
}

/// Returns how tests call the public functions of this code: `name`, `.name` for a method, and `Type::name` for another
/// function of a type.
fn calls(code: &str) -> Vec<String> {
    let (mut calls, mut owner) = (Vec::new(), "");
    for (line, next) in code.lines().zip(code.lines().skip(1).chain([""])) {
        match implemented(line) {
            Some(name) => owner = name,
            None if line == "}" => owner = "",
            None => {}
        }
        let Some((before, after)) = line.trim_start().strip_prefix("pub ").and_then(|rest| rest.split_once("fn "))
        else {
            continue;
        };
        if !before.split_whitespace().all(|word| ["const", "unsafe"].contains(&word)) {
            continue;
        }
        let name = after.split(|letter: char| !(letter.is_alphanumeric() || letter == '_')).next().unwrap_or_default();
        let takes_self = after.split_once('(').is_some_and(|(_, arguments)| {
            let first = if arguments.is_empty() { next.trim_start() } else { arguments };
            ["self", "mut self", "&self", "&mut self"].iter().any(|start| first.starts_with(start))
        });
        calls.push(match (owner, takes_self) {
            ("", _) => name.to_owned(),
            (_, true) => format!(".{name}"),
            (owner, false) => format!("{owner}::{name}"),
        });
    }
    calls
}

/// Divides a source into code and unit tests. The examples of the documentation count as tests.
fn divided(source: &str) -> (&str, String) {
    let (code, tests) = source.split_once("#[cfg(test)]\nmod tests {").unwrap_or((source, ""));
    let comments: String = code.lines().filter(|line| line.trim_start().starts_with("//")).collect();
    (code, comments.split("```").skip(1).step_by(2).chain([tests]).collect())
}

/// Returns the calls of public functions of these sources that no test has. A source of tests is marked by true.
fn missing(sources: &[(bool, String)]) -> Vec<String> {
    let (mut functions, mut tests) = (BTreeSet::new(), String::new());
    for (is_tests, source) in sources {
        let (code, own_tests) = if *is_tests { ("", source.clone()) } else { divided(source) };
        functions.extend(calls(code));
        tests += &own_tests;
    }
    let is_part = |letter: char| letter.is_alphanumeric() || letter == '_';
    // The texts that follow each place where a name stands.
    let after = |name: &str| {
        let places = tests.match_indices(name).filter(|(at, _)| !tests[..*at].ends_with(is_part));
        let rests = places.map(|(at, _)| &tests[at + name.len()..]);
        rests.filter(|rest| !rest.starts_with(is_part)).collect::<Vec<_>>()
    };
    let has = |call: &String| match call.split_once("::") {
        // A type may have parameters, as in `Type::<T>::name` and `<Type<T>>::name`.
        Some((owner, name)) => after(owner).into_iter().any(|rest| {
            let rest =
                without_parameters(rest.strip_prefix("::<").map_or(rest, |_| &rest[2..])).trim_start_matches('>');
            rest.strip_prefix("::")
                .and_then(|rest| rest.strip_prefix(name))
                .is_some_and(|rest| !rest.starts_with(is_part))
        }),
        None => match call.strip_prefix('.') {
            Some(name) => [format!(".{name}"), format!("::{name}")]
                .iter()
                .any(|call| tests.match_indices(call).any(|(at, _)| !tests[at + call.len()..].starts_with(is_part))),
            None => !after(call).is_empty(),
        },
    };
    functions.into_iter().filter(|call| !has(call)).collect()
}

/// The public modules of `output`. The functions of its other files are for the crate itself.
const OF_OUTPUT: [&str; 2] = ["lib.rs", "stop.rs"];

#[test]
fn every_public_function_of_the_programs_packages_is_called_by_a_test_of_its_crate() {
    for name in ["cpu", "cli", "cli/output"] {
        let mut folders = ["src", "tests"].map(|folder| project_root().join(name).join(folder)).to_vec();
        // The package `stability` has the proofs and the stress tests of `cpu`.
        folders.extend((name == "cpu").then(|| project_root().join("tests/stability")));
        let paths = folders.iter().filter(|folder| folder.exists()).flat_map(|folder| files(folder).into_keys());
        let sources = paths.filter_map(|path| {
            let own = path.strip_prefix(project_root()).expect("it is in the project");
            let is_tests = own.iter().any(|part| ["tests", "tests.rs"].iter().any(|name| part == *name));
            let source = std::fs::read_to_string(&path).expect("a source is text");
            let is_public = name != "cli/output" || OF_OUTPUT.iter().any(|file| own.ends_with(file));
            (is_tests || is_public).then_some((is_tests, source))
        });
        let sources: Vec<_> = sources.collect();
        assert!(sources.iter().any(|(is_tests, _)| !is_tests), "{name} has no sources");
        assert_eq!(missing(&sources), [""; 0], "{name}");
    }
    let source = "pub const fn a() {}\npub(crate) fn b() {}\n/// ```\n/// c();\n/// ```\npub fn c() {}\npub fn e() {}\n\
        impl<T: A<T>> B for S<T> {\n    pub fn new() {}\n    pub fn old() {}\n    pub fn m(&self) {}\n    pub fn n(&self) {}\n}\n\
        #[cfg(test)]\nmod tests { e(); T::new(); S::<T>::old(); x.m(); }";
    assert_eq!(missing(&[(false, source.to_owned()), (true, "f(); an();".to_owned())]), [".n", "S::new", "a"]);
}
