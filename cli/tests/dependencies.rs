//! The evaluated programs depend only on packages of this project and on the random generator.

use std::collections::BTreeSet;
use std::process::Command;

#[test]
fn the_programs_depend_only_on_the_renderer_and_its_random_generator() {
    let output = Command::new(env!("CARGO"))
        .args(["tree", "--locked", "-p", "cli", "-e", "normal", "--prefix", "none", "--format", "{p}"])
        .current_dir(test_support::project_root())
        .output()
        .expect("cargo runs");
    assert!(output.status.success(), "{output:?}");
    let text = String::from_utf8(output.stdout).expect("names are text");
    let names: BTreeSet<&str> = text.lines().filter_map(|line| line.split(' ').next()).collect();
    assert_eq!(names, BTreeSet::from(["cli", "cpu", "output", "rand_mt"]));
}
