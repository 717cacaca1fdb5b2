//! The errors of this crate, with the exact messages (specification, sections 3.4 and 4.3).

use std::fmt;
use std::io;
use std::path::{Path, PathBuf};

/// Why a configuration or a scene could not be read or was refused, or why a picture could not be rendered. A failure
/// to write a picture is an [`io::Error`] instead.
///
/// [`Error::message`] returns the message, without the leading `Error: ` that the programs print. Text that comes from
/// the input is kept as bytes, because the input need not be UTF-8 and the message shows it unchanged.
#[derive(Debug)]
#[non_exhaustive]
pub enum Error {
    /// A configuration key that does not exist, or that lacks its colon.
    UnknownKey {
        /// The first token of the line.
        key: Vec<u8>,
    },
    /// A configuration value that is missing, unreadable or out of range.
    InvalidValue {
        /// The key, with its colon.
        key: &'static str,
        /// The line, without its line end.
        line: Vec<u8>,
    },
    /// A configuration line with more tokens than its key takes.
    ExtraValue {
        /// The key, with its colon.
        key: &'static str,
        /// The rest of the line, trimmed.
        extra: Vec<u8>,
    },
    /// A scene line whose first token is no known entity.
    UnknownEntity {
        /// The first token of the line.
        name: Vec<u8>,
    },
    /// Scene parameters that are missing, unreadable or out of range.
    InvalidParameters {
        /// The entity that the line describes, in the words of the message: `matte material`, `sphere` and so on.
        entity: &'static str,
        /// The line, without its line end.
        line: Vec<u8>,
    },
    /// A scene line with more tokens than its entity takes.
    ExtraParameters {
        /// The first token of the line, with its colon.
        tag: &'static str,
        /// The rest of the line, trimmed.
        extra: Vec<u8>,
        /// The line, without its line end.
        line: Vec<u8>,
    },
    /// A material with a name that an earlier line has already defined.
    MaterialExists {
        /// The material's name.
        name: Vec<u8>,
        /// The line, without its line end.
        line: Vec<u8>,
    },
    /// An object with a material that no earlier line defines.
    MaterialNotFound {
        /// The material's name.
        name: Vec<u8>,
        /// The line, without its line end.
        line: Vec<u8>,
    },
    /// A file that cannot be read.
    Read {
        /// The path that the caller gave.
        path: PathBuf,
        /// The error of the operating system, or the limit that the file exceeds.
        cause: io::Error,
    },
    /// Text that cannot be read, when its file's name is not known. [`Error::in_file`] adds the name.
    Input(io::Error),
    /// A configuration that describes a picture that cannot be made.
    Picture(Picture),
    /// An [`Error::Picture`] with the name of the configuration file.
    PictureIn {
        /// The path of the configuration file.
        path: PathBuf,
        /// The reason why the picture cannot be made.
        cause: Picture,
    },
    /// Memory that is too short.
    OutOfMemory {
        /// What needed the memory, in the words of the message: `the image`, `the objects` and so on.
        what: &'static str,
    },
}

/// The largest number of pixels that a picture may have: 2^30. A pixel takes three bytes.
pub const MAX_PIXELS: u64 = 1 << 30;

/// The reason why a picture cannot be made, although every single value of the configuration is valid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Picture {
    /// The picture has more pixels than [`MAX_PIXELS`], or none.
    TooLarge {
        /// Width in pixels.
        width: u64,
        /// Height in pixels. `u64::MAX` also stands for any larger height.
        height: u64,
    },
    /// `camera_position` equals `camera_target`.
    CameraAtTarget,
    /// `camera_north` is null or parallel to the view.
    NorthParallel,
    /// The camera's values are so large or so small that the projection window is not finite.
    CameraOutOfRange,
}

impl fmt::Display for Picture {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(match self {
            Self::TooLarge { width, height } => {
                return write!(
                    out,
                    "the image is too large to hold: {width} x {height} pixels, at most {MAX_PIXELS} in all; \
                     choose a smaller image_width or another aspect_ratio"
                );
            }
            Self::CameraAtTarget => "camera_position is the same point as camera_target; move one of them",
            Self::NorthParallel => {
                "camera_north is null or parallel to the view from camera_position to camera_target; \
                 choose another north"
            }
            Self::CameraOutOfRange => {
                "the camera's position, target or field_of_view is out of range: its window is not finite"
            }
        })
    }
}

impl Error {
    /// Returns the error with the name of its file, `path`. Only [`Error::Input`] and [`Error::Picture`] lack such a
    /// name. All other errors are returned unchanged.
    #[must_use]
    pub fn in_file(self, path: &Path) -> Self {
        match self {
            Self::Input(cause) => Self::Read { path: path.to_owned(), cause },
            Self::Picture(cause) => Self::PictureIn { path: path.to_owned(), cause },
            other => other,
        }
    }

    /// Returns the message without the leading `Error: ` and without a line end. Parts that come from files have their
    /// bytes unchanged.
    #[must_use]
    pub fn message(&self) -> Vec<u8> {
        self.message_with(<[u8]>::to_vec)
    }

    /// Returns the message for a terminal. Parts that come from files, and file names, are
    /// [escaped](crate::input::text::escape).
    #[must_use]
    pub fn message_for_terminal(&self) -> Vec<u8> {
        self.message_with(|text| crate::input::text::escape(text).into_bytes())
    }

    /// Returns the message. `show` converts the parts that are put into its text, such as lines and file names.
    fn message_with(&self, show: fn(&[u8]) -> Vec<u8>) -> Vec<u8> {
        const LINE: &str = "\nLine: \"{}\"";
        const EXTRA: &str = "Extra data after configuration value for key: [{}]\nExtra: \"{}\"";
        let cause = match self {
            Self::Read { cause, .. } | Self::Input(cause) => cause.to_string(),
            Self::Picture(cause) | Self::PictureIn { cause, .. } => cause.to_string(),
            _ => String::new(),
        };
        let cause = cause.as_bytes();
        let (text, parts): (&[&str], &[&[u8]]) = match self {
            Self::UnknownKey { key } => (&["Unknown configuration key: [{}:]"], &[without_colon(key)]),
            Self::InvalidValue { key, line } => (&["Invalid value for key: [{}]", LINE], &[key.as_bytes(), line]),
            Self::ExtraValue { key, extra } => (&[EXTRA], &[key.as_bytes(), extra]),
            Self::UnknownEntity { name } => (&["Unknown scene entity: {}"], &[without_colon(name)]),
            Self::InvalidParameters { entity, line } => (&["Invalid {} parameters", LINE], &[entity.as_bytes(), line]),
            Self::ExtraParameters { tag, extra, line } => (&[EXTRA, LINE], &[tag.as_bytes(), extra, line]),
            Self::MaterialExists { name, line } => (&["Material with name [{}] already exists", LINE], &[name, line]),
            Self::MaterialNotFound { name, line } => (&["Material not found: [{}]", LINE], &[name, line]),
            Self::Read { path, .. } => (&["Cannot read file [{}]: {}"], &[bytes(path), cause]),
            Self::Input(_) => (&["Cannot read the input: {}"], &[cause]),
            Self::Picture(_) => (&["Invalid configuration: {}"], &[cause]),
            Self::PictureIn { path, .. } => (&["Invalid configuration [{}]: {}"], &[bytes(path), cause]),
            Self::OutOfMemory { what } => (&["Not enough memory for {}"], &[what.as_bytes()]),
        };
        let text = text.concat();
        let mut pieces = text.split("{}").map(str::as_bytes);
        let mut message = pieces.next().unwrap_or_default().to_vec();
        for (part, piece) in parts.iter().zip(pieces) {
            message.extend(show(part));
            message.extend(piece);
        }
        message
    }
}

/// Returns the path as bytes, since it need not be UTF-8.
fn bytes(path: &Path) -> &[u8] {
    path.as_os_str().as_encoded_bytes()
}

/// Returns a key or name without a colon at its end. The message adds a colon to a key, and none to a name.
fn without_colon(name: &[u8]) -> &[u8] {
    name.strip_suffix(b":").unwrap_or(name)
}

/// Returns an empty list with room for `count` items. `what` names the items in the message of the error.
///
/// # Errors
/// [`Error::OutOfMemory`] if memory is short.
pub fn with_room<T>(count: usize, what: &'static str) -> Result<Vec<T>, Error> {
    let mut list = Vec::new();
    list.try_reserve_exact(count).map_err(|_| Error::OutOfMemory { what })?;
    Ok(list)
}

/// Appends to a list, or returns [`Error::OutOfMemory`]; `what` names the items.
pub fn push<T>(list: &mut Vec<T>, item: T, what: &'static str) -> Result<(), Error> {
    list.try_reserve(1).map_err(|_| Error::OutOfMemory { what })?;
    list.push(item);
    Ok(())
}

impl fmt::Display for Error {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(&String::from_utf8_lossy(&self.message()))
    }
}

impl std::error::Error for Error {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::Read { cause, .. } | Self::Input(cause) => Some(cause),
            _ => None,
        }
    }
}

impl From<io::Error> for Error {
    fn from(cause: io::Error) -> Self {
        Self::Input(cause)
    }
}

impl From<Picture> for Error {
    fn from(cause: Picture) -> Self {
        Self::Picture(cause)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_shown_byte_for_byte() {
        let error = Error::InvalidParameters { entity: "sphere", line: b"sphere: \xff \0 ".to_vec() };
        assert_eq!(error.message(), b"Invalid sphere parameters\nLine: \"sphere: \xff \0 \"");
        assert!(error.to_string().contains('\u{fffd}'), "as text, what is not UTF-8 is replaced");
        assert_eq!(error.message_for_terminal(), b"Invalid sphere parameters\nLine: \"sphere: \\xff \\u{0} \"");
    }

    #[test]
    fn a_file_is_named_where_the_error_lacks_one() {
        let path = Path::new("config.txt");
        let read = Error::from(io::Error::other("gone")).in_file(path);
        assert_eq!(read.to_string(), "Cannot read file [config.txt]: gone");
        let picture = Error::from(Picture::CameraAtTarget).in_file(path);
        assert!(picture.to_string().starts_with("Invalid configuration [config.txt]: camera_position"));
        let other = Error::OutOfMemory { what: "x" }.in_file(path);
        assert_eq!(other.to_string(), "Not enough memory for x");
    }

    #[test]
    fn causes_are_kept() {
        use std::error::Error as _;
        let read = Error::Read { path: "c.txt".into(), cause: io::Error::other("gone") };
        assert_eq!(read.to_string(), "Cannot read file [c.txt]: gone");
        assert!(read.source().is_some());
        assert!(Error::OutOfMemory { what: "the image" }.source().is_none());
    }

    #[test]
    fn an_image_too_large_says_how_large_and_what_to_change() {
        let error = Error::from(Picture::TooLarge { width: 100_000, height: 100_000 });
        let text = error.to_string();
        assert!(text.contains("100000 x 100000") && text.contains("image_width"), "{text}");
    }
}
