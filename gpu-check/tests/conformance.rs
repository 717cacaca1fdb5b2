//! Runs all probes on lavapipe, compares the verdicts with docs/gpu/probes.csv, and runs the program `conformance` as
//! a user does.

mod common;
#[path = "common/documented.rs"]
mod documented;

use std::process::{Command, Output};

use gpu_check::conformance::{native, probes, report::Run};
use gpu_check::scenes::repository;
use test_support::folder::Folder;

/// The reports that are ready to be sent, each with the probes whose programs it contains.
const REPORTS: [(&str, &[&str]); 2] = [
    ("docs/upstream/lavapipe-loop-limit.md", &["loop-limit"]),
    ("docs/upstream/naga-f64-functions.md", &["sin-f64", "exp-f64", "pow-f64"]),
];

fn conformance(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_conformance")).args(arguments).output().expect("the program starts")
}

#[test]
fn the_verdicts_on_lavapipe_are_the_documented_ones() {
    let (gpu, probes) = (common::gpu(), probes::all());
    let outcome = |probe| native::run(&gpu, probe).unwrap_or_else(|error| panic!("{error}"));
    let run = Run { driver: native::driver(&gpu), outcomes: probes.iter().map(outcome).collect() };
    let verdicts = run.verdicts(&probes);
    if gpu.is_lavapipe() {
        let failures = documented::check(&probes, &verdicts, 1);
        println!("{} probes, {failures} failures", probes.len());
    }
}

#[test]
fn reports_contain_the_programs_of_their_probes() {
    let probes = probes::all();
    for (path, names) in REPORTS {
        let page = std::fs::read_to_string(repository(path)).expect("it is committed");
        for name in names {
            let probe = probes.iter().find(|probe| probe.name == *name).expect("it exists");
            let program: String = probe.text().lines().map(|line| format!("    {line}\n")).collect();
            assert!(page.contains(&program), "{path} lacks the program of {name}:\n{program}");
        }
    }
}

#[test]
fn a_failure_has_status_1_and_its_program_inputs_and_results_are_printed() {
    if !common::gpu().is_lavapipe() {
        return;
    }
    let folder = Folder::new();
    let file = folder.file("verdicts.json");
    let output = conformance(&["--probe", "loop-limit", "--json", file.to_str().expect("it is text")]);
    let text = String::from_utf8(output.stdout).expect("it is text");
    assert_eq!(output.status.code(), Some(1), "{text}");
    assert!(
        text.contains("fn probe(") && text.contains("a = 65536\n    result ") && text.contains(", WRONG"),
        "{text}"
    );
    let json = std::fs::read_to_string(file).expect("it is written");
    let json: serde_json::Value = serde_json::from_str(&json).expect("it is JSON");
    assert_eq!(json["drivers"][0]["verdicts"][0]["class"], "failure");
    assert!(json["drivers"][0]["compiler"].as_str().is_some_and(|text| text.starts_with("wgpu ")), "{json}");
    let output = conformance(&["--probe", "compare"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
}

#[test]
fn help_and_the_list_need_no_driver_and_mistakes_have_status_2() {
    let list = String::from_utf8(conformance(&["--list"]).stdout).expect("it is text");
    assert!(list.lines().count() == 2 * probes::all().len() && list.contains("(a + b) - a"), "{list}");
    let help = String::from_utf8(conformance(&["--help"]).stdout).expect("it is text");
    assert!(help.contains("Examples:\n  conformance ") && help.contains("Exit status:"), "{help}");
    for arguments in [&["--probe", "cancel"][..], &["--no-native"], &["more"], &["--json", "/nowhere/x"]] {
        let output = conformance(arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {output:?}");
        assert!(output.stdout.is_empty() && !output.stderr.is_empty(), "{output:?}");
    }
}

#[cfg(unix)]
#[test]
fn a_browser_that_ends_is_an_error_with_status_2() {
    use std::os::unix::fs::PermissionsExt;

    let folder = Folder::new();
    let browser = folder.file("browser");
    // It prints a version, and ends when it is asked for a page.
    std::fs::write(&browser, "#!/bin/sh\n[ \"$1\" = --version ] || exit 3\necho Browser 1\n").expect("writable");
    std::fs::set_permissions(&browser, std::fs::Permissions::from_mode(0o755)).expect("it is ours");
    let mut command = Command::new(env!("CARGO_BIN_EXE_conformance"));
    let output = command.args(["--browser", "--no-native"]).env("CHROMIUM", &browser).output().expect("it starts");
    let message = String::from_utf8(output.stderr).expect("it is text");
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert!(message.contains("Error: after 0 results the browser ended by exit status: 3; start it "), "{message}");
}
