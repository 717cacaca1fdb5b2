//! Passes the compiler's version and the build profile to the program, which stores them with measured times.

use std::process::Command;

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    let compiler = std::env::var_os("RUSTC").unwrap_or("rustc".into());
    let output = Command::new(compiler).arg("--version").output();
    let text = output.map(|output| String::from_utf8_lossy(&output.stdout).trim().to_owned()).unwrap_or_default();
    println!("cargo::rustc-env=LAB_COMPILER={}", if text.is_empty() { "unknown" } else { &text });
    println!("cargo::rustc-env=LAB_PROFILE={}", std::env::var("PROFILE").unwrap_or_default());
}
