//! Runs the programs `shader-lab`, `stress` and `lower-f64` as a user does.

#[path = "../common/mod.rs"]
mod common;
mod limits;
#[cfg(target_os = "linux")]
mod little_memory;
mod lower_f64;
mod shader_lab;
mod stress;
