//! Runs the program `stress` as a user does. Checks its help, and that it writes only into the given folder.

use std::fs;
use std::process::{Command, Output};

use test_support::folder::Folder;
use test_support::project_root;

use crate::common;

fn stress(out: &Folder, arguments: &str) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_stress"));
    command.arg("--out").arg(out.path()).args(arguments.split(' ')).current_dir(project_root().join(""));
    command.output().expect("the program starts")
}

#[test]
fn rows_of_pictures_that_are_not_rendered_are_not_thrown_away() {
    let folder = Folder::new();
    let table = folder.file("pictures.csv");
    fs::copy(project_root().join("docs/accuracy/pictures.csv"), &table).expect("it is committed");
    let output = stress(&folder, "--case case-2 c s");
    assert_eq!(output.status.code(), Some(2));
    let message = String::from_utf8(output.stderr).expect("it is text");
    assert!(
        message.contains("pictures.csv: its rows for case-1, case-3, case-4 would go; give each as --case"),
        "{message}"
    );
    assert_eq!(fs::read(&table).ok(), fs::read(project_root().join("docs/accuracy/pictures.csv")).ok());
}

#[test]
fn two_thousand_rays_of_each_regime_are_decided_rightly_and_the_tables_written_into_the_folder_alone() {
    let gpu = common::gpu();
    let folder = Folder::new();
    let before = fs::read(project_root().join("docs/accuracy/errors.csv")).expect("it is committed");
    let output = stress(&folder, "--rays 2000");
    let said = String::from_utf8_lossy(&output.stdout).into_owned() + &String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{said}");
    assert!(!gpu.is_lavapipe() || !said.contains("not the figures of the same formulas"), "{said}");
    let text = |name: &str| fs::read_to_string(folder.file(name)).expect("it was written");
    assert!(text("run.txt").contains("--rays 2000 --seed 1\ndate: "), "{}", text("run.txt"));
    for (table, row) in [
        ("errors.csv", "sphere,\"ordinary\",exact f64,2000,"),
        ("costs.csv", "cylinder,\"through the rim\",exact f64,"),
        ("large-spheres.csv", "exact f64,1e9,0\n"),
        ("pictures.csv", "\"tests/cases, all\","),
    ] {
        assert!(text(table).contains(row), "{table}: {}", text(table));
    }
    assert_eq!(folder.names().len(), 4 + 1, "tables and run.txt");
    assert_eq!(
        fs::read(project_root().join("docs/accuracy/errors.csv")).ok(),
        Some(before),
        "the project's own file stays"
    );
}
