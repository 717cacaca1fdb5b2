//! Reads files. Each file is opened once, read once, and read only up to a limit of bytes.
//!
//! There are two reasons. A device such as `/dev/zero` never ends. A pipe gives its content only once. So a program
//! that needs an input twice keeps the bytes of that input.

use std::fs::File;
use std::io::{self, BufReader, Read, Take};
use std::path::Path;

use crate::input::{error::Error, text::MAX_FILE_BYTES, text::too_large};

/// An open file of which at most a limited number of bytes may be read. If the file is longer, reading beyond the limit
/// is an error, and not the end of the file.
#[derive(Debug)]
pub struct LimitedFile {
    file: Take<File>,
    limit: u64,
}

impl LimitedFile {
    /// Opens the file at `path`. At most `limit` bytes of it may be read.
    ///
    /// # Errors
    /// The error of the operating system, if it does not open the file.
    pub fn open(path: &Path, limit: u64) -> io::Result<Self> {
        Ok(Self { file: File::open(path)?.take(limit), limit })
    }
}

impl Read for LimitedFile {
    /// Reads bytes of the file. If the file has a byte beyond the limit, the read that reaches it fails with
    /// [`io::ErrorKind::FileTooLarge`].
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        // At the limit, only the end of the file may follow.
        if self.file.limit() == 0 && self.file.get_mut().read(&mut [0; 1])? > 0 {
            return Err(too_large(self.limit));
        }
        self.file.read(buffer)
    }
}

/// Opens the file at `path` and calls `parse` to read it.
///
/// # Errors
/// [`Error::Read`] if the file cannot be opened. Otherwise the error of `parse`, with the file's name.
pub(super) fn parse<T>(
    path: &Path,
    parse: impl FnOnce(BufReader<LimitedFile>) -> Result<T, Error>,
) -> Result<T, Error> {
    let input = LimitedFile::open(path, MAX_FILE_BYTES).map_err(Error::from);
    input.and_then(|input| parse(BufReader::with_capacity(1 << 16, input))).map_err(|error| error.in_file(path))
}

/// Returns the bytes of the file at `path`.
///
/// # Errors
/// If the file cannot be opened or read, if it has more than `limit` bytes, or if memory is short.
#[cfg(feature = "internals")]
pub fn read(path: &Path, limit: u64) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    // If memory is short, `read_to_end` returns an error.
    LimitedFile::open(path, limit)?.read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// Returns the text of the file at `path`.
///
/// # Errors
/// Those of [`read`]. [`io::ErrorKind::InvalidData`] if the bytes are not UTF-8.
#[cfg(feature = "internals")]
pub fn read_text(path: &Path, limit: u64) -> io::Result<String> {
    text_of(read(path, limit)?)
}

/// Returns the text in the bytes of a file.
///
/// # Errors
/// [`io::ErrorKind::InvalidData`] if the bytes are not UTF-8.
#[cfg(feature = "internals")]
pub fn text_of(bytes: Vec<u8>) -> io::Result<String> {
    // In UTF-16, one of the two bytes of an ASCII letter is zero.
    let is_utf_16 = matches!(bytes[..], [0xff, 0xfe, ..] | [0xfe, 0xff, ..] | [0, _, ..] | [_, 0, ..]);
    let refused = |place| {
        let cause = if is_utf_16 { "it is UTF-16, so " } else { "" };
        let text = format!("it is not UTF-8 text: see the byte at offset {place}; {cause}save it as UTF-8");
        io::Error::new(io::ErrorKind::InvalidData, text)
    };
    let zero = bytes.iter().position(|&byte| byte == 0).filter(|_| is_utf_16);
    let text = String::from_utf8(bytes).map_err(|error| refused(error.utf8_error().valid_up_to()))?;
    zero.map_or(Ok(text), |place| Err(refused(place)))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A file with this text, which is removed when the value is dropped.
    struct Temporary(std::path::PathBuf);

    impl Temporary {
        fn new(name: &str, text: &[u8]) -> Self {
            let path = std::env::temp_dir().join(format!("cpu-input-{}-{name}", std::process::id()));
            std::fs::write(&path, text).expect("the temporary folder is writable");
            Self(path)
        }
    }

    impl Drop for Temporary {
        fn drop(&mut self) {
            let _ = std::fs::remove_file(&self.0);
        }
    }

    #[test]
    fn a_file_of_exactly_the_limit_is_read_and_one_byte_more_refused() {
        let file = Temporary::new("limit", b"12345");
        assert_eq!(read(&file.0, 6).expect("it is smaller"), b"12345");
        assert_eq!(read(&file.0, 5).expect("it is as large"), b"12345");
        let error = read(&file.0, 4).expect_err("it is larger");
        assert_eq!(
            (error.kind(), error.to_string()),
            (io::ErrorKind::FileTooLarge, "it is larger than 4 bytes".into())
        );
        assert_eq!(read(&Temporary::new("empty", b"").0, 0).expect("nothing is no more than nothing"), b"");
        let error = LimitedFile::open(Path::new("no/file"), 1).expect_err("there is none");
        assert_eq!(error.kind(), io::ErrorKind::NotFound);
    }

    #[test]
    fn a_text_that_is_not_utf_8_is_refused_with_the_place() {
        assert_eq!(read_text(&Temporary::new("text", "ä".as_bytes()).0, 9).expect("it is a text"), "ä");
        let error = read_text(&Temporary::new("bytes", b"abc\xff").0, 9).expect_err("it is none").to_string();
        assert_eq!(error, "it is not UTF-8 text: see the byte at offset 3; save it as UTF-8");
        for (bytes, place) in [(b"\xff\xfea\0", 0), (b"a\0b\0", 1), (b"\0a\0b", 0)] {
            let error = text_of(bytes.to_vec()).expect_err("it is none").to_string();
            assert!(error.ends_with(&format!("offset {place}; it is UTF-16, so save it as UTF-8")), "{error}");
        }
    }

    #[cfg(unix)]
    #[test]
    fn an_endless_device_is_read_up_to_the_limit() {
        assert!(read(Path::new("/dev/zero"), 1 << 16).is_err());
        assert!(read(&std::env::temp_dir(), 9).is_err(), "a folder is no file");
    }
}
