//! Tests what the whole workspace promises: every program and script explains its use, every dependency is allowed, and
//! every public function of `cpu` and `cli` is named by a test.
//!
//! Cargo lists the programs and packages, and the scripts are found in the folders. So a new one is tested from its
//! start.

#[path = "workspace/programs.rs"]
mod programs;
#[path = "workspace/public_functions.rs"]
mod public_functions;
#[cfg(unix)]
#[path = "workspace/scripts.rs"]
mod scripts;
#[path = "workspace/supply_chain.rs"]
mod supply_chain;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::time::SystemTime;

/// Returns the files in `folder` with the time of the last change of each.
fn files(folder: &Path) -> BTreeMap<PathBuf, SystemTime> {
    let changed = |path: PathBuf| {
        let changed = path.symlink_metadata().and_then(|metadata| metadata.modified()).ok()?;
        Some((path, changed))
    };
    test_support::files_below(folder).into_iter().filter_map(changed).collect()
}
