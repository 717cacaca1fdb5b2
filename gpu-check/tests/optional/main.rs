//! Tests that need what not every machine has: Chromium, `strace`, or the course's pictures. Without it they are shown
//! as ignored, which the standard harness can decide only at compile time.

mod browser;
mod browser_lowered;
#[path = "../common/mod.rs"]
mod common;
mod course;
#[path = "../common/documented.rs"]
mod documented;
#[cfg(target_os = "linux")]
mod injected;
#[path = "../common/sampled.rs"]
mod sampled;

use std::path::Path;

use gpu_check::web::chromium;
use libtest_mimic::{Arguments, Failed, Trial};

fn main() {
    let mut trials = course::trials();
    trials.extend([
        in_browser("browser::tint_and_lavapipe_and_rust_agree", browser::tint),
        in_browser("browser::the_verdicts_in_the_browser_are_the_documented_ones", browser::conformance),
        in_browser("browser_lowered::integers_give_the_bits_of_rusts_f64_in_a_browser", browser_lowered::compare),
    ]);
    #[cfg(target_os = "linux")]
    trials.extend(injected::trials());
    libtest_mimic::run(&Arguments::from_args(), trials).exit();
}

/// Returns a test that gets the path of Chromium. Without Chromium it is ignored, or fails if `BROWSER_REQUIRED` is
/// set.
fn in_browser(name: &str, run: fn(&Path) -> Result<(), Failed>) -> Trial {
    let chromium = chromium::find();
    let is_required = std::env::var_os("BROWSER_REQUIRED").is_some();
    let missing = chromium.is_none() && !is_required;
    let trial = Trial::test(name, move || run(&chromium.ok_or("there is no Chromium")?));
    let kind = if missing { "needs Chromium, which tests/run --browser installs" } else { "" };
    trial.with_kind(kind).with_ignored_flag(missing)
}
