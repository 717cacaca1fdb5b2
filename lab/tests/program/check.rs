//! Tests of `render-lab check` with programs of a few lines of shell.

use std::collections::BTreeSet;
use std::os::unix::fs::PermissionsExt;

use test_support::folder::Folder;

use crate::{bash, lab};

/// Checks the program with this text, and returns the exit status and the kinds of all faults.
fn faults(script: &str) -> (Option<i32>, BTreeSet<String>) {
    let folder = Folder::new();
    let program = folder.write("program", format!("#!/bin/sh\n{script}\n"));
    std::fs::set_permissions(&program, PermissionsExt::from_mode(0o755)).expect("it is ours");
    let [keep, program] = ["keep", "program"].map(|name| folder.name(name));
    let arguments = ["check", "--json", "--seconds", "0.2", "--memory", "100", "--keep", &keep, &program];
    let output = lab(&arguments).env_remove("RENDER_REFERENCE_DIR").output().expect("the program runs");
    let report: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap_or_else(|_| panic!("{output:?}"));
    let cases = report["cases"].as_array().expect("a list");
    assert_eq!(cases.len(), 62, "5 numbers of arguments, 37 messages, 20 pictures");
    let faults = cases.iter().flat_map(|case| case["faults"].as_array().expect("a list"));
    let kinds = faults.map(|fault| fault["kind"].as_str().expect("a name").to_owned()).collect();
    // The command that is printed repeats a case.
    let repeated = bash(&folder, cases[61]["command"].as_str().expect("a command"));
    assert_ne!(repeated.status.code(), Some(127), "{repeated:?}");
    (output.status.code(), kinds)
}

#[test]
fn faults_are_told_apart() {
    let refuse = "[ $# = 3 ] || { echo Error >&2; exit 1; }; [ -s \"$1\" ] || exit 1; case $1 in *message*|*no-*) ";
    for (script, expected) in [
        ("kill -SEGV $$", &["crash"][..]),
        ("exit 0", &["no_picture", "wrong_message", "wrong_status"]),
        ("echo Error: no >&2; exit 1", &["wrong_message", "wrong_status"]),
        (
            &format!("{refuse} echo >\"$3\"; exit 1;; *) echo P7 >\"$3\"; esac"),
            &["output_changed", "unreadable_picture", "wrong_message"],
        ),
        ("rm -rf \"$3\"; mkfifo \"$3\"; exit 0", &["no_picture", "output_changed", "wrong_message", "wrong_status"]),
        (&format!("{refuse} exit 1;; *) printf 'P3 1 1 255 0 0 0' >\"$3\"; esac"), &["wrong_message", "wrong_size"]),
    ] {
        let (status, kinds) = faults(script);
        assert_eq!(
            (status, kinds.iter().map(String::as_str).collect::<Vec<_>>()),
            (Some(1), expected.to_vec()),
            "{script}"
        );
    }
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
        let run = String::from_utf8_lossy(&output.stdout);
        assert!(run.contains(end), "{script}: {output:?}");
        let user = run.split_once("\"user\": ").and_then(|(_, rest)| rest.split(',').next()?.parse::<f64>().ok());
        assert!(script != left || user > Some(0.05), "the time of all processes counts: {run}");
        let alive = bash(&folder, "kill -0 $(cat pid) && ! grep -q '^State:.Z' /proc/$(cat pid)/status");
        assert!(!alive.status.success(), "no process is left: {alive:?}");
    }
    assert!(folder.read("stdout.txt").len() <= 1 << 16);
    let page = bash(&folder, "$lab check --keep kept --html - false");
    assert!(page.stdout.starts_with(b"<!doctype html>") && page.stderr.starts_with(b"arguments "), "{:?}", page.status);
}
