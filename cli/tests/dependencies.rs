//! The evaluated programs depend only on packages of this project and on the random generator, and building them runs
//! no code of any package.

use std::collections::BTreeSet;
use std::process::Command;

use serde_json::Value;

/// Runs cargo in the project and returns what it prints.
fn cargo(arguments: &[&str]) -> String {
    let mut command = Command::new(env!("CARGO"));
    let output = command.args(arguments).current_dir(test_support::project_root()).output().expect("cargo runs");
    assert!(output.status.success(), "{output:?}");
    String::from_utf8(output.stdout).expect("names are text")
}

/// Returns the names of the packages that the evaluated programs are built from. Dependencies of build scripts, and
/// those for other systems, are among them.
fn packages() -> BTreeSet<String> {
    let edges = ["-e", "normal,build", "--target", "all", "--prefix", "none", "--format", "{p}"];
    let tree = cargo(&[&["tree", "--locked", "-p", "cli"], &edges[..]].concat());
    tree.lines().filter_map(|line| line.split(' ').next()).map(str::to_owned).collect()
}

#[test]
fn the_programs_depend_only_on_the_renderer_and_its_random_generator() {
    assert_eq!(packages(), ["cli", "cpu", "output", "rand_mt"].map(str::to_owned).into());
}

#[test]
fn no_package_of_the_programs_has_a_build_script_or_a_macro_that_runs_in_the_compiler() {
    let metadata: Value =
        serde_json::from_str(&cargo(&["metadata", "--locked", "--format-version", "1"])).expect("JSON");
    let wanted = packages();
    let (mut checked, mut scripts) = (BTreeSet::new(), 0);
    for package in metadata["packages"].as_array().expect("there are packages") {
        let name = package["name"].as_str().expect("a package has a name");
        let targets = package["targets"].as_array().expect("a package has targets");
        let mut kinds = targets.iter().filter_map(|target| target["kind"][0].as_str());
        let runs = kinds.any(|kind| ["custom-build", "proc-macro"].contains(&kind));
        scripts += usize::from(runs);
        if wanted.contains(name) {
            assert!(!runs, "{name}");
            checked.insert(name.to_owned());
        }
    }
    assert_eq!(checked, wanted);
    assert!(scripts > 10, "other packages of the workspace have some, {scripts} were found");
}
