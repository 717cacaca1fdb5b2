//! Opens and writes the pictures of a trial.
//!
//! All files are opened before the rendering. A file is replaced only when its picture is complete, so that no program
//! can read half of a picture.

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use cpu::Size;
use cpu::Vec3;
use cpu::internals::image::quantize::quantize;
use output::Output;

use super::args::Options;
use super::files::{UserModule, shown};
use crate::{Error, Float};

/// An opened output for one picture, with its path.
#[derive(Debug)]
pub struct Place {
    /// The path, as the user named it.
    pub path: PathBuf,
    output: Output,
}

/// The opened outputs for all pictures of a trial, which is one rendering with the user's modules.
#[derive(Debug)]
pub struct Places {
    /// The output for the picture itself.
    pub out: Place,
    /// The output for the picture of differences. `None` if `out` is a device or a pipe, because the user does not
    /// expect other files beside these.
    pub difference: Option<Place>,
}

impl Places {
    /// Opens all outputs that `options` need.
    ///
    /// # Errors
    /// [`Error::Output`] if a file cannot be written, or is also an input.
    pub fn open(options: &Options, modules: &[UserModule]) -> Result<Self, Error> {
        let mut inputs = vec![options.config.as_path(), options.scene.as_path()];
        inputs.extend(modules.iter().map(|module| module.path.as_path()));
        let open = |path: PathBuf| -> Result<Place, Error> {
            output::refuse_inputs(&path, &inputs)?;
            let named = if path.as_os_str() == "-" { Path::new(STANDARD_OUTPUT) } else { &path };
            let output = Output::open(named, output::Options { sync: !options.no_sync })?;
            Ok(Place { path, output })
        };
        Ok(Self {
            out: open(options.out.clone())?,
            difference: allows_other_files(&options.out).then(|| open(beside(&options.out))).transpose()?,
        })
    }
}

impl Place {
    /// Writes a picture of `size`. `pixels` may also hold several pictures of `size`, which are drawn below each other.
    ///
    /// # Errors
    /// [`Error::Output`] if the file cannot be written, [`Error::File`] if the picture is too large for a PNG.
    pub fn write(self, size: Size, pixels: &[[u8; 3]]) -> Result<(), Error> {
        self.write_rows(size.width(), pixels)
    }

    /// Writes panels of `width` pixels below each other, each with its caption above it. A panel is a caption and its
    /// pixels.
    ///
    /// # Errors
    /// The errors of [`Place::write`], and [`Error::Scene`] if there is too little memory.
    pub fn write_panels(self, panels: &[(&str, &[[u8; 3]])], width: usize) -> Result<(), Error> {
        let canvas = format::annotate::panels(panels, width);
        let canvas = canvas.map_err(|_| cpu::internals::input::error::Error::OutOfMemory { what: "the panels" })?;
        self.write_rows(canvas.width, &canvas.pixels)
    }

    fn write_rows(self, width: usize, pixels: &[[u8; 3]]) -> Result<(), Error> {
        let bytes = encoded(&self.path, width, pixels).map_err(|cause| Error::File { path: self.path, cause })?;
        Ok(self.output.fill(|file| file.write_all(&bytes))?)
    }

    /// Returns the path for messages, with control characters escaped.
    #[must_use]
    pub fn name(&self) -> String {
        if self.path.as_os_str() == "-" { "- (standard output)".to_owned() } else { shown(&self.path) }
    }
}

/// The path of standard output. Users write `-` for it.
pub const STANDARD_OUTPUT: &str = "/dev/stdout";

/// Returns the bytes of a picture file whose rows have `width` pixels. The format is PNG if `path` ends in `.png`, and
/// otherwise PPM.
///
/// # Errors
/// An error if the picture has more rows or columns than a PNG can have.
fn encoded(path: &Path, width: usize, pixels: &[[u8; 3]]) -> std::io::Result<Vec<u8>> {
    let height = pixels.len() / width.max(1);
    if !is_png(path) {
        let head = format!("P6\n{width} {height}\n255\n");
        return Ok([head.as_bytes(), pixels.as_flattened()].concat());
    }
    let side = |pixels: usize| u32::try_from(pixels).map_err(std::io::Error::other);
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, side(width)?, side(height)?);
    encoder.set_color(png::ColorType::Rgb);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(pixels.as_flattened())?;
    writer.finish()?;
    Ok(bytes)
}

/// Whether other pictures may be written beside `out`. The result is false if `out` is a device, a pipe or standard
/// output.
fn allows_other_files(out: &Path) -> bool {
    let is_of_the_system = ["/dev", "/proc"].iter().any(|folder| out.starts_with(folder));
    !is_of_the_system && out.as_os_str() != "-" && out.metadata().map_or(true, |metadata| metadata.is_file())
}

/// Returns the path of the picture of differences: a PNG beside `out`, named after it.
fn beside(out: &Path) -> PathBuf {
    let mut name = OsString::from(out.file_stem().unwrap_or_default());
    name.push("-difference.png");
    out.with_file_name(name)
}

/// Returns the bytes of linear colours, quantised as the renderer does.
#[must_use]
pub fn bytes<T: Float>(pixels: &[Vec3<T>], gamma: f64) -> Vec<[u8; 3]> {
    pixels.iter().map(|color| color.to_array().map(|channel| quantize(channel.wide(), gamma))).collect()
}

fn is_png(path: &Path) -> bool {
    path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("png"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_stand_beside_the_picture() {
        assert_eq!(beside(Path::new("a/out.png")), Path::new("a/out-difference.png"));
    }

    #[test]
    fn nothing_is_written_beside_devices_and_standard_output() {
        assert!(allows_other_files(Path::new("new.png")));
        assert!(["/dev/null", "/dev/stdout", STANDARD_OUTPUT].iter().all(|out| !allows_other_files(Path::new(out))));
    }

    #[test]
    fn the_ending_of_a_name_decides_what_is_written() {
        let pixels = [[1, 2, 3], [4, 5, 6]];
        let file = |name: &str| encoded(Path::new(name), 2, &pixels).expect("it fits in memory");
        assert!(file("a.PNG").starts_with(b"\x89PNG"));
        assert_eq!(file("a.ppm"), b"P6\n2 1\n255\n\x01\x02\x03\x04\x05\x06");
        assert_eq!(file("-"), file("a.ppm"));
    }

    #[test]
    fn bytes_are_the_renderers() {
        assert_eq!(bytes(&[Vec3::new(0.0, 0.25, 1.0_f32)], 2.0), [[0, 127, 255]]);
    }
}
