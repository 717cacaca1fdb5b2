//! Runs `compare` with two equal programs, and with programs that write different pictures or none.

use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::path::{Path, PathBuf};
use std::process::Command;

use libtest_mimic::Trial;
use test_support::folder::Folder;
use test_support::trial;

/// Returns the trials.
pub fn trials() -> Vec<Trial> {
    vec![
        trial("equal programs have a ratio and status 0", None, || Ok(equal_programs()?)),
        trial("different pictures have status 1, and a program that fails has 2", None, || Ok(other_programs()?)),
        trial("an unknown instruction set in the environment has status 2", None, || Ok(unknown_set()?)),
    ]
}

/// Compares the reference with the program `new`. Returns the exit status, and what was printed on both outputs.
fn compare(folder: &Folder, new: &Path) -> Result<(Option<i32>, String, String), String> {
    compare_with(folder, new, None)
}

/// Compares as [`compare`] does, with this value of `RENDER_INSTRUCTION_SET`.
fn compare_with(folder: &Folder, new: &Path, set: Option<&str>) -> Result<(Option<i32>, String, String), String> {
    let [config, scene] = ["config.txt", "scene.txt"].map(|name| folder.file(name));
    let mut command = Command::new(env!("CARGO_BIN_EXE_compare"));
    command.args(["--rounds", "2", env!("CARGO_BIN_EXE_reference")]).args([new, &config, &scene]);
    command.envs(set.map(|set| ("RENDER_INSTRUCTION_SET", set)));
    let output = command.output().map_err(|error| error.to_string())?;
    let [out, err] = [output.stdout, output.stderr].map(|bytes| String::from_utf8_lossy(&bytes).into_owned());
    Ok((output.status.code(), out, err))
}

fn folder() -> Folder {
    Folder::with_scene("image_width: 16\n", "matte: m 1 1 1\nsphere: 0 0 0 3 m\n")
}

/// Writes a program, which is a line of shell.
fn script(folder: &Folder, name: &str, line: &str) -> PathBuf {
    let path = folder.write(name, format!("#!/bin/sh\n{line}\n"));
    fs::set_permissions(&path, fs::Permissions::from_mode(0o755)).expect("it is ours");
    path
}

fn equal_programs() -> Result<(), String> {
    let (status, out, err) = compare(&folder(), Path::new(env!("CARGO_BIN_EXE_reference")))?;
    assert_eq!(status, Some(0), "{err}");
    let row = out.split_once("scene.txt: ").and_then(|(_, row)| row.split_once(" (")).ok_or(out.clone())?;
    let ratio: f64 = row.0.parse().map_err(|_| out.clone())?;
    assert!((0.2..5.0).contains(&ratio) && row.1.contains(", 2 rounds), ") && !out.contains("DIFFER"), "{out}");
    Ok(())
}

fn other_programs() -> Result<(), String> {
    let folder = folder();
    let (status, out, _) = compare(&folder, &script(&folder, "other", "echo P3 1 1 255 0 0 0 >\"$3\""))?;
    assert!(status == Some(1) && out.contains("; THE PICTURES DIFFER"), "{status:?}: {out}");
    let (status, out, err) = compare(&folder, &script(&folder, "failing", "exit 3"))?;
    assert!(status == Some(2) && out.is_empty() && err.contains("failing fails with "), "{status:?}: {err}");
    Ok(())
}

fn unknown_set() -> Result<(), String> {
    let (status, out, err) = compare_with(&folder(), Path::new(env!("CARGO_BIN_EXE_reference")), Some("avx3"))?;
    let is_refused =
        status == Some(2) && out.is_empty() && err.starts_with("Error: RENDER_INSTRUCTION_SET is \"avx3\"");
    assert!(is_refused, "{status:?}: {out}{err}");
    Ok(())
}
