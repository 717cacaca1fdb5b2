//! Tests that need what not every machine has: `strace`, or the course's pictures. Without it they are shown as
//! ignored, which the standard harness can decide only at compile time.

#[path = "../common/mod.rs"]
mod common;
mod course;
#[cfg(target_os = "linux")]
mod injected;
#[path = "../common/sampled.rs"]
mod sampled;

fn main() {
    let trials = course::trials();
    #[cfg(target_os = "linux")]
    let trials = trials.into_iter().chain(injected::trials()).collect();
    test_support::run_trials(trials)
}
