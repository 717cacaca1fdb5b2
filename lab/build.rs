//! Passes the compiler's version, the build profile and the commit to the program, which stores them with measured
//! times and shows them.

use std::process::Command;

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    let compiler = said(Command::new(std::env::var_os("RUSTC").unwrap_or("rustc".into())).arg("--version"));
    println!("cargo::rustc-env=LAB_COMPILER={}", compiler.unwrap_or("unknown".to_owned()));
    println!("cargo::rustc-env=LAB_PROFILE={}", std::env::var("PROFILE").unwrap_or_default());
    println!("cargo::rustc-env=LAB_COMMIT={}", commit().unwrap_or("unknown".to_owned()));
}

/// Returns the commit that is checked out. The program is built again when another one is.
fn commit() -> Option<String> {
    // The sources may lie in a folder of another repository, such as one of a home folder.
    said(Command::new("git").args(["ls-files", "--error-unmatch", "build.rs"]))?;
    let log = said(Command::new("git").args(["rev-parse", "--git-path", "logs/HEAD"]))?;
    println!("cargo::rerun-if-changed={log}");
    said(Command::new("git").args(["rev-parse", "--short=12", "HEAD"]))
}

/// Returns what a program prints, or `None` if it fails or prints nothing.
fn said(command: &mut Command) -> Option<String> {
    let output = command.output().ok().filter(|output| output.status.success())?;
    Some(String::from_utf8_lossy(&output.stdout).trim().to_owned()).filter(|text| !text.is_empty())
}
