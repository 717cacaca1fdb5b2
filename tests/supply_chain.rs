//! Checks the locked dependencies: they must come from crates.io, have a licence, and need no newer compiler than the
//! project.

use std::process::Command;

use serde_json::Value;

/// Returns cargo's metadata of every package that a build on Linux may compile.
fn packages(folder: &str) -> Vec<Value> {
    let output = Command::new(env!("CARGO"))
        .args(["metadata", "--locked", "--format-version", "1", "--filter-platform", "x86_64-unknown-linux-gnu"])
        .current_dir(test_support::project_root().join(folder))
        .output()
        .expect("cargo runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let metadata: Value = serde_json::from_slice(&output.stdout).expect("cargo writes JSON");
    metadata["packages"].as_array().expect("there are packages").clone()
}

/// Returns the first two numbers of a compiler's version, so that versions can be compared.
fn version(text: &str) -> [u64; 2] {
    let mut numbers = text.split('.').map(|number| number.parse().expect("a version is numbers"));
    [numbers.next().expect("a version has a first number"), numbers.next().unwrap_or(0)]
}

#[test]
fn no_dependency_needs_a_newer_compiler_than_the_project() {
    let packages = packages("");
    let own = packages.iter().find(|package| package["name"] == "cpu").expect("it is ours");
    let promised = own["rust_version"].as_str().expect("the workspace has one");
    let mut checked = 0;
    for package in &packages {
        if let Some(needed) = package["rust_version"].as_str() {
            assert!(version(needed) <= version(promised), "{} needs Rust {needed}", package["id"]);
            checked += 1;
        }
    }
    assert!(checked > 100, "only {checked} say what they need");
}

#[test]
fn every_dependency_is_licensed_and_comes_from_the_one_registry() {
    let mut registered = 0;
    for package in [packages(""), packages("tests/fuzz/targets")].concat() {
        let Some(source) = package["source"].as_str() else { continue };
        assert_eq!(source, "registry+https://github.com/rust-lang/crates.io-index", "{}", package["id"]);
        assert!(package["license"].is_string(), "{}", package["id"]);
        registered += 1;
    }
    assert!(registered > 100, "only {registered} dependencies");
}
