//! Tests `shader-lab` while it writes its pictures: a system call fails, or a signal comes during a call.
//!
//! The driver needs much time to start. So only two calls of each name that concern the pictures are disturbed, and no
//! calls of the driver. With `RENDER_ALL=1`, as in tests/extensive, every call that concerns the pictures is disturbed.
//! Signals are then also sent to a program that is process 1, which a signal does not end by default. The module that
//! is rendered is a tiny one. If `strace` cannot run, these tests are shown as ignored.

use std::ffi::OsString;
use std::fs;
use std::path::PathBuf;

use libtest_mimic::{Failed, Trial};
use test_support::folder::Folder;
use test_support::injection::{Disturbance, Job, check_syncs, most, unavailable};
use test_support::{everything, trial};

/// Number of calls with one name that are disturbed.
const MOST: usize = 2;

/// A module that makes every pixel grey. The driver compiles it quickly.
const GREY: &str = "// module: kernels/image
@compute @workgroup_size(64)
fn image(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x < picture.pixel_count {
        pixels[id.x] = vec3_store(vec3<real>(real(0.25)));
    }
}
";

/// The tests: the disturbance, the old content of the output (`None` if there is no file), and the name. Signals are
/// tested only with an old picture, which stays if the signal comes before the new picture is in place.
const CASES: [(Disturbance, Option<&str>, &str); 6] = [
    (Disturbance::Errors, None, "calls_fail_and_no_picture_stands_or_the_new_ones"),
    (Disturbance::Errors, Some("old"), "calls_fail_and_the_old_pictures_stand_or_the_new_ones"),
    (Disturbance::Signal, Some("old"), "a_signal_in_a_call_leaves_the_old_pictures_or_the_new_ones"),
    (Disturbance::SignalAsProcessOne, Some("old"), "a_signal_in_a_call_ends_process_1"),
    (Disturbance::Named, Some("old"), "failures_and_signals_where_a_file_needs_a_name"),
    (Disturbance::NamedAsProcessOne, Some("old"), "a_signal_ends_process_1_where_a_file_needs_a_name"),
];

/// Returns one trial for each entry of [`CASES`].
pub fn trials() -> Vec<Trial> {
    let disturbed = |(disturbance, old, name): (Disturbance, Option<&'static str>, &str)| {
        let is_process_one = matches!(disturbance, Disturbance::SignalAsProcessOne | Disturbance::NamedAsProcessOne);
        let not_all = (is_process_one && !everything()).then_some("needs RENDER_ALL=1");
        let missing = unavailable(disturbance).or(not_all);
        trial(format!("injected::{name}"), missing, move || disturb(disturbance, old))
    };
    let name = "injected::both_pictures_and_their_folder_are_synced_except_with_no_sync";
    let sync = trial(name, unavailable(Disturbance::Errors), sync);
    CASES.into_iter().map(disturbed).chain([sync]).collect()
}

fn sync() -> Result<(), Failed> {
    let folder = Folder::new();
    let Job { program, arguments, folder: d, gate, .. } = job(&folder)?;
    gate.into_iter().try_for_each(|(path, content)| fs::write(path, content))?;
    // The second picture shows the difference.
    Ok(check_syncs(&program, &arguments, &d, 2)?)
}

fn disturb(disturbance: Disturbance, old: Option<&str>) -> Result<(), Failed> {
    let folder = Folder::new();
    let job = Job { old: old.map(|text| text.as_bytes().to_vec()), ..job(&folder)? };
    job.disturb(disturbance)?;
    Ok(())
}

fn job(folder: &Folder) -> std::io::Result<Job> {
    fs::create_dir(folder.file("d"))?;
    let (module, scene, config) = (folder.write("grey.wgsl", GREY), folder.write("scene", ""), folder.file("config"));
    let mut arguments = vec![module.into_os_string()];
    for (option, path) in [("--config", &config), ("--scene", &scene), ("--out", &folder.file("d/out.png"))] {
        arguments.extend([OsString::from(option), path.into()]);
    }
    Ok(Job {
        program: PathBuf::from(env!("CARGO_BIN_EXE_shader-lab")),
        arguments,
        folder: folder.file("d"),
        old: None,
        graceful: false,
        gate: Some((config, b"image_width: 8\nmax_depth: 1\n".to_vec())),
        only_folder: true,
        most: most(MOST),
    })
}
