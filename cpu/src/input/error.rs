//! Everything that can go wrong, as values with the exact messages (specification, sections 3.4 and 4.3).

use std::fmt;
use std::io;
use std::path::{Path, PathBuf};

/// Why the arguments, a configuration, a scene, a picture or an output file was refused.
///
/// The message is [`Error::message`], without the leading `Error: ` that the programs print. Lines and keys are bytes,
/// since the input need not be UTF-8 and is shown as it stands.
#[derive(Debug)]
#[non_exhaustive]
pub enum Error {
    /// The program was called with this number of arguments instead of three.
    ArgumentCount(usize),
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
    /// More tokens than a configuration value has.
    ExtraValue {
        /// The key, with its colon.
        key: &'static str,
        /// The rest of the line, trimmed.
        extra: Vec<u8>,
    },
    /// A scene line that starts with no known entity.
    UnknownEntity {
        /// The first token of the line.
        name: Vec<u8>,
    },
    /// Scene parameters that are missing, unreadable or out of range.
    InvalidParameters {
        /// What the line describes, as the message names it: `matte material`, `sphere` and so on.
        entity: &'static str,
        /// The line, without its line end.
        line: Vec<u8>,
    },
    /// More tokens than a scene line has.
    ExtraParameters {
        /// The entity's tag, with its colon.
        tag: &'static str,
        /// The rest of the line, trimmed.
        extra: Vec<u8>,
        /// The line, without its line end.
        line: Vec<u8>,
    },
    /// A second material of the same name.
    MaterialExists {
        /// The material's name.
        name: Vec<u8>,
        /// The line, without its line end.
        line: Vec<u8>,
    },
    /// An object made of a material that no line above defines.
    MaterialNotFound {
        /// The material's name.
        name: Vec<u8>,
        /// The line, without its line end.
        line: Vec<u8>,
    },
    /// A file that cannot be read.
    Read {
        /// The file as named by the caller.
        path: PathBuf,
        /// What the system said.
        cause: io::Error,
    },
    /// A file that cannot be written. It is as it was.
    Write {
        /// The file as named by the caller.
        path: PathBuf,
        /// What the system said.
        cause: io::Error,
    },
    /// Reading text failed before the file's name was known; [`Error::in_file`] adds it.
    Input(io::Error),
    /// The configuration describes a picture that cannot be made.
    Picture(Picture),
    /// The same, with the configuration file that says so.
    PictureIn {
        /// The configuration file.
        path: PathBuf,
        /// What is wrong with it.
        cause: Picture,
    },
    /// There is not enough memory for what is named.
    OutOfMemory {
        /// What did not fit, in words.
        what: &'static str,
    },
}

/// Most pixels that an image may have: 2^30, three bytes each.
pub const MAX_PIXELS: u64 = 1 << 30;

/// A picture that cannot be made, though every value of the configuration is valid by itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Picture {
    /// More pixels than an image may have ([`MAX_PIXELS`]).
    TooLarge {
        /// Width in pixels.
        width: u64,
        /// Height in pixels; `u64::MAX` stands for any height that does not fit.
        height: u64,
    },
    /// `camera_position` equals `camera_target`.
    CameraAtTarget,
    /// `camera_north` is null or parallel to the view.
    NorthParallel,
    /// The camera's values are so large or so small that its window overflows.
    CameraOutOfRange,
}

impl fmt::Display for Picture {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooLarge { width, height } => write!(
                out,
                "the image is too large to hold: {width} x {height} pixels, at most {} in all; \
                 choose a smaller image_width or another aspect_ratio",
                MAX_PIXELS
            ),
            Self::CameraAtTarget => {
                out.write_str("camera_position is the same point as camera_target; move one of them")
            }
            Self::NorthParallel => out.write_str(
                "camera_north is null or parallel to the view from camera_position to camera_target; \
                 choose another north",
            ),
            Self::CameraOutOfRange => out
                .write_str("the camera's position, target or field_of_view is out of range: its window is not finite"),
        }
    }
}

impl Error {
    /// The same error, with the name of the file it comes from where it lacks one.
    #[must_use]
    pub fn in_file(self, path: &Path) -> Self {
        match self {
            Self::Input(cause) => Self::Read { path: path.to_owned(), cause },
            Self::Picture(cause) => Self::PictureIn { path: path.to_owned(), cause },
            other => other,
        }
    }

    /// The message, byte for byte, without the leading `Error: ` and without a closing line end.
    #[must_use]
    pub fn message(&self) -> Vec<u8> {
        self.message_with(<[u8]>::to_vec)
    }

    /// The message for a terminal: what comes from files and names is [escaped](crate::input::text::escape).
    #[must_use]
    pub fn message_for_terminal(&self) -> Vec<u8> {
        self.message_with(|text| crate::input::text::escape(text).into_bytes())
    }

    /// The message, with what comes from files and names as `show` gives it.
    fn message_with(&self, show: fn(&[u8]) -> Vec<u8>) -> Vec<u8> {
        let about_file = |what: &str, path: &Path, cause: &dyn fmt::Display| {
            let cause = show(cause.to_string().as_bytes());
            [what.as_bytes(), b" [", &show(path.as_os_str().as_encoded_bytes()), b"]: ", &cause].concat()
        };
        let text = match self {
            Self::UnknownKey { key } => {
                let colon: &[u8] = if key.ends_with(b":") { b"" } else { b":" };
                return [b"Unknown configuration key: [", &show(key)[..], colon, b"]"].concat();
            }
            Self::InvalidValue { key, line } => {
                return [b"Invalid value for key: [", key.as_bytes(), b"]\nLine: \"", &show(line), b"\""].concat();
            }
            Self::ExtraValue { key, extra } => return extra_data(key, &show(extra)),
            Self::UnknownEntity { name } => {
                return [b"Unknown scene entity: ", &show(name.strip_suffix(b":").unwrap_or(name))[..]].concat();
            }
            Self::InvalidParameters { entity, line } => {
                return [b"Invalid ", entity.as_bytes(), b" parameters\nLine: \"", &show(line), b"\""].concat();
            }
            Self::ExtraParameters { tag, extra, line } => {
                return [&extra_data(tag, &show(extra))[..], b"\nLine: \"", &show(line), b"\""].concat();
            }
            Self::MaterialExists { name, line } => {
                let (name, line) = (show(name), show(line));
                return [b"Material with name [", &name[..], b"] already exists\nLine: \"", &line, b"\""].concat();
            }
            Self::MaterialNotFound { name, line } => {
                return [b"Material not found: [", &show(name)[..], b"]\nLine: \"", &show(line), b"\""].concat();
            }
            Self::ArgumentCount(count) => format!("Invalid number of arguments: {count}"),
            Self::Read { path, cause } => return about_file("Cannot read file", path, cause),
            Self::Write { path, cause } => return about_file("Cannot write file", path, cause),
            Self::Input(cause) => format!("Cannot read the input: {cause}"),
            Self::Picture(cause) => format!("Invalid configuration: {cause}"),
            Self::PictureIn { path, cause } => return about_file("Invalid configuration", path, cause),
            Self::OutOfMemory { what } => format!("Not enough memory for {what}"),
        };
        text.into_bytes()
    }
}

fn extra_data(key: &str, extra: &[u8]) -> Vec<u8> {
    [b"Extra data after configuration value for key: [", key.as_bytes(), b"]\nExtra: \"", extra, b"\""].concat()
}

impl fmt::Display for Error {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(&String::from_utf8_lossy(&self.message()))
    }
}

impl std::error::Error for Error {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::Read { cause, .. } | Self::Write { cause, .. } | Self::Input(cause) => Some(cause),
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
mod tests;
