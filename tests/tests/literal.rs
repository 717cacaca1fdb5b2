//! The literal program in C++ (`tests/literal`), built here, gives the bytes whose digests `tests/cases` has.
//!
//! So those digests can be made again from what is in the repository, and the program that times are held against is one
//! that renders the same pictures. Where there is no g++ the tests are shown as ignored.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::Arc;

use cpu::Scatter;
use libtest_mimic::{Arguments, Failed, Trial};
use tests::golden::{self, Golden};
use tests::{digest, p3};

/// Not any C++ compiler: the digests rest on the distributions of its library.
const COMPILER: &str = "g++";

fn main() {
    let arguments = Arguments::from_args();
    let cases = golden::cases();
    assert_eq!(cases.len(), 32, "16 scenes in both conventions");
    let runs = Command::new(COMPILER).arg("--version").output().is_ok_and(|output| output.status.success());

    let folder = tempfile::tempdir().expect("the temporary folder is writable");
    // Built once, before the tests that share it; a list of names needs no program.
    let program = if runs && !arguments.list { build(folder.path()) } else { Err("it was not built".to_owned()) };
    let program = Arc::new(program);
    let trial = |golden: Golden| {
        let program = Arc::clone(&program);
        let trial = Trial::test(format!("case {} by the literal program", golden.name), move || {
            let program = program.as_ref().as_ref().map_err(Clone::clone)?;
            has_its_digest(&golden, program)
        });
        if runs { trial } else { trial.with_kind("needs g++").with_ignored_flag(true) }
    };
    let conclusion = libtest_mimic::run(&arguments, cases.into_iter().map(trial).collect());
    // Leaving the process drops nothing.
    drop(folder);
    conclusion.exit();
}

/// Builds the program in `folder`.
fn build(folder: &Path) -> Result<PathBuf, String> {
    let program = folder.join("literal");
    let mut compiler = Command::new(COMPILER);
    // A product and a sum that are rounded once give other bytes than two operations.
    compiler.args(["-std=c++20", "-O2", "-ffp-contract=off", "-o"]).arg(&program);
    compiler.arg(tests::project_root().join("tests/literal/literal.cpp"));
    check(&compiler.output().map_err(|error| error.to_string())?)?;
    Ok(program)
}

fn has_its_digest(golden: &Golden, program: &Path) -> Result<(), Failed> {
    let folder = tempfile::tempdir()?;
    let out = folder.path().join("out.ppm");
    let mut command = Command::new(program);
    command.args([&golden.config, &golden.scene, &out]);
    if golden.scatter == Scatter::Published {
        command.arg("published");
    }
    check(&command.output()?)?;
    let bytes = std::fs::read(out)?;
    p3::read(&bytes)?;
    let (actual, expected) = (digest::sha256(&bytes), golden.digest()?);
    if actual == expected { Ok(()) } else { Err(format!("{actual} instead of {expected}").into()) }
}

/// Both commands succeed without a word.
fn check(output: &Output) -> Result<(), String> {
    let silent = output.stdout.is_empty() && output.stderr.is_empty();
    if output.status.success() && silent { Ok(()) } else { Err(format!("{output:?}")) }
}
