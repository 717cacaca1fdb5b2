//! Tests with results of measurements that are too large, incomplete or unusual.

use std::fs;

use lab::bench::results::check::{MAX_BYTES, MAX_ENTRIES, MAX_VALUES};
use test_support::folder::Folder;

use crate::{bash, bash_complaint, complaint};

#[test]
fn endless_results_are_refused() {
    let folder = Folder::new();
    let out = folder.name("out");
    for arguments in [&["report", "/dev/zero", "--out", &out][..], &["bench", "merge", "--out", &out, "/dev/zero"]] {
        assert!(complaint(arguments).contains("/dev/zero: it is larger than 16777216 bytes"));
        assert!(folder.names().is_empty());
    }
}

/// Returns the JSON text of results with many repeats of one picture, and exactly `values` JSON values.
fn repeated(values: usize) -> String {
    let text = serde_json::json!({
        "quick": true, "machines": [], "curves": [], "omitted": [], "growth": [], "times_to_error": [],
        "timings": [{
            "suite": "scale", "scene": "grid", "parameter": "width", "value": 1, "engine": "aos-avx2", "digest": "d",
            "median": { "median": 1.0, "low": 1.0, "high": 1.0, "confidence": 0.5 }, "seconds": [1.5],
        }],
    })
    .to_string();
    let missing = values - lab::bench::results::check::values(text.as_bytes());
    text.replace("[1.5]", &format!("[1.5{}]", ",1".repeat(missing)))
}

/// Checks that `render-lab` accepts this command line in 200 MB.
fn accepted(folder: &Folder, line: &str) {
    let output = bash(folder, &format!("ulimit -v 200000; $lab {line}"));
    assert!(output.status.success(), "{line}: {output:?}");
}

/// Checks that `render-lab` refuses this command line in 100 MB with a message that contains `reason`, and does not
/// write the output `o`.
fn refused_in_little_memory(folder: &Folder, line: &str, reason: &str) {
    let message = bash_complaint(folder, &format!("ulimit -v 100000; $lab {line}"));
    assert!(message.contains(reason), "{line}: {message}");
    assert!(!folder.file("o").exists(), "{line}");
}

#[test]
fn as_many_repeats_as_the_limit_are_taken_and_one_more_is_refused_in_little_memory() {
    let folder = Folder::new();
    let half = MAX_VALUES / 2;
    for (name, values) in [("full", MAX_VALUES), ("over", MAX_VALUES + 1), ("half", half), ("more", half + 1)] {
        fs::write(folder.file(name), repeated(values)).expect("the folder is writable");
    }
    folder.write("huge", repeated(8_000_000));
    for line in ["bench merge --out all.json full", "bench merge --out all.json half half", "report full --out report"]
    {
        accepted(&folder, line);
    }
    let refused = [
        ("bench merge --out o over", "over: it has 1048577 values, more than 1048576"),
        ("bench merge --out o half more", "more: with the files before it, it has 1048577 values, more than 1048576"),
        ("bench merge --out o huge huge", "huge: it has 8000000 values, more than 1048576"),
        ("report over --out o", "over: it has 1048577 values, more than 1048576"),
        ("report huge --out o", "huge: it has 8000000 values, more than 1048576"),
    ];
    for (line, message) in refused {
        refused_in_little_memory(&folder, line, message);
    }
}

/// Returns the smallest results that are valid, with `entries` omitted pictures. The reason of the first one is
/// `longer` bytes longer than those of the others.
fn omitted(entries: usize, longer: usize) -> String {
    let mut results: serde_json::Value = serde_json::from_str(&repeated(100)).expect("it is JSON");
    let setting = serde_json::json!({
        "suite": "scale", "scene": "grid", "parameter": "width", "value": 1, "engine": "aos-avx2", "reason": "r",
    });
    let mut list = vec![setting; entries];
    list[0]["reason"] = "r".repeat(1 + longer).into();
    results["omitted"] = list.into();
    results["timings"] = serde_json::json!([]);
    results.to_string()
}

#[test]
fn all_files_together_have_a_limit_on_bytes() {
    let folder = Folder::new();
    let bytes = |length| omitted(1, length - omitted(1, 0).len());
    let half = MAX_BYTES as usize / 2;
    for (name, length) in [("half", half), ("more", half + 1), ("nine", 9_000_000)] {
        fs::write(folder.file(name), bytes(length)).expect("the folder is writable");
    }
    accepted(&folder, "bench merge --out all.json half half");
    for (parts, message) in [
        ("half more", "more: with the files before it, it has 16777217 bytes, more than 16777216"),
        ("nine nine", "nine: with the files before it, it has 18000000 bytes, more than 16777216"),
    ] {
        refused_in_little_memory(&folder, &format!("bench merge --out o {parts}"), message);
    }
}

#[test]
fn a_file_of_exactly_the_limit_on_bytes_is_taken_and_one_byte_more_is_refused() {
    let folder = Folder::new();
    let text = omitted(1, 0);
    for (name, length) in [("full", MAX_BYTES as usize), ("over", MAX_BYTES as usize + 1)] {
        fs::write(folder.file(name), text.clone() + &" ".repeat(length - text.len())).expect("the folder is writable");
    }
    for line in ["bench merge --out all.json full", "report full --out report"] {
        accepted(&folder, line);
    }
    for line in ["bench merge --out o over", "report over --out o"] {
        refused_in_little_memory(&folder, line, "over: it is larger than 16777216 bytes");
    }
}

#[test]
fn the_limit_on_entries_holds_for_two_files_together() {
    let folder = Folder::new();
    let half = MAX_ENTRIES / 2;
    for (name, entries) in [("half", half), ("more", half + 1)] {
        fs::write(folder.file(name), omitted(entries, 0)).expect("the folder is writable");
    }
    accepted(&folder, "bench merge --out all.json half half");
    let expected = "the parts together: the list \"omitted\" has 4097 entries, more than 4096";
    let message = bash_complaint(&folder, "$lab bench merge --out o half more");
    assert!(message.contains(expected) && !folder.file("o").exists(), "{message}");
}
