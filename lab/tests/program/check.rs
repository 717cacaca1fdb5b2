//! Tests of `render-lab check` with programs of a few lines of shell.

use std::collections::BTreeSet;
use std::os::unix::fs::PermissionsExt;

use test_support::folder::Folder;

use crate::{bash, lab};

/// Checks the program with this text and this limit of time. Returns the exit status, the kinds of all faults, and
/// those of all remarks.
fn checked(script: &str, seconds: &str) -> (Option<i32>, [BTreeSet<String>; 2]) {
    let folder = Folder::new();
    let program = folder.write("program", format!("#!/bin/sh\n{script}\n"));
    std::fs::set_permissions(&program, PermissionsExt::from_mode(0o755)).expect("it is ours");
    let [keep, program] = ["keep", "program"].map(|name| folder.name(name));
    let arguments = ["check", "--json", "--seconds", seconds, "--memory", "100", "--keep", &keep, &program];
    let output = lab(&arguments).output().expect("the program runs");
    let report: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap_or_else(|_| panic!("{output:?}"));
    let cases = report["cases"].as_array().expect("a list");
    assert_eq!(cases.len(), 77, "5 numbers of arguments, 36 messages, 22 pairs of files, 14 pictures");
    let kinds = |list: &str| {
        let all = cases.iter().flat_map(|case| case[list].as_array().expect("a list"));
        all.map(|fault| fault["kind"].as_str().expect("a name").to_owned()).collect()
    };
    // The command that is printed repeats a case, which may never end.
    let command = cases[0]["command"].as_str().expect("a command");
    let repeated = bash(&folder, &format!("timeout 5 {command}"));
    assert_ne!(repeated.status.code(), Some(127), "{repeated:?}");
    (output.status.code(), ["faults", "remarks"].map(kinds))
}

#[test]
fn faults_are_told_apart() {
    // OUT has a text before a run that must be refused.
    let refuse = "[ $# = 3 ] && [ -s \"$1\" ] && [ -e \"$2\" ] || { echo Error >&2; exit 3; }; [ \"$(cat \"$3\" 2>/dev/null)\" = old ] && ";
    for (script, expected, remarks) in [
        ("kill -SEGV $$", &["crash"][..], &[][..]),
        ("exit 0", &["no_picture", "wrong_message", "wrong_status"], &["silent"]),
        ("echo Error: no; exit 1", &["wrong_message", "wrong_status"], &[]),
        (
            &format!("{refuse} {{ echo x >\"$3\"; exit 1; }}; echo P7 >\"$3\""),
            &["output_changed", "unreadable_picture", "wrong_message"],
            &[],
        ),
        (
            "rm -rf \"$3\"; mkfifo \"$3\"; exit 0",
            &["no_picture", "wrong_message", "wrong_status"],
            &["out_lost", "silent"],
        ),
        (
            "rm -f \"$3\"; ln -s /dev/zero \"$3\"; exit 0",
            &["no_picture", "wrong_message", "wrong_status"],
            &["out_lost", "silent"],
        ),
        (
            &format!("{refuse} {{ rm \"$3\"; exit 9; }}; printf 'P3 1 1 255 0 0 0' >\"$3\""),
            &["ignored", "wrong_form", "wrong_message", "wrong_picture", "wrong_size"],
            &["out_lost"],
        ),
    ] {
        let (status, [faults, remarked]) = checked(script, "60");
        assert_eq!(faults.iter().map(String::as_str).collect::<Vec<_>>(), expected, "{script}");
        assert!(remarks.iter().all(|remark| remarked.contains(*remark)), "{script}: {remarked:?}");
        assert_eq!(status, Some(1), "{script}");
    }
}

#[test]
fn a_program_that_hangs_is_given_up_after_three_runs() {
    let (status, [faults, _]) = checked("while :; do :; done", "0.3");
    assert_eq!(status, Some(1));
    assert_eq!(faults.into_iter().collect::<Vec<_>>(), ["left_out", "time_out"]);
}

#[test]
fn limits_end_a_program_and_what_it_has_started() {
    let folder = Folder::new();
    let wait = "sleep 60 & echo $! >pid; wait";
    let endless = "while :; do echo Error; done";
    let large = "x=$(head -c 200000000 /dev/zero | tr '\\0' x); echo $x";
    // It leaves its session, works on for a while, and is waited for.
    let left = "setsid sh -c 'echo $$ >pid; while :; do :; done' & sleep 1";
    for (script, seconds, end) in
        [(endless, 2, "time_out"), (large, 60, "over_memory"), (left, 2, "status"), (wait, 2, "time_out")]
    {
        let line = format!("$lab supervise --seconds {seconds} --memory 100 --printed . -- sh -c \"$script\"");
        let output = bash(&folder, &format!("script='{}'; {line}", script.replace('\'', "'\\''")));
        let answer: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap_or_else(|_| panic!("{output:?}"));
        let run = &answer["Ok"]["Ok"];
        assert!(run["end"].to_string().contains(end), "{script}: {output:?}");
        assert!(script != left || run["user"].as_f64() > Some(0.05), "the time of all processes counts: {run}");
        let alive = bash(&folder, "kill -0 $(cat pid) && ! grep -q '^State:.Z' /proc/$(cat pid)/status");
        assert!(!alive.status.success(), "no process is left: {alive:?}");
    }
    assert!(folder.read("stdout.txt").len() <= 1 << 16);
    let page = bash(&folder, "$lab check --keep kept --html - false");
    assert!(page.stdout.starts_with(b"<!doctype html>") && page.stderr.starts_with(b"arguments "), "{:?}", page.status);
}
