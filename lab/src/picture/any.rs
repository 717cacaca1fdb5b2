//! The formats of pictures, which the ending of a file's name or its first bytes tell, and pictures of any format.

use std::fs::File;
use std::io::{self, BufRead, BufReader, Cursor, Read, Seek, Write};
use std::path::Path;

use cpu::internals::input::reader::LimitedFile;

use super::floats::Floats;
use super::{MAX_FILE_BYTES, Picture, exr, npy, pfm, png, ppm, spare};
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
            let names = listed(&ENDINGS.map(|(name, _)| name));
            format!("{path}: a picture cannot be written as .{ending}; its name must end in {names}")
        })
    }

    /// Returns the format of a drawing with a scale, as [`Kind::of`] does: PNG or PPM.
    ///
    /// # Errors
    /// An error for a format of numbers, which a drawing does not have, or for another ending.
    pub fn of_drawing(path: &Path) -> Result<Self, String> {
        let known = Self::of(path, Self::Png);
        known.ok().filter(|kind| !kind.is_of_floats()).ok_or_else(|| {
            format!(
                "{}: this is a drawing with colours and a scale; its name must end in .png or .ppm",
                terminal::name(path)
            )
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
    /// Reads a picture from a file. The first bytes of the file tell its format. Prints what the picture leaves out.
    ///
    /// # Errors
    /// An error if the file cannot be read, is larger than [`MAX_FILE_BYTES`], or is no picture of a known format.
    pub fn read(path: &Path) -> Result<Self, Failure> {
        Self::read_layer(path, None)
    }

    /// Reads a picture as [`Any::read`] does. Of an EXR it takes the layer of this name.
    ///
    /// # Errors
    /// The errors of [`Any::read`], and that there is no such layer.
    pub fn read_layer(path: &Path, layer: Option<&str>) -> Result<Self, Failure> {
        let mut notes = Vec::new();
        let read = |notes: &mut Vec<String>| {
            let file = File::open(path).map_err(|error| error.to_string())?;
            let about = file.metadata().map_err(|error| error.to_string())?;
            if about.is_file() {
                return Self::decode(BufReader::with_capacity(1 << 16, file), about.len(), layer, notes);
            }
            // A pipe gives its content only once, so all of it is kept.
            drop(file);
            let bytes = LimitedFile::open(path, MAX_FILE_BYTES).map_err(|error| error.to_string());
            let bytes = picture_bytes(bytes?)?;
            Self::decode(Cursor::new(&bytes[..]), bytes.len() as u64, layer, notes)
        };
        let name = terminal::name(path);
        let found = read(&mut notes).map_err(|reason| format!("{name}: {reason}"))?;
        notes.iter().for_each(|note| terminal::note(&format!("{name}: {note}")));
        Ok(found)
    }

    /// Returns the picture in the bytes of a file.
    ///
    /// # Errors
    /// The error of the bytes, as text.
    pub fn parse(bytes: &[u8]) -> Result<Self, String> {
        Self::decode(Cursor::new(bytes), bytes.len() as u64, None, &mut Vec::new())
    }

    /// Reads the picture in `source`, a file of `length` bytes.
    fn decode(
        mut source: impl BufRead + Seek,
        length: u64,
        layer: Option<&str>,
        notes: &mut Vec<String>,
    ) -> Result<Self, String> {
        spare(0)?;
        let head = source.fill_buf().map_err(|error| error.to_string())?;
        let head = &head[..head.len().min(4)];
        let kind = Kind::of_bytes(head).ok_or_else(|| neither(head))?;
        if length > MAX_FILE_BYTES {
            return Err(format!("it is larger than {MAX_FILE_BYTES} bytes"));
        }
        if layer.is_some() && kind != Kind::Exr {
            return Err("--layer is for EXR files, and this file has no layers".to_owned());
        }
        match kind {
            Kind::Png => png::decode(source, length, notes).map(Self::Bytes),
            Kind::Ppm => ppm::decode(source, length).map(Self::Bytes),
            Kind::Pfm => pfm::decode(source, length).map(Self::Floats),
            Kind::Npy => Ok(match npy::decode(source, length, notes)? {
                npy::Array::Bytes(picture) => Self::Bytes(picture),
                npy::Array::Numbers(floats) => Self::Floats(floats),
            }),
            Kind::Exr => exr::decode(source, length, layer, notes).map(Self::Floats),
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
            (Self::Floats(floats), Kind::Pfm) => pfm::write(floats, out),
            (Self::Floats(floats), Kind::Npy) => npy::write(floats, out),
            (Self::Floats(floats), Kind::Exr) => exr::write(floats, out),
            (Self::Bytes(picture), _) => {
                Self::Floats(Floats::of(picture, gamma).map_err(io::Error::other)?).write(kind, gamma, out)
            }
            (Self::Floats(floats), _) => {
                Self::Bytes(floats.to_picture(gamma).map_err(io::Error::other)?).write(kind, gamma, out)
            }
        }
    }

    /// Returns a copy of a part: column, row, width and height.
    ///
    /// # Errors
    /// A message if memory is short, or if the part does not lie within the picture.
    pub fn crop(&self, part: [usize; 4]) -> Result<Self, String> {
        Ok(match self {
            Self::Bytes(picture) => Self::Bytes(picture.crop(part)?),
            Self::Floats(floats) => Self::Floats(floats.crop(part)?),
        })
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

/// Returns the endings as a list in words.
fn listed(endings: &[&str]) -> String {
    let names: Vec<_> = endings.iter().map(|name| format!(".{name}")).collect();
    names.split_last().map_or_else(String::new, |(last, start)| format!("{} or {last}", start.join(", ")))
}

/// Returns the message for a file that begins with `bytes` and not as a picture does.
fn neither(bytes: &[u8]) -> String {
    // Binary files of other kinds have zero bytes too.
    let mark = unseen::mark(bytes).filter(|mark| mark.character != '\0' || bytes.contains(&b'P'));
    let cause = mark.map(|mark| format!(": it begins with {}; {}", mark.what[0], mark.remedy[0]));
    let known = match bytes {
        [b'P', b'K', ..] => Some("an archive, such as .npz of NumPy; save one array by numpy.save".to_owned()),
        [b'P', b'1' | b'2' | b'4' | b'5' | b'7', ..] => {
            Some("a PBM, PGM or PAM; convert it to PPM, for instance by pnmtopng or ppmtoppm".to_owned())
        }
        _ => None,
    };
    known.unwrap_or_else(|| format!("neither PPM (P3 or P6), PNG, PFM, NPY nor EXR{}", cause.unwrap_or_default()))
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
