//! What the tests of all crates share.
//!
//! [`agreement`] compares the renderer with the reference, [`generator`] makes scenes from a seed, [`write`](mod@write)
//! turns scenes and configurations back into text, [`golden`] knows the pictures whose digests have an origin outside
//! this project, [`digest`] computes digests, [`p3`] reads pictures without forgiving anything, and `injection` lets
//! system calls of a program fail.
//!
//! The tests of the built programs live in `cli/tests`, where Cargo builds the programs first; the ones that need the
//! library alone live in `tests`.

pub mod agreement;
pub mod digest;
pub mod generator;
pub mod golden;
#[cfg(unix)]
pub mod injection;
pub mod p3;
pub mod write;

use std::path::{Path, PathBuf};

/// The folder that holds the workspace.
#[must_use]
pub fn project_root() -> PathBuf {
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    package.ancestors().nth(2).expect("the package is in tests/support").to_owned()
}

/// `image` as a PPM file in memory.
#[must_use]
pub fn ppm(image: &impl cpu::Image) -> Vec<u8> {
    let mut bytes = Vec::new();
    cpu::internals::image::ppm::write_ppm(image, &mut bytes).expect("memory takes all bytes");
    bytes
}
