//! The formats of pictures, which the ending of a file's name or its first bytes tell, and pictures of any format.

use std::io::{self, Read, Write};
use std::path::Path;

use cpu::internals::input::reader::Input;

use super::floats::{self, Floats};
use super::{MAX_FILE_BYTES, Picture, exr, ppm};
use crate::format::unseen;
use crate::{Failure, terminal};

/// The file format of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// PPM in its text form (P3), as the evaluated programs write it.
    Ppm,
    /// PNG, which compresses without loss.
    Png,
    /// Portable float map: one or three numbers a pixel.
    Pfm,
    /// An array of NumPy.
    Npy,
    /// OpenEXR.
    Exr,
}

/// The ending of the name of each format.
const ENDINGS: [(&str, Kind); 5] =
    [("ppm", Kind::Ppm), ("png", Kind::Png), ("pfm", Kind::Pfm), ("npy", Kind::Npy), ("exr", Kind::Exr)];

impl Kind {
    /// Returns the format for the ending of the file's name. A name without an ending, such as `/dev/stdout` or `-`,
    /// has the format `otherwise`.
    ///
    /// # Errors
    /// An error if the name has another ending than those of the formats.
    pub fn of(path: &Path, otherwise: Self) -> Result<Self, String> {
        let Some(ending) = path.extension() else { return Ok(otherwise) };
        let known = ENDINGS.iter().find(|(name, _)| ending.eq_ignore_ascii_case(name));
        known.map(|&(_, kind)| kind).ok_or_else(|| {
            let (path, ending) = (terminal::name(path), cpu::internals::input::text::escape(ending.as_encoded_bytes()));
            let [start @ .., last] = ENDINGS.map(|(name, _)| format!(".{name}"));
            let names = start.join(", ");
            format!("{path}: a picture cannot be written as .{ending}; its name must end in {names} or {last}")
        })
    }

    /// Returns the format of a file with these first bytes, of which four are enough.
    pub const fn of_bytes(bytes: &[u8]) -> Option<Self> {
        match bytes {
            [b'P', b'3' | b'6', ..] => Some(Self::Ppm),
            [0x89, b'P', b'N', b'G', ..] => Some(Self::Png),
            [b'P', b'F' | b'f', b'\n' | b'\r' | b' ' | b'\t', ..] => Some(Self::Pfm),
            [0x93, b'N', b'U', b'M', ..] => Some(Self::Npy),
            [0x76, 0x2f, 0x31, 0x01, ..] => Some(Self::Exr),
            _ => None,
        }
    }

    /// Whether the format holds floating-point numbers.
    pub const fn is_of_floats(self) -> bool {
        matches!(self, Self::Pfm | Self::Npy | Self::Exr)
    }
}

/// A picture of any format.
#[derive(Clone, Debug, PartialEq)]
pub enum Any {
    /// A picture of bytes.
    Bytes(Picture),
    /// A picture of floating-point numbers.
    Floats(Floats),
}

impl Any {
    /// Reads a picture from a file. The first bytes of the file tell its format.
    ///
    /// # Errors
    /// An error if the file cannot be read, is larger than [`MAX_FILE_BYTES`], or is no picture of a known format.
    pub fn read(path: &Path) -> Result<Self, Failure> {
        let open = || Input::open(path, MAX_FILE_BYTES).map_err(|error| error.to_string());
        let read = || Self::parse(&picture_bytes(open()?)?);
        read().map_err(|reason| format!("{}: {reason}", terminal::name(path)).into())
    }

    /// Returns the picture in the bytes of a file.
    ///
    /// # Errors
    /// The error of the bytes, as text.
    pub fn parse(bytes: &[u8]) -> Result<Self, String> {
        match Kind::of_bytes(bytes) {
            Some(Kind::Png) => super::from_png(bytes).map(Self::Bytes),
            Some(Kind::Ppm) => ppm::parse(bytes).map(Self::Bytes),
            Some(Kind::Pfm) => floats::from_pfm(bytes).map(Self::Floats),
            Some(Kind::Npy) => floats::from_npy(bytes).map(Self::Floats),
            Some(Kind::Exr) => exr::parse(bytes).map(Self::Floats),
            None => Err(neither(bytes)),
        }
    }

    /// Writes the picture to `out` in the format `kind`. `gamma` is that between bytes and linear light.
    ///
    /// # Errors
    /// An error of `out`, or of memory.
    pub fn write(&self, kind: Kind, gamma: f64, out: impl Write) -> io::Result<()> {
        match (self, kind) {
            (Self::Bytes(picture), Kind::Ppm) => picture.write_ppm(out),
            (Self::Bytes(picture), Kind::Png) => picture.write_png(out),
            (Self::Floats(floats), Kind::Pfm) => floats.write_pfm(out),
            (Self::Floats(floats), Kind::Npy) => floats.write_npy(out),
            (Self::Floats(floats), Kind::Exr) => exr::write(floats, out),
            (Self::Bytes(picture), _) => {
                Self::Floats(Floats::of(picture, gamma).map_err(io::Error::other)?).write(kind, gamma, out)
            }
            (Self::Floats(floats), _) => {
                Self::Bytes(floats.to_picture(gamma).map_err(io::Error::other)?).write(kind, gamma, out)
            }
        }
    }

    /// Returns the picture in bytes. Numbers are linear light, and become bytes by the exponent 1 / `gamma`.
    ///
    /// # Errors
    /// An error if memory is short.
    pub fn into_picture(self, gamma: f64) -> Result<Picture, String> {
        match self {
            Self::Bytes(picture) => Ok(picture),
            Self::Floats(floats) => floats.to_picture(gamma),
        }
    }
}

/// Returns the message for a file that begins with `bytes` and not as a picture does.
fn neither(bytes: &[u8]) -> String {
    // Binary files of other kinds have zero bytes too.
    let mark = unseen::mark(bytes).filter(|mark| mark.character != '\0' || bytes.contains(&b'P'));
    let cause = mark.map(|mark| format!(": it begins with {}; {}", mark.what[0], mark.remedy[0]));
    format!("neither PPM (P3 or P6), PNG, PFM, NPY nor EXR{}", cause.unwrap_or_default())
}

/// Reads all bytes of a file that begins like a picture. Any other file, such as `/dev/zero`, is refused after four
/// bytes, because it may have no end.
fn picture_bytes(mut file: impl Read) -> Result<Vec<u8>, String> {
    let mut bytes = Vec::new();
    let mut read = |limit, bytes: &mut Vec<u8>| {
        // If memory is short, `read_to_end` returns an error.
        (&mut file).take(limit).read_to_end(bytes).map_err(|error| error.to_string())
    };
    read(4, &mut bytes)?;
    if Kind::of_bytes(&bytes).is_none() {
        return Err(neither(&bytes));
    }
    read(u64::MAX, &mut bytes)?;
    Ok(bytes)
}
