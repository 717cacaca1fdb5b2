//! Lists and reads the files of the project.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// Names of folders that are skipped: build output, git's data, output of this project's commands, and packages of npm.
const SKIPPED: [&str; 4] = ["target", ".git", "out", "node_modules"];

/// The files and folders of the project. A path is relative to the project's root and has slashes.
#[derive(Debug)]
pub struct Project {
    root: PathBuf,
    paths: BTreeSet<String>,
    /// The names of the folders at the root.
    pub folders: BTreeSet<String>,
}

impl Project {
    /// Lists all files and folders of the project.
    pub fn read() -> Self {
        let root = test_support::project_root();
        let mut paths = BTreeSet::new();
        list(&root, "", &mut paths);
        let folders = paths.iter().filter(|path| !path.contains('/') && root.join(path).is_dir()).cloned().collect();
        Self { root, paths, folders }
    }

    /// Whether the project has a file or a folder with this path.
    pub fn has(&self, path: &str) -> bool {
        path.is_empty() || self.paths.contains(path.trim_end_matches('/'))
    }

    /// Whether the project has a file or a folder whose path is `path`, or ends with `/` and `path`.
    pub fn has_ending_with(&self, path: &str) -> bool {
        let path = path.trim_end_matches('/');
        self.paths.iter().any(|known| known.strip_suffix(path).is_some_and(|it| it.is_empty() || it.ends_with('/')))
    }

    /// Returns the paths of the files whose names have one of these endings.
    pub fn with_endings(&self, endings: &[&str]) -> impl Iterator<Item = &str> {
        self.paths.iter().map(String::as_str).filter(move |path| {
            let ending = path.rsplit('/').next().and_then(|name| name.rsplit_once('.')).map(|(_, ending)| ending);
            ending.is_some_and(|ending| endings.contains(&ending))
        })
    }

    /// Returns the text of the file at `path`.
    pub fn text(&self, path: &str) -> String {
        std::fs::read_to_string(self.root.join(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
    }
}

/// Adds the paths of all files and folders in `folder` to `paths`, each with `prefix` before it. Subfolders are
/// included.
fn list(folder: &Path, prefix: &str, paths: &mut BTreeSet<String>) {
    for entry in std::fs::read_dir(folder).expect("the folder is there") {
        let entry = entry.expect("the folder can be read");
        let name = entry.file_name().to_string_lossy().into_owned();
        if SKIPPED.contains(&name.as_str()) {
            continue;
        }
        let path = format!("{prefix}{name}");
        if entry.file_type().expect("the entry can be asked").is_dir() {
            list(&entry.path(), &format!("{path}/"), paths);
        }
        paths.insert(path);
    }
}

/// Returns the path to which `link` leads from the file `from`.
pub fn join(from: &str, link: &str) -> String {
    let mut parts: Vec<&str> = from.split('/').collect();
    parts.pop();
    for part in link.split('/') {
        match part {
            "." | "" => {}
            ".." if parts.last().is_some_and(|last| *last != "..") => {
                parts.pop();
            }
            _ => parts.push(part),
        }
    }
    parts.join("/")
}
