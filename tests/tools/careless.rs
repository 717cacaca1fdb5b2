//! Tests that the checks of [`test_support::injection`] find programs that lose files, leave additional ones, or sync
//! nothing. These tests need strace.

use std::ffi::OsString;
use std::fs;
use std::path::Path;

use libtest_mimic::{Failed, Trial};
use test_support::folder::Folder;
use test_support::injection::{Disturbance, Job, check_syncs, unavailable};
use test_support::trial;

pub fn trials() -> Vec<Trial> {
    let [errors, signal] = [Disturbance::Errors, Disturbance::Signal].map(unavailable);
    vec![
        trial("careless: a_program_that_writes_in_place_is_found_out", errors, writes_in_place),
        trial("careless: a_program_that_leaves_a_second_file_when_it_is_stopped_is_found_out", signal, leaves_a_file),
        trial("careless: a_program_that_syncs_nothing_is_found_out", errors, syncs_nothing),
    ]
}

fn writes_in_place() -> Result<(), Failed> {
    for with_gate in [false, true] {
        let script = if with_gate { "read -r x < $2; echo new > $1" } else { "echo new > $1" };
        let (_folder, in_place) = job(script, with_gate);
        let error = in_place.disturb(Disturbance::Errors).expect_err("the old file is lost");
        assert!(error.starts_with("inject="), "{error}");
    }
    Ok(())
}

fn leaves_a_file() -> Result<(), Failed> {
    let (_folder, careless) = job("read -r x < $2; echo new > $1.tmp; mv $1.tmp $1; true", true);
    let error = careless.disturb(Disturbance::Signal).expect_err("the temporary file is left");
    assert!(error.contains("alone false"), "{error}");
    Ok(())
}

fn syncs_nothing() -> Result<(), Failed> {
    let folder = Folder::new();
    let out = folder.file("d");
    fs::create_dir(&out)?;
    let error = check_syncs(Path::new("true"), &[], &out, 1).expect_err("nothing is synced");
    assert!(error.contains("1 files and their folder"), "{error}");
    Ok(())
}

/// Returns a job that runs a bash script. The script's first argument is the path of the output file, and the second is
/// the path of the gate.
fn job(script: &str, with_gate: bool) -> (Folder, Job) {
    let folder = Folder::new();
    let [out_folder, gate] = ["d", "gate"].map(|name| folder.file(name));
    fs::create_dir(&out_folder).expect("the folder is writable");
    let mut arguments = ["-c", script, "job"].map(OsString::from).to_vec();
    arguments.extend([out_folder.join("out"), gate.clone()].map(OsString::from));
    let job = Job {
        program: "bash".into(),
        arguments,
        folder: out_folder,
        old: Some(b"old".to_vec()),
        graceful: false,
        gate: with_gate.then(|| (gate, b"x\n".to_vec())),
        only_folder: false,
        most: usize::MAX,
    };
    (folder, job)
}
