//! Pictures as PNG files, replaced only when complete: whoever looks at one never sees half of it.

use std::path::{Path, PathBuf};

use cpu::Vec3;
use cpu::image::Size;
use cpu::quantize::quantize;

use crate::{Error, Float};

/// `out` with `-suffix` before its ending.
#[must_use]
pub fn beside(out: &Path, suffix: &str) -> PathBuf {
    let stem = out.file_stem().unwrap_or_default().to_string_lossy();
    out.with_file_name(format!("{stem}-{suffix}.png"))
}

/// Linear colours as the bytes that the renderer would make of them.
#[must_use]
pub fn bytes<T: Float>(pixels: &[Vec3<T>], gamma: f64) -> Vec<[u8; 3]> {
    pixels.iter().map(|color| color.to_array().map(|channel| quantize(channel.wide(), gamma))).collect()
}

/// Writes a picture of `size`, or of several such below each other.
///
/// # Errors
/// [`Error::File`].
pub fn write(path: &Path, size: Size, pixels: &[[u8; 3]]) -> Result<(), Error> {
    let failed = |cause| Error::File { path: path.to_owned(), cause };
    let height = pixels.len() / size.width();
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, size.width() as u32, height as u32);
    encoder.set_color(png::ColorType::Rgb);
    let written = encoder.write_header().and_then(|mut writer| writer.write_image_data(pixels.as_flattened()));
    written.map_err(|error| failed(std::io::Error::other(error)))?;
    let unfinished = path.with_extension("png.unfinished");
    std::fs::write(&unfinished, file).and_then(|()| std::fs::rename(&unfinished, path)).map_err(failed)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_stand_beside_the_picture() {
        assert_eq!(beside(Path::new("a/out.png"), "difference"), Path::new("a/out-difference.png"));
    }

    #[test]
    fn bytes_are_the_renderers() {
        assert_eq!(bytes(&[Vec3::new(0.0, 0.25, 1.0_f32)], 2.0), [[0, 127, 255]]);
    }
}
