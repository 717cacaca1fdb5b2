//! Tests that need what not every machine has: `strace`, the course's pictures, zsh, fish, or Chromium with the built
//! page. Without it they are shown as ignored, which the standard harness can decide only at compile time.

#[cfg(target_os = "linux")]
mod injected;
mod published;
mod shells;
mod site;

use libtest_mimic::{Arguments, Trial};

/// Returns the trial, which is ignored if `obstacle` says what is missing.
fn unless(obstacle: Option<String>, trial: Trial) -> Trial {
    match obstacle {
        Some(reason) => trial.with_kind(reason).with_ignored_flag(true),
        None => trial,
    }
}

fn main() {
    let mut trials = published::trials();
    trials.extend(shells::trials());
    trials.extend(site::trials());
    #[cfg(target_os = "linux")]
    trials.extend(injected::trials());
    libtest_mimic::run(&Arguments::from_args(), trials).exit();
}
