//! Code that the tests of all crates share.
//!
//! [`agreement`] compares the renderer with the reference. [`golden`] lists the pictures whose digests come from other
//! programs, and [`format::digest`] computes digests. [`p3`] is a strict reader of pictures. [`running`] ends
//! processes, and `injection` makes system calls of a program fail. `cpp` builds the programs in C++, and
//! [`mutate`] changes inputs. The crate `generator` generates scenes.
//!
//! The tests of the built programs are in `cli/tests`, because Cargo builds the programs first there. The tests that
//! need only the library are in `tests`.

pub mod agreement;
#[cfg(feature = "programs")]
pub mod cpp;
#[cfg(feature = "programs")]
pub mod folder;
pub mod golden;
#[cfg(unix)]
pub mod injection;
pub mod mutate;
pub mod p3;
pub mod running;

use std::path::{Path, PathBuf};
use std::process::Command;

/// Returns the path of the workspace's root folder.
#[must_use]
pub fn project_root() -> PathBuf {
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    package.ancestors().nth(2).expect("the package is in tests/support").to_owned()
}

/// Returns the number in an environment variable, or `None` if the variable is not set.
///
/// # Panics
/// If its value is not a whole number.
#[must_use]
pub fn number_of(variable: &str) -> Option<u64> {
    let text = std::env::var(variable).ok()?;
    Some(text.parse().unwrap_or_else(|_| panic!("{variable}={text} is not a number")))
}

/// Whether tests that compare only a part by default compare everything: the variable `RENDER_ALL` is 1.
///
/// # Panics
/// If it has another value.
#[must_use]
pub fn everything() -> bool {
    match number_of("RENDER_ALL") {
        None => false,
        Some(number) => {
            assert_eq!(number, 1, "RENDER_ALL may only be 1");
            true
        }
    }
}

/// Returns the paths of all files below `folder`. The folders `target` and `.git` are left out, and `node_modules`,
/// whose files are those of other projects.
///
/// # Panics
/// If a folder cannot be read.
#[must_use]
pub fn files_below(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder).expect("the folder is readable") {
        let path = entry.expect("the folder is readable").path();
        let is_own = |name: &str| path.file_name().is_some_and(|own| own == name);
        if !path.is_dir() || path.is_symlink() {
            found.push(path);
        } else if !["target", ".git", "node_modules"].into_iter().any(is_own) {
            found.append(&mut files_below(&path));
        }
    }
    found
}

/// Runs cargo with the committed lock file in a folder of the project, and returns what it prints.
///
/// # Panics
/// If cargo fails.
#[must_use]
pub fn cargo(folder: &str, arguments: &[&str]) -> String {
    let mut command = Command::new(env!("CARGO"));
    let output = command.args(arguments).arg("--locked").current_dir(project_root().join(folder)).output();
    let output = output.expect("cargo runs");
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("cargo prints text")
}

/// Returns the bytes of `image` as a PPM file.
#[must_use]
pub fn ppm(image: &impl cpu::Image) -> Vec<u8> {
    let mut bytes = Vec::new();
    cpu::internals::image::ppm::write_ppm(image, &mut bytes).expect("memory takes all bytes");
    bytes
}

/// Returns a trial with this name. If the machine lacks something that the test needs, `missing` says what, and the
/// trial is shown as ignored.
#[cfg(feature = "programs")]
pub fn trial(
    name: impl Into<String>,
    missing: Option<&str>,
    test: impl FnOnce() -> Result<(), libtest_mimic::Failed> + Send + 'static,
) -> libtest_mimic::Trial {
    let trial = libtest_mimic::Trial::test(name, test);
    trial.with_kind(missing.unwrap_or_default()).with_ignored_flag(missing.is_some())
}

/// Runs trials as a test program. `RUST_TEST_THREADS` says how many run at once, as in other test programs.
#[cfg(feature = "programs")]
pub fn run_trials(trials: Vec<libtest_mimic::Trial>) -> ! {
    let mut arguments = libtest_mimic::Arguments::from_args();
    arguments.test_threads = arguments.test_threads.or(number_of("RUST_TEST_THREADS").map(|number| number as usize));
    libtest_mimic::run(&arguments, trials).exit()
}
