//! The files of the page, which `web/build` makes. They are read once, so a request can name only these files.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::sync::Arc;

use cpu::internals::input::reader;
use loopback::Answer;

use crate::{Failure, terminal};

/// Largest size of a file of the page, in bytes.
const MAX_FILE: u64 = 32 << 20;

/// Largest number of files of the page.
const MAX_FILES: usize = 1000;

/// The place in `index.html` for the name of the server, and what is written there.
const SERVED_BY: [&str; 2] = ["name=\"served-by\" content=\"\"", "name=\"served-by\" content=\"render-lab view\""];

/// The content types, by the ending of a file's name.
const KINDS: [(&str, &str); 7] = [
    ("css", "text/css"),
    ("html", "text/html"),
    ("js", "text/javascript"),
    ("json", "application/json"),
    ("svg", "image/svg+xml"),
    ("txt", "text/plain"),
    ("wasm", "application/wasm"),
];

/// The files of the page by their paths, which begin with a slash.
#[derive(Clone, Debug, Default)]
pub struct Site(BTreeMap<String, Arc<Vec<u8>>>);

impl Site {
    /// Reads the page in `folder`.
    ///
    /// # Errors
    /// A message with the remedy, if the folder does not have the page.
    pub fn read(folder: &Path) -> Result<Self, Failure> {
        let name = terminal::name(folder);
        let remedy = "build it with web/build, or name its folder with --site";
        if !folder.join("index.html").is_file() {
            return Err(format!("[{name}] does not have the page; {remedy}").into());
        }
        let mut site = Self::default();
        site.add(folder, "/").map_err(|error| format!("cannot read the page in [{name}]: {error}"))?;
        let index = site.0.get_mut("/index.html").ok_or(format!("[{name}] has no index.html; {remedy}"))?;
        let text = String::from_utf8_lossy(index);
        if !text.contains(SERVED_BY[0]) {
            return Err(format!("the page in [{name}] is of another version; {remedy}").into());
        }
        *index = Arc::new(text.replace(SERVED_BY[0], SERVED_BY[1]).into_bytes());
        Ok(site)
    }

    /// Adds the files of `folder`, whose paths begin with `prefix`.
    fn add(&mut self, folder: &Path, prefix: &str) -> std::io::Result<()> {
        for entry in fs::read_dir(folder)? {
            let entry = entry?;
            let path = format!("{prefix}{}", entry.file_name().to_string_lossy());
            let kind = entry.file_type()?;
            if kind.is_dir() {
                self.add(&entry.path(), &format!("{path}/"))?;
            } else if kind.is_file() {
                if self.0.len() == MAX_FILES {
                    return Err(std::io::Error::other(format!("it has more than {MAX_FILES} files")));
                }
                self.0.insert(path, Arc::new(reader::read(&entry.path(), MAX_FILE)?));
            }
        }
        Ok(())
    }

    /// Returns the answer to a request for the file at `path`.
    pub fn file(&self, path: &str) -> Answer {
        let path = if path == "/" { "/index.html" } else { path };
        let Some(bytes) = self.0.get(path) else { return Answer::not_found() };
        let ending = path.rsplit('.').next().unwrap_or_default();
        let kind =
            KINDS.iter().find(|(known, _)| *known == ending).map_or("application/octet-stream", |(_, kind)| kind);
        Answer::shared(kind, Arc::clone(bytes))
    }
}
