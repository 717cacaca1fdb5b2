//! Reads the crates of the workspace: their sources, and their dependencies on each other.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use serde_json::Value;
use test_support::cargo;

use crate::uses::{Sources, read};

/// A crate of the workspace.
#[derive(Debug)]
pub struct Crate {
    /// The crate's folder, relative to the root of the project, such as `cli/output`.
    pub folder: PathBuf,
    /// The folders of the crates of the workspace that it is built from. Those of its tests are left out.
    pub needs: BTreeSet<PathBuf>,
}

/// Returns the crates of the workspace at `root`, by their names.
pub fn crates(root: &Path) -> BTreeMap<String, Crate> {
    let metadata: Value =
        serde_json::from_str(&cargo("", &["metadata", "--no-deps", "--format-version", "1"])).expect("JSON");
    let relative = |path: &Value| {
        let path = Path::new(path.as_str().expect("it is a text"));
        path.strip_prefix(root).expect("it is in the workspace").to_owned()
    };
    let list = |value: &Value| value.as_array().expect("it is a list").clone();
    let package = |package: &Value| {
        let folder = relative(&package["manifest_path"]).parent().expect("it is a file").to_owned();
        let built = list(&package["dependencies"]).into_iter().filter(|dependency| dependency["kind"] != "dev");
        let needs = built.filter(|dependency| dependency["path"].is_string()).map(|it| relative(&it["path"])).collect();
        (package["name"].as_str().expect("it is a text").to_owned(), Crate { folder, needs })
    };
    list(&metadata["packages"]).iter().map(package).collect()
}

/// Returns the sources of each program and library whose root is in `folder`, the folder `src` of a package. A package
/// of tests alone has no such folder.
pub fn sources(folder: &Path) -> Vec<Sources> {
    let programs = std::fs::read_dir(folder.join("bin")).into_iter().flatten();
    let programs = programs.map(|entry| entry.expect("the folder can be read").path()).filter(|path| path.is_dir());
    let library = folder.is_dir().then(|| folder.to_owned());
    let read_one = |folder: PathBuf| {
        let mut sources = read(&folder);
        // The files below `bin` are programs of their own.
        sources.retain(|module, _| module.first().is_none_or(|first| first != "bin"));
        sources
    };
    library.into_iter().chain(programs).map(read_one).collect()
}

/// Returns a text for each crate that needs a crate in a later folder of `order`, or whose own folder is not in it.
pub fn faults(crates: &BTreeMap<String, Crate>, order: &[&str]) -> Vec<String> {
    let place = |folder: &Path| {
        let top = folder.iter().next().and_then(|top| top.to_str());
        order.iter().position(|&folder| Some(folder) == top)
    };
    let mut faults = Vec::new();
    for (name, Crate { folder, needs }) in crates {
        for need in needs.iter().filter(|need| place(folder).is_none() || place(need) > place(folder)) {
            faults.push(format!("{name} in {} needs {}", folder.display(), need.display()));
        }
    }
    faults
}
