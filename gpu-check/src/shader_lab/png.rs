//! The pictures of a trial: where they go, and their bytes.
//!
//! All places are opened before anything is rendered, and a file is replaced only when its picture is complete: whoever
//! looks at one never sees half of it.

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use cpu::Vec3;
use cpu::image::Size;
use cpu::output::{self, Output};
use cpu::quantize::quantize;

use super::args::Options;
use super::files::UserModule;
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
    /// The picture of differences; none beside a device or a pipe, where a new file would be a surprise.
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
            let output = Output::open(&path, output::Options { sync: options.sync })?;
            Ok(Place { path, output })
        };
        let takes_neighbours = takes_neighbours(&options.out);
        let neighbour = |suffix: &str| takes_neighbours.then(|| open(beside(&options.out, suffix))).transpose();
        let view = options.view.filter(|view| *view != View::Difference);
        Ok(Self {
            out: open(options.out.clone())?,
            difference: neighbour("difference")?,
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
        let bytes = encoded(size.width(), pixels).map_err(|cause| Error::File { path: self.path, cause })?;
        Ok(self.output.fill(|file| file.write_all(&bytes))?)
    }
}

/// A PNG of rows of `width` pixels.
///
/// # Errors
/// It has more rows or columns than a PNG may have.
pub fn encoded(width: usize, pixels: &[[u8; 3]]) -> std::io::Result<Vec<u8>> {
    let side = |pixels: usize| u32::try_from(pixels).map_err(std::io::Error::other);
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, side(width)?, side(pixels.len() / width.max(1))?);
    encoder.set_color(png::ColorType::Rgb);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(pixels.as_flattened())?;
    writer.finish()?;
    Ok(bytes)
}

/// Whether other pictures may be written beside `out`: not where it is a device or a pipe.
fn takes_neighbours(out: &Path) -> bool {
    let is_of_the_system = ["/dev", "/proc"].iter().any(|folder| out.starts_with(folder));
    !is_of_the_system && out.metadata().map_or(true, |metadata| metadata.is_file())
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_stand_beside_the_picture() {
        assert_eq!(beside(Path::new("a/out.png"), "difference"), Path::new("a/out-difference.png"));
    }

    #[test]
    fn nothing_is_written_beside_devices() {
        assert!(takes_neighbours(Path::new("new.png")));
        assert!(!takes_neighbours(Path::new("/dev/null")) && !takes_neighbours(Path::new("/dev/stdout")));
    }

    #[test]
    fn bytes_are_the_renderers() {
        assert_eq!(bytes(&[Vec3::new(0.0, 0.25, 1.0_f32)], 2.0), [[0, 127, 255]]);
    }
}
