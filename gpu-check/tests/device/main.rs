//! Tests that run shaders on the device. A module of this program is run alone by its name, such as `hierarchy::`.

#[path = "../common/mod.rs"]
mod common;
mod exact;
mod features;
mod first_difference;
mod gpu;
mod hard_rays;
mod hierarchy;
mod images;
#[allow(dead_code, reason = "the program `kernels` compares their bounds")]
#[path = "../kernels/mod.rs"]
mod kernels;
mod lowered;
mod mutants;
mod pictures;
#[path = "../common/sampled.rs"]
mod sampled;
mod samples;
#[path = "../common/scenes.rs"]
mod scenes;
