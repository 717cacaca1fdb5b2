//! The evaluated programs on other systems give the same digests. Each platform is built with Debian's compiler for
//! WebAssembly and ARM, and run by Node.js, by Chromium or by an emulator.
//!
//! A platform whose tools are missing is shown as ignored, with the packages that it needs. `tests/run --platforms`
//! installs the packages, and takes the pictures that need minutes too.

#[path = "platforms/build.rs"]
mod build;
#[path = "platforms/host.rs"]
mod host;
#[path = "platforms/random_scenes.rs"]
mod random_scenes;
#[path = "platforms/table.rs"]
mod table;
#[path = "platforms/unit_tests.rs"]
mod unit_tests;

use std::sync::Arc;

use cpu::Scatter;
use libtest_mimic::{Arguments, Failed, Trial};
use test_support::golden::{self, Golden};

use host::{Host, Job};
use table::{Platform, VARIABLE, platforms};

/// Whether `RENDER_PLATFORMS=all` asks for what takes many minutes in an emulator.
fn all_are_asked_for() -> bool {
    std::env::var_os(VARIABLE).is_some_and(|value| value == "all")
}

/// Returns the pictures that are tried: the small cases, the course's first two, and with `RENDER_PLATFORMS=all` all
/// four. The programs have the statement's convention alone.
fn pictures() -> Vec<Golden> {
    let mut pictures = golden::cases();
    let folder = golden::reference_folder();
    if folder.is_dir() {
        let all = golden::reference(&folder);
        let count = if all_are_asked_for() { 4 } else { 2 };
        pictures.extend(all.into_iter().take(2 * count));
    }
    pictures.retain(|golden| golden.scatter == Scatter::Statement);
    assert!(pictures.len() >= 16, "no picture is left out");
    pictures
}

fn has_its_digest(platform: &Platform, golden: &Golden, layout: &str, set: &str) -> Result<(), Failed> {
    let expected = golden.digest()?;
    let job = Job { config: &golden.config, scene: &golden.scene, layout, set };
    let actual = digest::sha256(&platform.host.render(&platform.build.release()?, job)?);
    if actual == expected { Ok(()) } else { Err(format!("{actual} instead of {expected}").into()) }
}

/// Returns the trials of a platform, and for each of them whether it is slow.
fn trials(platform: &Arc<Platform>) -> Vec<(Trial, bool)> {
    let mut trials = Vec::new();
    for golden in pictures() {
        for (number, &set) in platform.sets.iter().enumerate() {
            // Both layouts are tried, one for each instruction set.
            let layout = if number % 2 == 0 { "aos" } else { "soa" };
            let name = format!("{} {} by render-{layout} with {set}", platform.name, golden.name);
            let (shared, golden) = (Arc::clone(platform), golden.clone());
            let trial = Trial::test(name, move || has_its_digest(&shared, &golden, layout, set));
            trials.push((trial, platform.is_slow));
        }
    }
    // Chromium has the modules of Node.js, and needs a second to start.
    if !matches!(platform.host, Host::Chromium) {
        let shared = Arc::clone(platform);
        let trial = Trial::test(format!("{} random scenes", platform.name), move || random_scenes::are_equal(&shared));
        trials.push((trial, true));
    }
    // Only the packages of ARM have a library for tests.
    if platform.name == "aarch64" && all_are_asked_for() {
        let shared = Arc::clone(platform);
        trials.push((Trial::test("aarch64 unit tests of cpu", move || unit_tests::pass(&shared)), true));
    }
    trials
}

fn main() {
    let mut all = Vec::new();
    for platform in platforms().into_iter().map(Arc::new) {
        for (trial, is_slow) in trials(&platform) {
            let is_left_out = is_slow && std::env::var_os(VARIABLE).is_none();
            let reason = platform.missing().or_else(|| is_left_out.then(|| format!("needs {VARIABLE}=1")));
            all.push(match reason {
                Some(reason) => trial.with_kind(reason).with_ignored_flag(true),
                None => trial,
            });
        }
    }
    libtest_mimic::run(&Arguments::from_args(), all).exit();
}
