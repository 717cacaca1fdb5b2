//! Tests that run shaders on the device. A module of this program is run alone by its name, such as `hierarchy::`.

#[path = "../common/mod.rs"]
mod common;
mod conformance;
mod exact;
mod first_difference;
mod gpu;
mod hierarchy;
mod images;
#[path = "../kernels/mod.rs"]
mod kernels;
mod lowered;
mod mutants;
mod pictures;
mod running;
#[path = "../common/sampled.rs"]
mod sampled;
mod samples;
#[path = "../common/scenes.rs"]
mod scenes;
