//! Chooses the format of a picture's file by the ending of its name.

use std::io::{self, Write};
use std::path::Path;

use super::Picture;
use crate::terminal;

/// The file format of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// PPM in its text form (P3), as the evaluated programs write it.
    Ppm,
    /// PNG, which compresses without loss.
    Png,
}

impl Kind {
    /// Returns the format for the ending of the file's name. A name without an ending, such as `/dev/stdout` or `-`,
    /// has the format `otherwise`.
    ///
    /// # Errors
    /// An error if the name has an ending other than `ppm` and `png`.
    pub fn of(path: &Path, otherwise: Self) -> Result<Self, String> {
        match path.extension().map(|ending| ending.to_ascii_lowercase()) {
            None => Ok(otherwise),
            Some(ending) if ending == "ppm" => Ok(Self::Ppm),
            Some(ending) if ending == "png" => Ok(Self::Png),
            Some(ending) => {
                let (path, ending) =
                    (terminal::name(path), cpu::internals::input::text::escape(ending.as_encoded_bytes()));
                Err(format!("{path}: a picture cannot be written as .{ending}; its name must end in .ppm or .png"))
            }
        }
    }
}

impl Picture {
    /// Writes the picture to `out` in the format `kind`.
    ///
    /// # Errors
    /// An error of `out`.
    pub fn write(&self, kind: Kind, out: impl Write) -> io::Result<()> {
        match kind {
            Kind::Ppm => self.write_ppm(out),
            Kind::Png => self.write_png(out),
        }
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
        assert_eq!(message, "o.jpg: a picture cannot be written as .jpg; its name must end in .ppm or .png");
    }
}
