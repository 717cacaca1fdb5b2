//! Reads the crates of the workspace: their sources, and their dependencies on each other.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::process::Command;

use serde_json::Value;

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
    let arguments = ["metadata", "--locked", "--no-deps", "--format-version", "1"];
    let output = Command::new(env!("CARGO")).args(arguments).current_dir(root).output().expect("cargo runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let metadata: Value = serde_json::from_slice(&output.stdout).expect("cargo writes JSON");
    let text = |value: &Value| value.as_str().expect("it is a text").to_owned();
    let relative = |path: &str| Path::new(path).strip_prefix(root).expect("it is in the workspace").to_owned();
    let list = |value: &Value| value.as_array().expect("it is a list").clone();
    let dependencies = |package: &Value| {
        let built = list(&package["dependencies"]).into_iter().filter(|dependency| dependency["kind"] != "dev");
        built.filter_map(|dependency| dependency["path"].as_str().map(relative)).collect()
    };
    let package = |package: &Value| {
        let manifest = relative(&text(&package["manifest_path"]));
        let folder = manifest.parent().expect("it is a file").to_owned();
        (text(&package["name"]), Crate { folder, needs: dependencies(package) })
    };
    list(&metadata["packages"]).iter().map(package).collect()
}

/// Returns the sources of each program and library whose root is in `folder`, the folder `src` of a package. A package
/// of tests alone has no such folder.
pub fn sources(folder: &Path) -> Vec<Sources> {
    if !folder.is_dir() {
        return Vec::new();
    }
    let mut roots = Vec::new();
    let mut own = Sources::new();
    read(folder, &Vec::new(), &mut own);
    // The files below `bin` are programs of their own.
    own.retain(|module, _| module.first().is_none_or(|first| first != "bin"));
    roots.push(own);
    let programs = std::fs::read_dir(folder.join("bin")).into_iter().flatten();
    for program in programs.map(|entry| entry.expect("the folder can be read").path()).filter(|path| path.is_dir()) {
        let mut own = Sources::new();
        read(&program, &Vec::new(), &mut own);
        roots.push(own);
    }
    roots
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
