//! Tests of `render-lab bench`, `time` and `report`. The only times that are compared differ by a factor of 100,
//! because the machine may be busy.

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
    assert_eq!(folder.names(), ["depth.json"]);

    let merged = folder.name("merged.json");
    printed(&["bench", "merge", "--out", &merged, &folder.name("depth.json"), &folder.name("depth.json")]);
    let merged = Results::read(&folder.file("merged.json")).expect("it was written");
    assert!(merged.timings.iter().all(|timing| timing.seconds.len() == 4));

    // A text that a terminal would obey is shown in the escapes of JSON.
    let text = fs::read_to_string(folder.file("depth.json")).expect("it was written");
    let named = text.replacen("\"processor\": \"", "\"processor\": \"\u{202e}", 1);
    fs::write(folder.file("named.json"), named).expect("it can be written");
    let shown = printed(&["bench", "merge", "--out", "-", &folder.name("named.json")]);
    assert!(shown.contains(r"\u202e") && !shown.contains('\u{202e}'), "{shown}");

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
    assert!(findings["sentences"].as_array().is_some_and(|sentences| sentences.len() >= 3), "{findings}");
    let layouts = findings["layouts"].as_array().expect("it is a list");
    let of_aos = results.timings.iter().filter(|timing| timing.setting.engine.starts_with("aos"));
    assert!(layouts.len() == 1 && layouts[0]["pairs"] == of_aos.count(), "{findings}");
    assert!(folder.file("report/charts/scale-depth.svg").is_file());

    let spanish = ["--language", "es", "--pdf", "../report.pdf", "--out", &folder.name("es")];
    printed(&[&["report", &folder.name("depth.json")], &spanish[..]].concat());
    let page = fs::read_to_string(folder.file("es/index.html")).expect("it was written");
    let link = "<a href=\"../report.pdf\">report.pdf</a>";
    let texts = ["<html lang=\"es\">", link, "Tiempo frente a la profundidad máxima", "<p>Medido el "];
    assert_eq!(texts.map(|text| page.contains(text)), [true; 4], "{page}");
}

#[test]
fn commands_are_timed_in_turn_and_a_slower_one_is_found() {
    let folder = Folder::new();
    // Both become so much slower that no load of the machine can hide it.
    for (name, seconds) in [("old", ".02"), ("new", ".6")] {
        folder.write("case.sh", format!("sleep {seconds}"));
        let line = format!("$lab time --rounds 3 --json 'sh case.sh' 'sh ./case.sh' >{name}.json");
        let output = crate::bash(&folder, &line);
        assert!(output.status.success(), "{output:?}");
    }
    let diff = |old, new| {
        let output = crate::run(&["bench", "diff", &folder.name(old), &folder.name(new), "--least", "200"]);
        (output.status.code(), String::from_utf8_lossy(&output.stdout).into_owned())
    };
    let (status, text) = diff("old.json", "new.json");
    assert!(status == Some(1) && text.contains("\nslower") && text.contains("2 slower, 0 faster, "), "{text}");
    let (status, text) = diff("new.json", "old.json");
    assert!(status == Some(0) && text.contains("\nfaster") && text.contains("sh case.sh"), "{text}");
    // A command that waits takes long, though it takes no user time. All values of a parameter are measured.
    let command =
        ["time", "--rounds", "3", "--json", "--parameter", "s=.1,.4", "sleep {s}", "--prepare", "test {s} != 1"];
    let record: serde_json::Value = printed(&command).parse().expect("it is JSON");
    let elapsed = [0, 1].map(|at| record["commands"][at]["wall"]["median"].as_f64().unwrap_or_default());
    assert_eq!(
        (&record["commands"][1]["command"], record["commands"].as_array().map(Vec::len)),
        (&"sleep .4".into(), Some(2))
    );
    assert!(elapsed[1] > 1.5 * elapsed[0] && elapsed[0] > 0.09, "{record}");
    let table = printed(&["time", "--rounds", "3", "sleep .1", "sleep .4"]);
    assert!(table.trim_start().starts_with("elapsed "), "{table}");
    let said = complaint(&["time", "--parameter", "x=1", "true"]);
    assert!(said.ends_with("Error: --parameter x: no command has {x}\n"), "{said}");
    let said = complaint(&["time", "--prepare", "exit 4", "true"]);
    assert!(said.ends_with("Error: exit 4: exit status 4\n"), "{said}");
    assert!(complaint(&["time", "true", "exit 3"]).ends_with("Error: exit 3: exit status 3\n"));
    assert!(complaint(&["time", "kill -SEGV $$"]).ends_with("ended by signal SIGSEGV\n"));
}

#[test]
fn an_interrupted_measurement_writes_nothing() {
    use std::io::{BufRead, BufReader};
    use std::process::Stdio;

    let folder = Folder::new();
    let out = folder.name("scale.json");
    let mut child = lab(&["bench", "scale", "--out", &out]).stderr(Stdio::piped()).spawn().expect("the program runs");
    let mut lines = BufReader::new(child.stderr.take().expect("it is piped")).lines().map_while(Result::ok);
    assert!(lines.any(|line| line == "task 1 of 5: scale width"), "the first task begins");
    let process = nix::unistd::Pid::from_raw(i32::try_from(child.id()).expect("it is small"));
    // SIGTERM, because a program that a shell starts in the background, or under `nohup`, may ignore SIGINT or SIGHUP.
    nix::sys::signal::kill(process, nix::sys::signal::SIGTERM).expect("it runs");
    let said: Vec<_> = lines.collect();
    assert_eq!(child.wait().expect("it ends").code(), Some(130), "{said:?}");
    assert_eq!(said, ["Error: interrupted; nothing was written"]);
    assert!(folder.names().is_empty());
}

#[test]
fn the_name_of_an_instruction_set_that_the_machine_lacks_is_an_error() {
    let folder = Folder::new();
    let render = "render $root/scenes/spheres/config.txt $root/scenes/spheres/scene.txt o.ppm";
    for line in ["bench error --quick --out o.json", "compare a.ppm a.ppm", "time true", "grade .", render] {
        let message = crate::bash_complaint(&folder, &format!("RENDER_INSTRUCTION_SET=avx3 $lab {line}"));
        let start = "Error: RENDER_INSTRUCTION_SET is \"avx3\", and this machine has portable";
        assert!(message.starts_with(start) && folder.names().is_empty(), "{message}");
    }
    let line = format!("RENDER_INSTRUCTION_SET=portable $lab {render} --set samples_per_pixel=1");
    let output = crate::bash(&folder, &line);
    assert!(output.status.success(), "{output:?}");
}
