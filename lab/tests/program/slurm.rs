//! Tests of the job scripts of `lab/slurm`. A stub replaces `sbatch`: it runs the tasks of an array immediately, one
//! after the other.

use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::process::Command;

use lab::bench::results::Results;
use test_support::folder::Folder;

use crate::COURSE;

/// Returns a command of a job script, with the stub as `sbatch`.
fn job(folder: &Folder, script: &str) -> Command {
    fs::create_dir(folder.file("bin")).expect("the folder is writable");
    let stub = folder.write("bin/sbatch", include_str!("sbatch.sh"));
    fs::set_permissions(stub, fs::Permissions::from_mode(0o755)).expect("it is ours");
    let path = std::env::var("PATH").expect("there is a search path");
    let mut command = test_support::running::bash();
    command.arg(test_support::project_root().join("lab/slurm").join(script)).env("STUB_LOG", folder.file("log"));
    command.env("PATH", format!("{}:{path}", folder.name("bin"))).env("RENDER_LAB", env!("CARGO_BIN_EXE_render-lab"));
    command.env_remove(COURSE);
    command
}

#[test]
fn a_job_submits_itself_again_until_the_picture_is_there() {
    let folder = Folder::new();
    let mut job = job(&folder, "render.sbatch");
    job.current_dir(test_support::project_root()).env("STOP_AFTER", "0s");
    job.args(["scenes/grid/config.txt", "scenes/grid/scene.txt", &folder.name("out.ppm")]);
    let output = job.args(["--set", "image_width=16", "--set", "samples_per_pixel=2"]).output().expect("bash is there");
    let log = fs::read_to_string(folder.file("log")).expect("the stub was called");
    assert!(output.status.success(), "{output:?}\n{log}");
    // The picture has 9 rows, and each job but the last finishes one of them and submits the next job.
    assert_eq!(log.matches("render.sbatch scenes/grid/config.txt").count(), 8, "{log}");
    assert_eq!(folder.names(), ["bin", "log", "out.ppm"]);
}

#[test]
fn an_array_of_jobs_measures_parts_and_another_job_joins_them() {
    let folder = Folder::new();
    fs::create_dir(folder.file("out")).expect("the folder is writable");
    let empty = Results { quick: true, ..Results::default() };
    folder.write("out/empty.json", serde_json::to_string(&empty).expect("it is plain"));

    let output = job(&folder, "submit").arg(folder.file("out")).arg("--quick").output().expect("bash is there");
    let log = fs::read_to_string(folder.file("log")).expect("the stub was called");
    assert!(output.status.success(), "{output:?}\n{log}");
    let said = String::from_utf8(output.stdout).expect("it is text");
    assert!(said.starts_with("8 tasks as job 77; job 77 joins them into "), "{said}");
    assert!(log.contains("--array=1-8"), "{log}");
    assert!(log.contains("--dependency=afterok:77 --kill-on-invalid-dep=yes "), "{log}");
    assert!(said.contains("sbatch --array=N --export=ALL,PARTS=8 ") && said.contains(" --quick\n"), "{said}");
    let joined = Results::read(&folder.file("out/bench.json")).expect("the second job wrote it");
    assert!(joined.timings.iter().any(|timing| timing.setting.parameter == "width"), "{joined:?}");
}

#[test]
fn an_array_of_jobs_checks_teams_and_another_job_measures_them() {
    let folder = Folder::new();
    for team in ["ana", "bea", "carla"] {
        fs::create_dir_all(folder.file("st").join(team)).expect("the folder is writable");
        let program = folder.write(&format!("st/{team}/render"), "#!/bin/sh\nexit 1\n");
        fs::set_permissions(program, fs::Permissions::from_mode(0o755)).expect("it is ours");
    }
    let mut commands = Vec::new();
    for task in ["1", "2", ""] {
        let mut command = Command::new("bash");
        command.arg(test_support::project_root().join("lab/slurm/grade.sbatch")).current_dir(folder.path());
        command.args(["st", "results", "--rounds", "1"]).env("RENDER_LAB", env!("CARGO_BIN_EXE_render-lab"));
        if !task.is_empty() {
            command.env("SLURM_ARRAY_TASK_ID", task).env("SLURM_ARRAY_TASK_COUNT", "2");
        }
        let output = command.output().expect("bash is there");
        assert!(output.status.success(), "{output:?}");
        commands.push(String::from_utf8(output.stdout).expect("it is text").lines().count());
    }
    // Each part has the head of the table and its teams.
    assert_eq!(commands, [3, 2, 4]);
    let names = folder.names_in("results");
    assert_eq!(names, ["001-ana", "002-bea", "003-carla", "grades.csv", "index.html"]);
}
