//! Tests that need what not every machine has: `strace`, g++, the course's pictures, or Chromium with the built page.
//! Without it they are shown as ignored, which the standard harness can decide only at compile time.

mod compare;
mod grade;
#[cfg(target_os = "linux")]
mod injected;
mod published;
mod site;

fn main() {
    let mut trials = published::trials();
    trials.extend(site::trials());
    trials.extend(compare::trials());
    trials.extend(grade::trials());
    #[cfg(target_os = "linux")]
    trials.extend(injected::trials());
    test_support::run_trials(trials)
}
