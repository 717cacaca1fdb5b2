//! Writes a text of the page into its file, when the user has asked for it in the page.

use std::io::{self, Write as _};
use std::os::unix::fs::PermissionsExt as _;
use std::path::Path;

use loopback::Answer;

use super::input::{Input, MAX_TEXT, MISSING, content, version_of, without_links};
use super::replace::replace;
use super::{View, invalid};
use crate::Failure;

impl View {
    /// Writes a text into the file of `input`, and answers with the file's new version. `body` is the version that the
    /// page has read, a line end, and the text. Refuses if the file has changed since the page read it.
    pub(super) fn save(&self, input: &Input, body: &[u8]) -> Answer {
        self.try_to_save(input, body).map_or_else(|refusal| refusal, |version| Answer::ok("text/plain", version))
    }

    fn try_to_save(&self, input: &Input, body: &[u8]) -> Result<String, Answer> {
        let mut parts = body.splitn(2, |byte| *byte == b'\n');
        let (Some(version), Some(new)) = (parts.next(), parts.next()) else {
            return Err(invalid("a text is saved with the version of its file before it"));
        };
        if new.len() as u64 > MAX_TEXT {
            let text = format!("the text has {} bytes, and the page saves at most {MAX_TEXT}", new.len());
            return Err(Answer::refused("413 Content Too Large", text));
        }
        std::str::from_utf8(new).map_err(|error| invalid(error.to_string()))?;
        // Of two requests with one version the second one must see the change by the first one.
        let _turn = self.saving.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        let failed = |error: output::Error| {
            Answer::refused("500 Internal Server Error", Failure::from(error).message().unwrap_or_default())
        };
        let is_saved = if version == MISSING.as_bytes() {
            create(input.path(), new, self.how.sync)
                .map_err(|cause| output::Error { path: input.path().to_owned(), cause })
        } else {
            match input.read() {
                Ok(old) if version_of(&old).as_bytes() == version => {
                    replace(input.path(), (&old, new), read_again, self.how)
                }
                Err(error) if error.kind() != io::ErrorKind::NotFound => return Err(invalid(input.message(&error))),
                _ => Ok(false),
            }
        };
        if !is_saved.map_err(failed)? {
            return Err(Answer::refused("409 Conflict", "the file has changed since the page read it"));
        }
        // The version of the new file, not of what another program may have written since.
        Ok(version_of(new))
    }
}

/// Returns the present content of the file at `path`.
fn read_again(path: &Path) -> io::Result<Vec<u8>> {
    let file = without_links(path)?;
    let length = file.metadata()?.len();
    // One byte more than the page can edit is enough to see that the file is another one.
    content(file, length.min(MAX_TEXT + 1))
}

/// Writes a new file at `path`, which appears when it is complete. Returns false if there is a file, or a link.
fn create(path: &Path, text: &[u8], sync: bool) -> io::Result<bool> {
    let folder = path.parent().unwrap_or(Path::new("."));
    // The system takes away the permissions that the user does not give to new files (umask).
    let rights = std::fs::Permissions::from_mode(0o666);
    let mut file = tempfile::Builder::new().prefix(".render-").permissions(rights).tempfile_in(folder)?;
    file.write_all(text)?;
    if sync {
        file.as_file().sync_all()?;
    }
    match file.persist_noclobber(path) {
        Ok(_) if sync => std::fs::File::open(folder)?.sync_all().map(|()| true),
        Ok(_) => Ok(true),
        Err(error) if error.error.kind() == io::ErrorKind::AlreadyExists => Ok(false),
        Err(error) => Err(error.error),
    }
}
