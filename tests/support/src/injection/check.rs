//! Prepares the files before a run, and checks them after it.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::process::Output;

use super::{Files, Job};

/// Returns all files in `folder` and in its subfolders, with their contents.
pub fn files(folder: &Path) -> io::Result<Files> {
    crate::files_below(folder).into_iter().map(|path| Ok((path.clone(), fs::read(&path)?))).collect()
}

impl Job {
    /// Empties the output folder. If there is an old content, writes it to the path of each output file in `new`.
    pub(super) fn prepare(&self, new: &Files) -> io::Result<()> {
        fs::remove_dir_all(&self.folder)?;
        fs::create_dir(&self.folder)?;
        for (path, old) in new.keys().zip(self.old.iter().cycle()) {
            fs::create_dir_all(path.parent().unwrap_or(Path::new(".")))?;
            fs::write(path, old)?;
        }
        Ok(())
    }

    /// Checks the files and the output after a run. `new` has the output files of a run that succeeds.
    pub(super) fn check(&self, new: &Files, output: &Output, ended_by_signal: bool) -> Result<(), String> {
        let found = files(&self.folder).map_err(|error| error.to_string())?;
        let content_of = |path: &PathBuf| found.get(path);
        let is_old = |path: &PathBuf| content_of(path) == self.old.as_ref();
        let is_new = |path: &PathBuf| content_of(path) == new.get(path);
        let whole = new.keys().all(|path| is_old(path) || is_new(path));
        let is_consistent = if output.status.success() {
            new.keys().all(is_new)
        } else if ended_by_signal {
            whole
        } else {
            whole && agrees_with_files(&String::from_utf8_lossy(&output.stderr), new.keys().filter(|path| is_new(path)))
        };
        let alone = found.keys().all(|path| new.contains_key(path));
        if is_consistent && alone {
            return Ok(());
        }
        let states: Vec<_> = new.keys().map(|path| (path, is_old(path), is_new(path))).collect();
        Err(format!("file, old, new: {states:?}; alone {alone}, {:?}; {output:?}", found.keys()))
    }
}

/// Whether a message reports an error and agrees with the files: `replaced` are the paths of the files that are new.
fn agrees_with_files<'a>(message: &str, mut replaced: impl Iterator<Item = &'a PathBuf>) -> bool {
    // If the file was replaced but its folder could not be synced, the message tells that.
    let is_uncertain = message.contains("the new file is there");
    // A program that writes several files names the one that it could not write, which may be standard output.
    let blames = |path: &PathBuf| message.contains(&format!("Cannot write file [{}]", path.display()));
    let blames_any = message.contains("Cannot write file [");
    message.contains("rror: ") && replaced.all(|path| is_uncertain || blames_any && !blames(path))
}
