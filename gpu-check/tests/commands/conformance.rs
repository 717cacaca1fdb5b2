//! Runs all probes on lavapipe, compares the verdicts with docs/gpu/probes.csv, and runs the program `conformance` as
//! a user does.

use std::path::Path;
use std::process::{Command, Output};

use gpu_check::Form;
use gpu_check::conformance::csv::Table;
use gpu_check::conformance::outcome::Outcome;
use gpu_check::conformance::probe::Probe;
use gpu_check::conformance::report::{self, Run};
use gpu_check::conformance::{isolated, native, probes};
use test_support::folder::Folder;
use test_support::project_root;

use crate::common;

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
    if !common::gpu().is_lavapipe() {
        return;
    }
    let folder = Folder::new();
    folder.write("probes.csv", "\"probe\",\"program\",\"other\"\n\"sum\",\"a + b\",\"as written\"\n");
    let output = conformance(&["--csv", &folder.name("probes.csv")]);
    assert_eq!(output.status.code(), Some(1), "{output:?}");
    let table = Table::parse(&String::from_utf8_lossy(&folder.read("probes.csv"))).expect("it is a table");
    let text = std::fs::read_to_string(project_root().join("docs/gpu/probes.csv")).expect("it is committed");
    let documented = Table::parse(&text).expect("conformance wrote it");
    let [found, documented] = [&table, &documented].map(|table| table.column("llvmpipe").expect("it has a column"));
    assert_eq!(found.len(), documented.len(), "the documented table has a line for each probe");
    // The number of wrong cases is not compared, because it depends on how many invocations a driver runs at once.
    let is_same = |one: &[&str; 3], other: &[&str; 3]| {
        let both_fail = [one, other].iter().all(|row| row[2].starts_with("failure"));
        one[..2] == other[..2] && (one[2] == other[2] || both_fail)
    };
    let different: Vec<_> = found.iter().zip(&documented).filter(|(one, other)| !is_same(one, other)).collect();
    assert!(different.is_empty(), "found and documented verdicts differ: {different:#?}");
    let others = table.column("other").expect("the column stays");
    assert!(others.iter().all(|[name, _, verdict]| verdict.is_empty() != (*name == "sum")), "{others:?}");
}

#[test]
fn a_lost_device_is_an_outcome() {
    let gpu = common::gpu();
    gpu.close();
    let outcome = native::run(&gpu, &probes::all()[0]);
    assert!(matches!(&outcome, Outcome::Ended(cause) if cause.starts_with("the device was lost: ")), "{outcome:?}");
}

#[cfg(unix)]
#[test]
fn a_driver_that_crashes_fails_one_probe_and_the_table_is_complete() {
    let (gpu, probes) = (common::gpu(), probes::all());
    // The first process crashes after the outcomes of five probes.
    let start = |rest: &[Probe]| {
        let whole = isolated::command(Path::new(env!("CARGO_BIN_EXE_conformance")), Form::AsWritten, rest);
        if rest.len() < probes.len() {
            return whole;
        }
        let mut crashing = Command::new("sh");
        crashing.args(["-c", "\"$0\" \"$@\" | head -n 5; kill -SEGV $$"]).arg(whole.get_program());
        crashing.args(whole.get_args());
        crashing
    };
    let run = Run { driver: native::driver(&gpu), outcomes: isolated::run(&probes, start).expect("processes start") };
    let cause = "the process ended by signal: 11 (SIGSEGV)";
    for (place, outcome) in run.outcomes.iter().enumerate() {
        let ended = matches!(outcome, Outcome::Ended(how) if how.starts_with(cause));
        assert_eq!(ended, place == 5, "{place}: {outcome:?}");
    }
    let table = report::table(&probes, &run);
    let lines: Vec<_> = table.lines().map(|line| line.split_whitespace().collect::<Vec<_>>().join(" ")).collect();
    let failed = &probes[5].name;
    for line in [format!("{failed} failure: the driver ends"), format!("{failed}: {cause}")] {
        assert!(lines.iter().any(|shown| shown.starts_with(&line)), "{line}\n{table}");
    }
    let rows = |probe: &Probe| lines.iter().filter(|line| line.split(' ').next() == Some(&probe.name)).count();
    assert!(probes.iter().all(|probe| rows(probe) == 1), "{table}");
}

#[test]
fn reports_contain_the_programs_of_their_probes() {
    let probes = probes::all();
    for (path, names) in REPORTS {
        let page = std::fs::read_to_string(project_root().join(path)).expect("it is committed");
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
    let output = conformance(&["--probe", "loop-limit"]);
    let text = String::from_utf8(output.stdout).expect("it is text");
    assert_eq!(output.status.code(), Some(1), "{text}");
    assert!(
        text.contains("fn probe(") && text.contains("a = 65536\n    result ") && text.contains(", WRONG"),
        "{text}"
    );
    let output = conformance(&["--probe", "compare"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
}

#[test]
fn help_and_the_list_need_no_driver_and_mistakes_have_status_2() {
    let list = String::from_utf8(conformance(&["--list"]).stdout).expect("it is text");
    assert!(list.lines().count() == 2 * probes::all().len() && list.contains("(a + b) - a"), "{list}");
    let help = String::from_utf8(conformance(&["--help"]).stdout).expect("it is text");
    assert!(help.contains("Examples:\n  conformance ") && help.contains("Exit status:"), "{help}");
    let folder = Folder::new();
    folder.write("text", "no table");
    for arguments in [&["--probe", "cancel"][..], &["more"], &["--csv", "/nowhere/x"], &["--csv", &folder.name("text")]]
    {
        let output = conformance(arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {output:?}");
        assert!(output.stdout.is_empty() && !output.stderr.is_empty(), "{output:?}");
    }
}
