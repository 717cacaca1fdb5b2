//! Tests with results of measurements that are too large, incomplete or unusual.

use lab::bench::results::check::{MAX_BYTES, MAX_ENTRIES, MAX_VALUES};
use test_support::folder::Folder;

use crate::{bash, bash_complaint};

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
fn as_much_as_the_limit_is_taken_and_one_more_is_refused_in_little_memory() {
    let folder = Folder::new();
    let (values, bytes, entries) = (MAX_VALUES / 2, MAX_BYTES as usize / 2, MAX_ENTRIES / 2);
    for (name, values) in [("full", 2 * values), ("over", 2 * values + 1), ("half", values), ("more", values + 1)] {
        folder.write(name, repeated(values));
    }
    folder.write("huge", repeated(8_000_000));
    for (name, length) in [("half-text", bytes), ("more-text", bytes + 1), ("nine-text", 9_000_000)] {
        folder.write(name, omitted(1, length - omitted(1, 0).len()));
    }
    for (name, length) in [("full-file", 2 * bytes), ("over-file", 2 * bytes + 1)] {
        folder.write(name, omitted(1, 0) + &" ".repeat(length - omitted(1, 0).len()));
    }
    folder.write("half-list", omitted(entries, 0));
    folder.write("more-list", omitted(entries + 1, 0));
    let merge = "bench merge --out all.json";
    for parts in ["full", "half half", "half-text half-text", "full-file", "half-list half-list"] {
        let output = bash(&folder, &format!("ulimit -v 200000; $lab {merge} {parts}"));
        assert!(output.status.success(), "{parts}: {output:?}");
    }
    for data in ["full", "full-file"] {
        let output = bash(&folder, &format!("ulimit -v 200000; $lab report {data} --out report"));
        assert!(output.status.success(), "{data}: {output:?}");
    }
    for (line, message) in [
        ("bench merge --out o over", "over: it has 1048577 values, more than 1048576"),
        ("bench merge --out o half more", "more: with the files before it, it has 1048577 values, more than 1048576"),
        ("bench merge --out o huge huge", "huge: it has 8000000 values, more than 1048576"),
        ("report over --out o", "over: it has 1048577 values, more than 1048576"),
        ("report huge --out o", "huge: it has 8000000 values, more than 1048576"),
        ("bench merge --out o half-text more-text", "before it, it has 16777217 bytes, more than 16777216"),
        ("bench merge --out o nine-text nine-text", "before it, it has 18000000 bytes, more than 16777216"),
        ("bench merge --out o over-file", "over-file: it is larger than 16777216 bytes"),
        ("report over-file --out o", "over-file: it is larger than 16777216 bytes"),
        ("bench merge --out o /dev/zero", "/dev/zero: it is larger than 16777216 bytes"),
        ("report /dev/zero --out o", "/dev/zero: it is larger than 16777216 bytes"),
    ] {
        let refused = bash_complaint(&folder, &format!("ulimit -v 100000; $lab {line}"));
        assert!(refused.contains(message) && !folder.file("o").exists(), "{line}: {refused}");
    }
    let refused = bash_complaint(&folder, "$lab bench merge --out o half-list more-list");
    let expected = "the parts together: the list \"omitted\" has 4097 entries, more than 4096";
    assert!(refused.contains(expected) && !folder.file("o").exists(), "{refused}");
}
