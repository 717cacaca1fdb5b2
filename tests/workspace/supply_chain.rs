//! Checks the locked dependencies: they come from crates.io, have a licence, and need no newer compiler than the
//! project. The evaluated programs depend only on packages of this project, on the random generator, and on `rustix`.

use std::collections::BTreeSet;

use serde_json::Value;
use test_support::cargo;

/// Returns cargo's metadata of every package that a build on Linux may compile.
fn packages(folder: &str) -> Vec<Value> {
    let metadata = ["metadata", "--format-version", "1", "--filter-platform", "x86_64-unknown-linux-gnu"];
    let metadata: Value = serde_json::from_str(&cargo(folder, &metadata)).expect("cargo writes JSON");
    metadata["packages"].as_array().expect("there are packages").clone()
}

/// Returns the first two numbers of a compiler's version, so that versions can be compared.
fn version(text: &str) -> [u64; 2] {
    let mut numbers = text.split('.').map(|number| number.parse().expect("a version is numbers"));
    [numbers.next().expect("a version has a first number"), numbers.next().unwrap_or(0)]
}

#[test]
fn no_dependency_needs_a_newer_compiler_than_the_project() {
    let promised = version(env!("CARGO_PKG_RUST_VERSION"));
    let mut checked = 0;
    for package in &packages("") {
        if let Some(needed) = package["rust_version"].as_str() {
            assert!(version(needed) <= promised, "{} needs Rust {needed}", package["id"]);
            checked += 1;
        }
    }
    assert!(checked > 100, "only {checked} say what they need");
}

#[test]
fn every_dependency_is_licensed_and_comes_from_the_one_registry() {
    let mut registered = 0;
    for package in [packages(""), packages("python"), packages("tests/fuzz/targets")].concat() {
        let Some(source) = package["source"].as_str() else { continue };
        assert_eq!(source, "registry+https://github.com/rust-lang/crates.io-index", "{}", package["id"]);
        assert!(package["license"].is_string(), "{}", package["id"]);
        registered += 1;
    }
    assert!(registered > 100, "only {registered} dependencies");
}

#[test]
fn the_programs_depend_only_on_the_renderer_its_random_generator_and_system_calls() {
    // Dependencies of build scripts are among them.
    let edges = ["tree", "-p", "cli", "-e", "normal,build", "--target", "x86_64-unknown-linux-gnu"];
    let tree = cargo("", &[&edges[..], &["--prefix", "none", "--format", "{p}"]].concat());
    let names: BTreeSet<_> = tree.lines().filter_map(|line| line.split(' ').next()).collect();
    // `rustix` makes system calls. It depends on the two packages after it, and has the only build script: it asks the
    // compiler what it can do.
    assert_eq!(names, BTreeSet::from(["cli", "cpu", "output", "rand_mt", "rustix", "bitflags", "linux-raw-sys"]));
    // A build script, or a macro that runs in the compiler.
    let runs_code = |package: &&Value| {
        let mut targets = package["targets"].as_array().expect("a package has targets").iter();
        targets.any(|target| target["kind"][0] == "custom-build" || target["kind"][0] == "proc-macro")
    };
    let packages = packages("");
    let running: Vec<_> = packages.iter().filter(runs_code).filter_map(|package| package["name"].as_str()).collect();
    assert!(running.len() > 10, "other packages of the workspace run code, {running:?} were found");
    let of_programs: Vec<_> = running.iter().filter(|name| names.contains(*name)).collect();
    assert_eq!(of_programs, [&"rustix"]);
}
