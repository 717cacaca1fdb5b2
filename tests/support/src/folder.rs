//! A temporary folder with the files of a program's call.

use std::fs;
use std::path::{Path, PathBuf};

/// A temporary folder, removed with all that is in it when this is dropped.
#[derive(Debug)]
pub struct Folder(tempfile::TempDir);

impl Folder {
    /// An empty folder.
    ///
    /// # Panics
    /// There is no room for temporary files.
    #[must_use]
    pub fn new() -> Self {
        Self(tempfile::tempdir().expect("the temporary folder is writable"))
    }

    /// A folder with `config.txt` and `scene.txt`.
    ///
    /// # Panics
    /// There is no room for temporary files.
    pub fn with_scene(config: impl AsRef<[u8]>, scene: impl AsRef<[u8]>) -> Self {
        let folder = Self::new();
        folder.write("config.txt", config);
        folder.write("scene.txt", scene);
        folder
    }

    /// The folder's own path.
    #[must_use]
    pub fn path(&self) -> &Path {
        self.0.path()
    }

    /// The path of a file in the folder, which need not be there.
    #[must_use]
    pub fn file(&self, name: impl AsRef<Path>) -> PathBuf {
        self.path().join(name)
    }

    /// The path of a file in the folder as text, for a command line.
    ///
    /// # Panics
    /// The system's temporary folder has a name that is no text.
    #[must_use]
    pub fn name(&self, name: &str) -> String {
        self.file(name).to_str().expect("temporary names are text").to_owned()
    }

    /// Writes a file into the folder and returns its path.
    ///
    /// # Panics
    /// The file cannot be written.
    pub fn write(&self, name: &str, content: impl AsRef<[u8]>) -> PathBuf {
        let path = self.file(name);
        fs::write(&path, content).expect("the folder is writable");
        path
    }

    /// The content of a file in the folder.
    ///
    /// # Panics
    /// The file cannot be read.
    #[must_use]
    pub fn read(&self, name: &str) -> Vec<u8> {
        fs::read(self.file(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    /// The names of all that is in the folder, sorted.
    ///
    /// # Panics
    /// The folder cannot be read.
    #[must_use]
    pub fn names(&self) -> Vec<String> {
        self.names_in("")
    }

    /// The names of all that is in a folder in this one, sorted.
    ///
    /// # Panics
    /// That folder cannot be read.
    #[must_use]
    pub fn names_in(&self, folder: &str) -> Vec<String> {
        let entries = fs::read_dir(self.file(folder)).expect("the folder is readable");
        let name = |entry: std::io::Result<fs::DirEntry>| entry.expect("the folder is readable").file_name();
        let mut names: Vec<_> = entries.map(|entry| name(entry).to_string_lossy().into_owned()).collect();
        names.sort();
        names
    }
}

impl Default for Folder {
    fn default() -> Self {
        Self::new()
    }
}

impl AsRef<Path> for Folder {
    fn as_ref(&self) -> &Path {
        self.path()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_folder_has_what_was_written_and_goes_with_it() {
        let folder = Folder::with_scene("c", "s");
        folder.write("a", "text");
        fs::create_dir(folder.file("d")).expect("the folder is writable");
        folder.write("d/b", "");
        assert_eq!(folder.names(), ["a", "config.txt", "d", "scene.txt"]);
        assert_eq!((folder.names_in("d"), folder.read("a")), (vec!["b".to_owned()], b"text".to_vec()));
        let path = folder.path().to_owned();
        assert_eq!(folder.name("a"), path.join("a").display().to_string());
        drop(folder);
        assert!(!path.exists());
    }
}
