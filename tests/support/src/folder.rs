//! A temporary folder for the files that a program reads and writes.

use std::fs;
use std::path::{Path, PathBuf};

/// A temporary folder. When this value is dropped, the folder is removed with all its files.
#[derive(Debug)]
pub struct Folder(tempfile::TempDir);

impl Folder {
    /// Creates an empty folder.
    ///
    /// # Panics
    /// If the system's temporary folder is not writable.
    #[must_use]
    pub fn new() -> Self {
        Self(tempfile::tempdir().expect("the temporary folder is writable"))
    }

    /// Creates a folder with the files `config.txt` and `scene.txt`.
    ///
    /// # Panics
    /// If a file cannot be written.
    pub fn with_scene(config: impl AsRef<[u8]>, scene: impl AsRef<[u8]>) -> Self {
        let folder = Self::new();
        folder.write("config.txt", config);
        folder.write("scene.txt", scene);
        folder
    }

    /// Returns the path of the folder.
    #[must_use]
    pub fn path(&self) -> &Path {
        self.0.path()
    }

    /// Returns the path of a file in the folder. The file need not exist.
    #[must_use]
    pub fn file(&self, name: impl AsRef<Path>) -> PathBuf {
        self.path().join(name)
    }

    /// Returns the path of a file in the folder as text, for a command line.
    ///
    /// # Panics
    /// If the path is not valid UTF-8.
    #[must_use]
    pub fn name(&self, name: &str) -> String {
        self.file(name).to_str().expect("temporary names are text").to_owned()
    }

    /// Writes a file into the folder, and returns its path.
    ///
    /// # Panics
    /// If the file cannot be written.
    pub fn write(&self, name: &str, content: impl AsRef<[u8]>) -> PathBuf {
        let path = self.file(name);
        fs::write(&path, content).expect("the folder is writable");
        path
    }

    /// Returns the content of a file in the folder.
    ///
    /// # Panics
    /// If the file cannot be read.
    #[must_use]
    pub fn read(&self, name: &str) -> Vec<u8> {
        fs::read(self.file(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    /// Returns the names of all files and folders in the folder, sorted.
    ///
    /// # Panics
    /// If the folder cannot be read.
    #[must_use]
    pub fn names(&self) -> Vec<String> {
        self.names_in("")
    }

    /// Returns the names of all files and folders in a subfolder, sorted.
    ///
    /// # Panics
    /// If the subfolder cannot be read.
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
