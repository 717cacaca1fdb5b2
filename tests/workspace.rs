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

/// Returns the files in `folder` with the time of the last change of each. The folders `target` and `.git` are left
/// out, and `node_modules`, whose scripts are those of other projects.
fn files(folder: &Path) -> BTreeMap<PathBuf, SystemTime> {
    let mut found = BTreeMap::new();
    for entry in std::fs::read_dir(folder).expect("the folder is readable") {
        let path = entry.expect("the folder is readable").path();
        let is_own = |name: &str| path.file_name().is_some_and(|own| own == name);
        if path.is_dir() && !path.is_symlink() {
            if !["target", ".git", "node_modules"].into_iter().any(is_own) {
                found.append(&mut files(&path));
            }
        } else if let Ok(changed) = path.symlink_metadata().and_then(|metadata| metadata.modified()) {
            found.insert(path, changed);
        }
    }
    found
}
