//! The pictures of a trial: where they go, and their bytes.
//!
//! All places are opened before anything is rendered, and a file is replaced only when its picture is complete: whoever
//! looks at one never sees half of it.

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use cpu::Size;
use cpu::Vec3;
use cpu::internals::image::quantize::quantize;
use cpu::internals::output;
use cpu::internals::output::Output;

use super::args::Options;
use super::files::{UserModule, shown};
use super::view::View;
use crate::{Error, Float};

/// A place for a picture, and its name.
#[derive(Debug)]
pub struct Place {
    /// Its name.
    pub path: PathBuf,
    output: Output,
}

/// The places of all pictures of a trial.
#[derive(Debug)]
pub struct Places {
    /// The picture that was asked for.
    pub out: Place,
    /// The picture of differences; none beside a view, nor beside a device or a pipe, where a new file would be a
    /// surprise.
    pub difference: Option<Place>,
    /// Both sides of a view.
    pub view: Option<Place>,
}

impl Places {
    /// Opens all places that `options` need.
    ///
    /// # Errors
    /// [`Error::Scene`] for a place that cannot be written, or that is one of the files that are read.
    pub fn open(options: &Options, modules: &[UserModule]) -> Result<Self, Error> {
        let mut inputs = vec![options.config.as_path(), options.scene.as_path()];
        inputs.extend(modules.iter().map(|module| module.path.as_path()));
        let open = |path: PathBuf| -> Result<Place, Error> {
            output::refuse_inputs(&path, &inputs)?;
            let named = if path.as_os_str() == "-" { Path::new(STANDARD_OUTPUT) } else { &path };
            let output = Output::open(named, output::Options { sync: options.sync })?;
            Ok(Place { path, output })
        };
        let takes_neighbours = takes_neighbours(&options.out);
        let neighbour = |suffix: &str| takes_neighbours.then(|| open(beside(&options.out, suffix))).transpose();
        let view = options.view.filter(|view| *view != View::Difference);
        Ok(Self {
            out: open(options.out.clone())?,
            difference: if options.view.is_none() { neighbour("difference")? } else { None },
            view: view.map_or(Ok(None), |view| neighbour(&view.to_string()))?,
        })
    }
}

impl Place {
    /// Writes a picture of `size`, or of several such below each other.
    ///
    /// # Errors
    /// [`Error::Scene`] when the system does not take it.
    pub fn write(self, size: Size, pixels: &[[u8; 3]]) -> Result<(), Error> {
        self.write_rows(size.width(), pixels)
    }

    /// Writes panels of `width` below each other, each with its caption.
    ///
    /// # Errors
    /// As [`Place::write`], or too little memory.
    pub fn write_panels(self, panels: &[(&str, &[[u8; 3]])], width: usize) -> Result<(), Error> {
        let canvas = annotate::panels(panels, width);
        let canvas = canvas.map_err(|_| cpu::internals::input::error::Error::OutOfMemory { what: "the panels" })?;
        self.write_rows(canvas.width, &canvas.pixels)
    }

    fn write_rows(self, width: usize, pixels: &[[u8; 3]]) -> Result<(), Error> {
        let bytes = encoded(&self.path, width, pixels).map_err(|cause| Error::File { path: self.path, cause })?;
        Ok(self.output.fill(|file| file.write_all(&bytes))?)
    }

    /// The name for a message, without characters that a terminal would obey.
    #[must_use]
    pub fn name(&self) -> String {
        if self.path.as_os_str() == "-" { "- (standard output)".to_owned() } else { shown(&self.path) }
    }
}

/// Standard output, which a person calls `-`.
pub const STANDARD_OUTPUT: &str = "/dev/stdout";

/// The file of rows of `width` pixels: PNG where its name says so, else PPM.
///
/// # Errors
/// It has more rows or columns than a PNG may have.
pub(crate) fn encoded(path: &Path, width: usize, pixels: &[[u8; 3]]) -> std::io::Result<Vec<u8>> {
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

/// Whether other pictures may be written beside `out`: not where it is a device or a pipe.
fn takes_neighbours(out: &Path) -> bool {
    let is_of_the_system = ["/dev", "/proc"].iter().any(|folder| out.starts_with(folder));
    !is_of_the_system && out.as_os_str() != "-" && out.metadata().map_or(true, |metadata| metadata.is_file())
}

/// `out` with `-suffix` before its ending.
#[must_use]
pub fn beside(out: &Path, suffix: &str) -> PathBuf {
    let mut name = OsString::from(out.file_stem().unwrap_or_default());
    name.push(format!("-{suffix}.png"));
    out.with_file_name(name)
}

/// Linear colours as the bytes that the renderer would make of them.
#[must_use]
pub fn bytes<T: Float>(pixels: &[Vec3<T>], gamma: f64) -> Vec<[u8; 3]> {
    pixels.iter().map(|color| color.to_array().map(|channel| quantize(channel.wide(), gamma))).collect()
}

/// That a picture can be written under this name: `.png`, `.ppm`, or a name without an ending, which is a PPM.
///
/// # Errors
/// A message for the person who typed it.
pub fn check_name(path: &Path) -> Result<(), String> {
    match path.extension() {
        None => Ok(()),
        Some(ending) if ["png", "ppm"].iter().any(|known| ending.eq_ignore_ascii_case(known)) => Ok(()),
        Some(ending) => {
            let ending = ending.to_string_lossy();
            Err(format!("--out: a picture cannot be written as .{ending}; its name must end in .png or .ppm"))
        }
    }
}

fn is_png(path: &Path) -> bool {
    path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("png"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_stand_beside_the_picture() {
        assert_eq!(beside(Path::new("a/out.png"), "difference"), Path::new("a/out-difference.png"));
    }

    #[test]
    fn nothing_is_written_beside_devices_and_standard_output() {
        assert!(takes_neighbours(Path::new("new.png")));
        assert!(["/dev/null", "/dev/stdout", STANDARD_OUTPUT].iter().all(|out| !takes_neighbours(Path::new(out))));
    }

    #[test]
    fn the_ending_of_a_name_decides_what_is_written() {
        let pixels = [[1, 2, 3], [4, 5, 6]];
        let file = |name: &str| encoded(Path::new(name), 2, &pixels).expect("it fits in memory");
        assert!(file("a.PNG").starts_with(b"\x89PNG"));
        assert_eq!(file("a.ppm"), b"P6\n2 1\n255\n\x01\x02\x03\x04\x05\x06");
        assert_eq!(file("-"), file("a.ppm"));
        for name in ["a.png", "a.ppm", "-", "/dev/stdout"] {
            assert_eq!(check_name(Path::new(name)), Ok(()), "{name}");
        }
        assert!(check_name(Path::new("a.jpg")).is_err_and(|message| message.contains("must end in .png or .ppm")));
    }

    #[test]
    fn bytes_are_the_renderers() {
        assert_eq!(bytes(&[Vec3::new(0.0, 0.25, 1.0_f32)], 2.0), [[0, 127, 255]]);
    }
}
