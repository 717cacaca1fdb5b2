//! Tests of `render-lab bench` and `render-lab report`. No test asserts a time, because the machine may be busy.

use std::collections::BTreeSet;
use std::fs;

use lab::bench::results::Results;
use test_support::folder::Folder;

use crate::{complaint, lab, printed};

/// Runs `render-lab bench` with `arguments`, `--quick` and two repeats. Returns the results that it wrote to the file
/// `name`.
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
    // Three implementations are measured at six depths.
    assert_eq!(results.timings.len() + results.omitted.len(), 18);
    for timing in &results.timings {
        assert!(timing.seconds.len() == 2 && timing.seconds.iter().all(|&seconds| seconds > 0.0), "{timing:?}");
        let other = results
            .timings
            .iter()
            .find(|other| other.setting.value == timing.setting.value && other.setting.engine != timing.setting.engine);
        assert_eq!(other.expect("the layouts are always measured").digest, timing.digest);
    }
    assert_eq!(folder.names(), ["depth-error.csv", "depth-intersections.csv", "depth.csv", "depth.json"]);

    let merged = folder.name("merged.json");
    printed(&["bench", "merge", "--out", &merged, &folder.name("depth.json"), &folder.name("depth.json")]);
    let merged = Results::read(&folder.file("merged.json")).expect("it was written");
    assert!(merged.timings.iter().all(|timing| timing.seconds.len() == 4));

    printed(&["report", &folder.name("depth.json"), "--out", &folder.name("report")]);
    let page = fs::read_to_string(folder.file("report/index.html")).expect("it was written");
    assert!(page.contains("Time against the maximum depth") && page.contains("aria-label"), "{page}");
    assert!(page.contains("<p>Measured on ") && !page.contains("literal"), "{page}");
    let links = ["src=", "href=", "@import", "url("].map(|link| page.matches(link).count());
    let own = ["src=\"data:image/png;base64,", "href=\"#"].map(|link| page.matches(link).count());
    assert_eq!(links, [own[0], own[1], 0, 0], "the page needs no other file");
    assert!(own[0] == 1 && page.contains("alt=\"The scene materials\""), "the scene is shown");
    assert!(page.contains(">reference</td>") && page.contains("the yardstick"), "names are explained");
    let findings = fs::read_to_string(folder.file("report/findings.json")).expect("it was written");
    let findings: serde_json::Value = serde_json::from_str(&findings).expect("it is JSON");
    assert!(findings.as_array().is_some_and(|findings| findings.len() >= 4), "{findings}");
    assert!(folder.file("report/charts/scale-depth.svg").is_file());
}

#[test]
fn what_is_switched_off_is_timed_on_the_scenes_and_on_the_courses_cases() {
    let folder = Folder::new();
    for case in 1..=4 {
        let scene = format!("matte: m .5 .5 .5\nsphere: 0 0 0 {case} m\n");
        fs::write(folder.file(format!("config{case}.txt")), "camera_position: 0 0 -9\n").expect("it is writable");
        fs::write(folder.file(format!("scene{case}.txt")), scene).expect("it is writable");
    }
    let cases = folder.path().to_str().expect("temporary names are text");
    let results = measure(&folder, "gain.json", &["gain", "--reference", cases]);
    let scenes: BTreeSet<_> = results.gains.iter().map(|gain| gain.scene.as_str()).collect();
    assert_eq!(scenes.len(), 3 + 1 + 4, "{scenes:?}");
    let names: BTreeSet<_> = results.gains.iter().map(|gain| gain.without.as_str()).collect();
    assert!(["soa layout", "no search", "reference"].iter().all(|name| names.contains(name)));
    assert_eq!(results.gains.len(), scenes.len() * names.len(), "every thing on every scene");
    assert!(results.gains.iter().all(|gain| 0.0 < gain.low && gain.low <= gain.ratio && gain.ratio <= gain.high));

    // Without the reference folder, the course's cases are left out, and the results have the reason.
    let tasks = printed(&["bench", "tasks"]);
    let place = 1 + tasks.lines().position(|task| task == "gain case-1").expect("it is a task");
    let part = format!("{place}/{}", tasks.lines().count());
    let results = measure(&folder, "none.json", &["all", "--part", &part]);
    assert!(results.timings.is_empty() && results.omitted[0].reason.contains("--reference"), "{results:?}");
    // Such a task is neither counted nor announced, and there is nothing to go on with.
    let out = folder.name("again.json");
    let output = crate::run(&["bench", "all", "--part", &part, "--quick", "--resume", "--out", &out]);
    let said = String::from_utf8(output.stderr).expect("it is text");
    assert!(output.status.success() && said.contains("no interrupted measurement to go on with"), "{said}");
    assert!(!said.contains("task 1"), "{said}");
}

#[test]
fn intersections_have_cost_and_error_in_data_and_report() {
    let folder = Folder::new();
    let tasks = printed(&["bench", "tasks"]);
    let place = 1 + tasks.lines().position(|task| task == "intersection sphere").expect("it is a task");
    let part = format!("{place}/{}", tasks.lines().count());
    let results = measure(&folder, "one.json", &["all", "--part", &part]);
    assert_eq!(results.intersections.len(), 2 * 5, "five implementations on ordinary and on hard rays");
    let lines = fs::read_to_string(folder.file("one-intersections.csv")).expect("it was written");
    assert_eq!(lines.lines().count(), 1 + 2 * 5);

    printed(&["report", &folder.name("one.json"), "--out", &folder.name("report")]);
    let chart = fs::read_to_string(folder.file("report/charts/intersection-sphere.svg")).expect("it was written");
    assert!(["exact f64", "projected f32", "ns a test"].iter().all(|text| chart.contains(text)), "{chart}");
    let page = fs::read_to_string(folder.file("report/index.html")).expect("it was written");
    assert!(page.contains("Intersections against exact arithmetic"), "{page}");
}

#[cfg(unix)]
#[test]
fn an_interrupted_measurement_is_kept_and_goes_on() {
    use std::io::{BufRead, BufReader};
    use std::process::Stdio;

    let folder = Folder::new();
    let out = folder.name("gain.json");
    let arguments = ["bench", "gain", "--quick", "--repeats", "1", "--out", &out];
    let mut child = lab(&arguments).stderr(Stdio::piped()).spawn().expect("the program runs");
    let mut lines = BufReader::new(child.stderr.take().expect("it is piped")).lines().map_while(Result::ok);
    assert!(lines.any(|line| line.starts_with("task 2 of 4: gain grid")), "the first task ends");
    let process = nix::unistd::Pid::from_raw(i32::try_from(child.id()).expect("it is small"));
    nix::sys::signal::kill(process, nix::sys::signal::SIGINT).expect("it runs");
    let rest: Vec<_> = lines.collect();
    let status = child.wait().expect("it ends");
    // On a fast machine the program may end before the signal comes.
    if status.success() {
        return;
    }
    assert_eq!(status.code(), Some(130), "{rest:?}");
    assert!(rest.last().is_some_and(|line| line.contains("the same command with --resume goes on")), "{rest:?}");
    assert_eq!(folder.names(), ["gain.json.partial"]);

    assert!(complaint(&arguments).contains("has an interrupted measurement: --resume goes on"));
    let other = complaint(&["bench", "gain", "--quick", "--repeats", "3", "--out", &out, "--resume"]);
    assert!(other.contains("measured with other options"), "{other}");
    let resumed = crate::run(&[&arguments[..], &["--resume"]].concat());
    let said = String::from_utf8(resumed.stderr).expect("it is text");
    assert!(resumed.status.success() && said.contains("going on after 1 of 4 tasks"), "{said}");
    assert!(!said.contains("task 1 of 4") && said.contains("task 4 of 4"), "{said}");
    assert_eq!(folder.names(), ["gain-error.csv", "gain-intersections.csv", "gain.csv", "gain.json"]);
}

#[test]
fn what_cannot_be_measured_joined_or_shown_is_an_error() {
    let folder = Folder::new();
    assert!(complaint(&["bench", "energy", "--out", "/nowhere/e.json"]).contains("/nowhere/e.json"));
    let out = folder.name("out.json");
    assert!(complaint(&["bench", "merge", "--out", &out, "README.md"]).starts_with("Error: README.md: "));
    assert!(complaint(&["report", "README.md", "--out", &folder.name("r")]).starts_with("Error: README.md: "));
    assert!(folder.names().is_empty());
}

#[test]
fn the_name_of_an_instruction_set_that_the_machine_lacks_is_an_error() {
    let folder = Folder::new();
    let (config, scene) = ("scenes/spheres/config.txt", "scenes/spheres/scene.txt");
    for arguments in [
        &["bench", "energy", "--quick", "--out", &folder.name("energy.json")][..],
        &["render", config, scene, &folder.name("out.ppm")],
    ] {
        let output = lab(arguments).env("RENDER_INSTRUCTION_SET", "avx3").output().expect("the program runs");
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {output:?}");
        let message = String::from_utf8(output.stderr).expect("it is text");
        let start = "Error: RENDER_INSTRUCTION_SET is \"avx3\", and this machine has portable";
        assert!(message.starts_with(start), "{message}");
    }
    assert!(folder.names().is_empty(), "{:?}", folder.names());
    let rendered = ["render", config, scene, &folder.name("out.ppm"), "--set", "samples_per_pixel=1"];
    let output = lab(&rendered).env("RENDER_INSTRUCTION_SET", "portable").output().expect("the program runs");
    assert!(output.status.success(), "{output:?}");
}
