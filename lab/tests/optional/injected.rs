//! Makes one system call of `render-lab` fail in each run, or sends a signal during the call, and checks the files
//! afterwards. Each command that writes files is run with every kind of disturbance.
//!
//! Of the system calls with one name, only a few are disturbed, spread evenly over the run. With
//! `RENDER_ALL=1` all are disturbed. If `strace` cannot run, these tests are shown as ignored.

use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};

use libtest_mimic::{Failed, Trial};
use test_support::folder::Folder;
use test_support::injection::{Disturbance, Job, check_syncs, most, unavailable};
use test_support::trial;

/// Number of calls with one name that are disturbed.
const MOST: usize = 2;

const DISTURBANCES: [(Disturbance, &str); 5] = [
    (Disturbance::Errors, "every_call_fails_and_the_old_files_stand_or_the_new_ones"),
    (Disturbance::Signal, "a_signal_in_every_call_leaves_the_old_files_or_the_new_ones"),
    (Disturbance::SignalAsProcessOne, "a_signal_in_every_call_ends_process_1"),
    (Disturbance::Named, "the_same_where_a_file_needs_a_name"),
    (Disturbance::NamedAsProcessOne, "a_signal_in_every_call_ends_process_1_where_a_file_needs_a_name"),
];

/// A function that prepares a folder for a command, and returns the job that runs the command there.
type Prepare = fn(&Path) -> Job;

const COMMANDS: [(&str, Prepare); 6] = [
    ("render", render),
    ("compare", compare),
    ("compare_from_the_start", compare_from_the_start),
    ("merge", merge),
    ("report", report),
    ("report_with_a_thumbnail", report_with_a_thumbnail),
];

/// Returns one trial for each pair of a command and a disturbance.
pub fn trials() -> Vec<Trial> {
    let mut trials = Vec::new();
    for (disturbance, name) in DISTURBANCES {
        let missing = unavailable(disturbance);
        for (command, job) in COMMANDS {
            // These disturbances cannot reach the call that creates the file of the heat map: the call comes before the
            // gate, and in both threads a call of this name has this number.
            let is_named = matches!(disturbance, Disturbance::Named | Disturbance::NamedAsProcessOne);
            if command.starts_with("compare") && is_named {
                continue;
            }
            for (old, place) in [(None, "free"), (Some("old"), "taken")] {
                // A thumbnail makes the run ten times as long, and adds no call that writes. So it is tested with only
                // one disturbance, and only if all calls are disturbed.
                let has_thumbnail = command == "report_with_a_thumbnail";
                let is_left_out = disturbance != Disturbance::Errors || old.is_none() || !test_support::everything();
                if has_thumbnail && is_left_out {
                    continue;
                }
                let test = move || disturb(job, old, disturbance);
                trials.push(trial(format!("injected::{name}_{command}_{place}"), missing, test));
            }
        }
    }
    let missing = unavailable(Disturbance::Errors);
    trials.push(trial("injected::a_picture_and_its_folder_are_synced_except_with_no_sync", missing, sync));
    trials
}

fn sync() -> Result<(), Failed> {
    let folder = Folder::new();
    fs::create_dir(folder.file("d"))?;
    let Job { program, arguments, folder: d, gate, .. } = render(folder.path());
    if let Some((path, content)) = gate {
        fs::write(path, content)?;
    }
    Ok(check_syncs(&program, &arguments, &d, 1)?)
}

fn disturb(job: Prepare, old: Option<&str>, disturbance: Disturbance) -> Result<(), Failed> {
    let folder = Folder::new();
    fs::create_dir(folder.file("d"))?;
    let job = Job { old: old.map(|text| text.as_bytes().to_vec()), ..job(folder.path()) };
    job.disturb(disturbance)?;
    Ok(())
}

/// Returns a job with the arguments in `words`, in which `./` stands for `folder`. The job writes into `./d`. Its gate
/// is the file `./gate`, which has the content `gate`.
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
        most: most(MOST),
    }
}

fn write(folder: &Path, name: &str, content: impl AsRef<[u8]>) {
    fs::write(folder.join(name), content).expect("the folder is writable");
}

/// Returns a job for `render`. After a signal, `render` stops at the end of a row or finishes the picture, so the job
/// is graceful.
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

/// Returns a job for `compare` without a gate. `compare` opens the heat map's file before it reads the pictures, which
/// is before the gate. Without a gate, the calls for that file are disturbed too.
fn compare_from_the_start(folder: &Path) -> Job {
    write(folder, "gate", BLACK);
    Job { gate: None, ..compare(folder) }
}

/// Returns results with one entry in each list, so that few charts are drawn. All entries belong to `scene`. A
/// thumbnail of `scene` is drawn if the project has a scene with this name.
fn results(scene: &str) -> Vec<u8> {
    let path = test_support::project_root().join("docs/report/data/bench.json");
    let text = fs::read(path).expect("it is committed");
    let mut value: serde_json::Value = serde_json::from_slice(&text).expect("it is JSON");
    let lists = value.as_object_mut().expect("it has names").values_mut().filter_map(|value| value.as_array_mut());
    for list in lists {
        list.truncate(1);
        list.iter_mut().filter_map(|entry| entry.get_mut("scene")).for_each(|name| *name = scene.into());
    }
    value.to_string().into_bytes()
}

fn merge(folder: &Path) -> Job {
    write(folder, "part", results("none"));
    job(folder, "bench merge --out ./d/all.json ./gate ./part", &results("none"))
}

fn report(folder: &Path) -> Job {
    job(folder, "report ./gate --out ./d", &results("none"))
}

fn report_with_a_thumbnail(folder: &Path) -> Job {
    job(folder, "report ./gate --out ./d", &results("spheres"))
}
