//! The evaluated programs on other systems give the same digests. Each platform is built with Debian's compiler for
//! WebAssembly and ARM, and run by Node.js or by an emulator.
//!
//! `tests/run --platforms` installs the packages that are needed, and takes the pictures that need minutes too.

#[path = "build.rs"]
mod build;
#[path = "host.rs"]
mod host;
#[path = "random_scenes.rs"]
mod random_scenes;
#[path = "table.rs"]
mod table;

use std::sync::Arc;

use cpu::Scatter;
use libtest_mimic::{Failed, Trial};
use test_support::everything;
use test_support::golden::{self, Golden};

use host::{Host, Job};
use table::{Platform, VARIABLE, platforms};

/// Returns the pictures that are tried: the small cases, the course's first two, and with `RENDER_ALL=1` all
/// four. The programs have the statement's convention alone.
fn pictures() -> Vec<Golden> {
    let mut pictures = golden::cases();
    let folder = golden::reference_folder();
    if folder.is_dir() {
        let all = golden::reference(&folder);
        let count = if everything() { 4 } else { 2 };
        pictures.extend(all.into_iter().take(2 * count));
    }
    pictures.retain(|golden| golden.scatter == Scatter::Statement);
    assert!(pictures.len() >= 16, "no picture is left out");
    pictures
}

fn has_its_digest(platform: &Platform, golden: &Golden, layout: &str, set: &str) -> Result<(), Failed> {
    let expected = golden.digest()?;
    let job = Job { config: &golden.config, scene: &golden.scene, layout, set };
    let actual = format::digest::sha256(&platform.host.render(&platform.build.release()?, job)?);
    if actual == expected { Ok(()) } else { Err(format!("{actual} instead of {expected}").into()) }
}

/// Returns the trials of a platform, and for each of them whether it is slow.
fn trials_of(platform: &Arc<Platform>) -> Vec<(Trial, bool)> {
    let mut trials = Vec::new();
    for golden in pictures() {
        for (number, &set) in platform.sets.iter().enumerate() {
            // Both layouts are tried, one for each instruction set.
            let layout = if number % 2 == 0 { "aos" } else { "soa" };
            let name = format!("platforms: {} {} by render-{layout} with {set}", platform.name, golden.name);
            let (shared, golden) = (Arc::clone(platform), golden.clone());
            let trial = Trial::test(name, move || has_its_digest(&shared, &golden, layout, set));
            trials.push((trial, platform.is_slow));
        }
    }
    let shared = Arc::clone(platform);
    let trial =
        Trial::test(format!("platforms: {} random scenes", platform.name), move || random_scenes::are_equal(&shared));
    trials.push((trial, true));
    // Only the packages of ARM have a library for tests.
    if platform.name == "aarch64" && everything() {
        let shared = Arc::clone(platform);
        trials.push((Trial::test("platforms: aarch64 unit tests of cpu", move || unit_tests_pass(&shared)), true));
    }
    trials
}

/// Returns the trials of all platforms.
pub fn trials() -> Vec<Trial> {
    let mut all = Vec::new();
    for platform in platforms().into_iter().map(Arc::new) {
        let missing = platform.missing();
        for (trial, is_slow) in trials_of(&platform) {
            let is_left_out = is_slow && std::env::var_os(VARIABLE).is_none();
            let reason = missing.clone().or_else(|| is_left_out.then(|| format!("needs {VARIABLE}=1")));
            let is_ignored = reason.is_some();
            all.push(trial.with_kind(reason.unwrap_or_default()).with_ignored_flag(is_ignored));
        }
    }
    all
}

/// Builds the unit tests of `cpu` for a platform, and runs them in its emulator.
fn unit_tests_pass(platform: &Platform) -> Result<(), Failed> {
    let Host::Emulator { qemu, libraries } = &platform.host else { return Err("there is no emulator".into()) };
    let path = format!("LD_LIBRARY_PATH={libraries}/lib");
    let runner = format!("target.{}.runner={:?}", platform.build.target, [qemu.0, "-L", libraries, "-E", &path]);
    let printed = platform.build.cargo(&["test", "-p", "cpu", "--lib", "--tests", "--config", &runner])?;
    let results = printed.lines().filter_map(|line| line.strip_prefix("test result: ok. ")?.split_once(" passed"));
    let passed: u64 = results.filter_map(|(count, _)| count.parse::<u64>().ok()).sum();
    // The package has some more.
    if passed >= 200 { Ok(()) } else { Err(format!("only {passed} tests passed:\n{printed}").into()) }
}
