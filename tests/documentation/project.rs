//! Lists and reads the files of the project.

use std::collections::BTreeSet;
use std::path::PathBuf;

/// The files and folders of the project. A path is relative to the project's root and has slashes.
#[derive(Debug)]
pub struct Project {
    root: PathBuf,
    paths: BTreeSet<String>,
    /// The names of the folders at the root.
    pub folders: BTreeSet<String>,
}

impl Project {
    /// Lists all files and folders of the project, except for folders `out`, which have the output of its commands.
    pub fn read() -> Self {
        let root = test_support::project_root();
        let mut paths = BTreeSet::new();
        for file in test_support::files_below(&root) {
            let own = file.strip_prefix(&root).expect("it is below the root");
            if own.iter().all(|part| part != "out") {
                paths.extend(own.ancestors().map(|path| path.to_string_lossy().replace('\\', "/")));
            }
        }
        paths.remove("");
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
