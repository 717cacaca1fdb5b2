//! The formats of pictures, which the ending of a file's name or its first bytes tell.

use std::path::Path;

use crate::terminal;

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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ending_of_a_name_decides_what_is_written() {
        for (name, kind) in [("a.ppm", Kind::Ppm), ("a.PNG", Kind::Png), ("/dev/stdout", Kind::Ppm), ("-", Kind::Ppm)] {
            assert_eq!(Kind::of(Path::new(name), Kind::Ppm), Ok(kind), "{name}");
        }
        assert_eq!(Kind::of(Path::new("-"), Kind::Png), Ok(Kind::Png));
        let message = Kind::of(Path::new("o.jpg"), Kind::Ppm).expect_err("there is no such writer");
        assert_eq!(
            message,
            "o.jpg: a picture cannot be written as .jpg; its name must end in .ppm, .png, .pfm, .npy or .exr"
        );
    }
}
