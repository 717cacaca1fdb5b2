//! `render-lab bench` and `render-lab report`. No time is asserted: only what must hold on the busiest machine.

use std::fs;

use lab::bench::results::Results;

use crate::{Folder, complaint, printed};

/// Measures a little, into `name`.
fn measure(folder: &Folder, name: &str, arguments: &[&str]) -> Results {
    let out = folder.name(name);
    printed(&[&["bench"], arguments, &["--quick", "--repeats", "2", "--out", &out]].concat());
    Results::read(&folder.file(name)).expect("it was written")
}

#[test]
fn times_are_kept_with_their_machine_and_their_pictures() {
    let folder = Folder::new();
    let results = measure(&folder, "depth.json", &["scale", "depth"]);
    assert!(results.quick && results.machines.len() == 1);
    // Three implementations at six depths.
    assert_eq!(results.timings.len() + results.omitted.len(), 18);
    for timing in &results.timings {
        assert!(timing.seconds.len() == 2 && timing.seconds.iter().all(|&seconds| seconds > 0.0), "{timing:?}");
        let other = results
            .timings
            .iter()
            .find(|other| other.setting.value == timing.setting.value && other.setting.engine != timing.setting.engine);
        assert_eq!(other.expect("the layouts are always measured").digest, timing.digest);
    }
    assert_eq!(folder.names(), ["depth-error.csv", "depth.csv", "depth.json"]);

    let merged = folder.name("merged.json");
    printed(&["bench", "merge", "--out", &merged, &folder.name("depth.json"), &folder.name("depth.json")]);
    let merged = Results::read(&folder.file("merged.json")).expect("it was written");
    assert!(merged.timings.iter().all(|timing| timing.seconds.len() == 4));

    printed(&["report", &folder.name("depth.json"), "--out", &folder.name("report")]);
    let page = fs::read_to_string(folder.file("report/index.html")).expect("it was written");
    assert!(page.contains("Time against depth") && page.contains("aria-label"), "{page}");
    let links = ["src=", "href=", "@import", "url("];
    assert!(links.iter().all(|link| !page.contains(link)), "the page needs no other file");
    let findings = fs::read_to_string(folder.file("report/findings.json")).expect("it was written");
    let findings: serde_json::Value = serde_json::from_str(&findings).expect("it is JSON");
    assert!(findings.as_array().is_some_and(|findings| findings.len() >= 4), "{findings}");
    assert!(folder.file("report/charts/scale-depth.svg").is_file());
}

#[test]
fn energy_is_a_figure_or_a_reason() {
    let folder = Folder::new();
    let out = folder.name("energy.json");
    // With one part more than there are tasks the last part has nothing to do; with as many it measures one scene.
    let count = printed(&["bench", "tasks"]).lines().count();
    assert!(printed(&["bench", "tasks"]).ends_with("energy spheres\n"));
    printed(&["bench", "all", "--part", &format!("{count}/{count}"), "--quick", "--out", &out]);
    let results = Results::read(&folder.file("energy.json")).expect("it was written");
    assert_eq!(results.energy.len(), 3);
    for energy in &results.energy {
        assert!(energy.joules.is_some() != energy.reason.is_some(), "{energy:?}");
    }
}

#[test]
fn what_cannot_be_measured_joined_or_shown_is_an_error() {
    let folder = Folder::new();
    assert!(complaint(&["bench", "energy", "--out", "/nowhere/e.json"]).contains("/nowhere/e.json"));
    let out = folder.name("out.json");
    assert!(complaint(&["bench", "merge", "--out", &out, "README.md"]).starts_with("Error: README.md: "));
    assert!(complaint(&["report", "README.md", "--out", &folder.name("r")]).starts_with("Error: README.md: "));
    assert!(complaint(&["bench", "scale", "--scenes", "/nowhere", "--out", &out]).contains("/nowhere/materials"));
    assert!(folder.names().is_empty());
}
