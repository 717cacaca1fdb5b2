//! The commands that write files, each with every disturbance.

use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};

use libtest_mimic::{Failed, Trial};
use test_support::injection::{Disturbance, Job, unavailable};

const DISTURBANCES: [(Disturbance, &str); 4] = [
    (Disturbance::Errors, "every_call_fails_and_the_old_files_stand_or_the_new_ones"),
    (Disturbance::Signal, "a_signal_in_every_call_leaves_the_old_files_or_the_new_ones"),
    (Disturbance::SignalAsProcessOne, "a_signal_in_every_call_ends_process_1"),
    (Disturbance::Named, "the_same_where_a_file_needs_a_name"),
];

/// Prepares a folder for a command, and says how the command is run there.
type Prepare = fn(&Path) -> Job;

const COMMANDS: [(&str, Prepare); 5] = [
    ("render", render),
    ("compare", compare),
    ("compare_from_the_start", compare_from_the_start),
    ("merge", merge),
    ("report", report),
];

pub fn trials() -> Vec<Trial> {
    let mut trials = Vec::new();
    for (disturbance, name) in DISTURBANCES {
        let missing = unavailable(disturbance);
        for (command, job) in COMMANDS {
            // Neither disturbs the call that makes the heat map's file: it comes before the gate, and two threads make
            // calls of its name and number.
            if command.starts_with("compare") && disturbance == Disturbance::Named {
                continue;
            }
            let test = move || [None, Some("old")].into_iter().try_for_each(|old| disturb(job, old, disturbance));
            let trial = Trial::test(format!("{name}_{command}"), test);
            trials.push(trial.with_kind(missing.unwrap_or_default()).with_ignored_flag(missing.is_some()));
        }
    }
    trials
}

fn disturb(job: Prepare, old: Option<&str>, disturbance: Disturbance) -> Result<(), Failed> {
    let folder = tempfile::tempdir()?;
    fs::create_dir(folder.path().join("d"))?;
    let job = Job { old: old.map(|text| text.as_bytes().to_vec()), ..job(folder.path()) };
    println!("{} runs", job.disturb(disturbance)?);
    Ok(())
}

/// A job whose arguments are words; a word that starts with `./` is a file in `folder`. Its output is in `./d`, and the
/// file `./gate` has this content.
fn job(folder: &Path, words: &str, gate: &[u8]) -> Job {
    let argument = |word: &str| match word.strip_prefix("./") {
        Some(name) => folder.join(name).into_os_string(),
        None => OsString::from(word),
    };
    Job {
        program: PathBuf::from(env!("CARGO_BIN_EXE_render-lab")),
        arguments: words.split(' ').map(argument).collect(),
        folder: folder.join("d"),
        old: None,
        graceful: false,
        gate: Some((folder.join("gate"), gate.to_vec())),
        only_folder: false,
        most: 12,
    }
}

fn write(folder: &Path, name: &str, content: impl AsRef<[u8]>) {
    fs::write(folder.join(name), content).expect("the folder is writable");
}

/// Stops at the end of a row, or goes on to the end.
fn render(folder: &Path) -> Job {
    write(folder, "scene", "");
    let config = b"image_width: 60\naspect_ratio: 1 1\nsamples_per_pixel: 1\n";
    Job { graceful: true, ..job(folder, "render ./gate ./scene ./d/out.png", config) }
}

const BLACK: &str = "P3\n2 1\n255\n0 0 0\n0 0 0\n";

fn compare(folder: &Path) -> Job {
    write(folder, "other", BLACK.replace("0 0 0\n0 0 0", "0 0 0\n0 0 6"));
    job(folder, "compare ./gate ./other --heatmap ./d/map.png", BLACK.as_bytes())
}

/// The place of the heat map is opened before the pictures are read, so before the gate.
fn compare_from_the_start(folder: &Path) -> Job {
    write(folder, "gate", BLACK);
    Job { gate: None, ..compare(folder) }
}

/// Results with little in them, so that few charts are drawn.
fn results() -> Vec<u8> {
    let path = test_support::project_root().join("docs/report/data/bench.json");
    let text = fs::read(path).expect("it is committed");
    let mut value: serde_json::Value = serde_json::from_slice(&text).expect("it is JSON");
    let lists = value.as_object_mut().expect("it has names").values_mut().filter_map(|value| value.as_array_mut());
    lists.for_each(|list| list.truncate(1));
    value.to_string().into_bytes()
}

fn merge(folder: &Path) -> Job {
    write(folder, "part", results());
    job(folder, "bench merge --out ./d/all.json ./gate ./part", &results())
}

fn report(folder: &Path) -> Job {
    job(folder, "report ./gate --out ./d", &results())
}
