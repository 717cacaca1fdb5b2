//! Tests that calls are recorded, and that the checks find programs which lose files or leave additional ones.

use super::*;

#[test]
fn calls_are_counted_by_thread_from_the_first_that_names_the_output() {
    let text =
        "7 openat(1, \"c\") = 3\n8 openat(1, \"x\") = 3\n7 brk(0) = 1\n7 openat(1, \"d/out\") = 3\n8 close(3) = 0\n";
    let found = |only_folder| -> Vec<_> {
        calls::calls(text, "d/out", only_folder).into_iter().map(|call| (call.name, call.number)).collect()
    };
    assert_eq!(found(false), [("openat".to_owned(), 2), ("close".to_owned(), 1)]);
    assert_eq!(found(true), [("openat".to_owned(), 2)]);
}

#[test]
fn a_call_that_two_threads_make_is_left_out_and_one_thread_needs_no_number() {
    let text = "7 close(1) = 0\n8 write(1, \"d/out\") = 3\n8 close(3) = 0\n8 close(4) = 0\n";
    let found: Vec<_> = calls::calls(text, "d/out", false).into_iter().map(|call| (call.name, call.number)).collect();
    assert_eq!(found, [("write".to_owned(), 1), ("close".to_owned(), 2)]);
    let found = calls::calls("write(1</d/out>, \"\", 0) = 0\nclose(1</d/out>) = 0\n", "d/out", false);
    assert_eq!(found.len(), 2);
}

/// Returns a job that runs a bash script. The script's first argument is the path of the output file, and the second is
/// the path of the gate.
fn job(script: &str, with_gate: bool) -> (tempfile::TempDir, Job) {
    let folder = tempfile::tempdir().expect("the temporary folder is writable");
    let [out_folder, gate] = ["d", "gate"].map(|name| folder.path().join(name));
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

#[test]
fn a_program_that_writes_in_place_is_found_out() {
    if unavailable(Disturbance::Errors).is_some() {
        return;
    }
    for with_gate in [false, true] {
        let script = if with_gate { "read -r x < $2; echo new > $1" } else { "echo new > $1" };
        let (_folder, in_place) = job(script, with_gate);
        let error = in_place.disturb(Disturbance::Errors).expect_err("the old file is lost");
        assert!(error.starts_with("inject="), "{error}");
    }
}

#[test]
fn a_program_that_leaves_a_second_file_when_it_is_stopped_is_found_out() {
    if unavailable(Disturbance::Signal).is_some() {
        return;
    }
    let script = "read -r x < $2; echo new > $1.tmp; mv $1.tmp $1; true";
    let (_folder, careless) = job(script, true);
    let error = careless.disturb(Disturbance::Signal).expect_err("the temporary file is left");
    assert!(error.contains("alone false"), "{error}");
}
