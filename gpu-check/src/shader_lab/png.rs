//! Pictures as PNG files, replaced only when complete: whoever looks at one never sees half of it.

use std::io::Write;
use std::path::{Path, PathBuf};

use annotate::Canvas;
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
    write_pixels(path, size.width(), pixels)
}

/// Writes a canvas.
///
/// # Errors
/// [`Error::File`].
pub fn write_canvas(path: &Path, canvas: &Canvas) -> Result<(), Error> {
    write_pixels(path, canvas.width, &canvas.pixels)
}

/// The file of a picture: PNG where its name says so, else PPM.
fn encoded(path: &Path, width: usize, pixels: &[[u8; 3]]) -> Result<Vec<u8>, png::EncodingError> {
    let height = pixels.len() / width;
    if !is_png(path) {
        let head = format!("P6\n{width} {height}\n255\n");
        return Ok([head.as_bytes(), pixels.as_flattened()].concat());
    }
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, width as u32, height as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.write_header().and_then(|mut writer| writer.write_image_data(pixels.as_flattened()))?;
    Ok(file)
}

fn is_png(path: &Path) -> bool {
    path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("png"))
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

fn write_pixels(path: &Path, width: usize, pixels: &[[u8; 3]]) -> Result<(), Error> {
    let failed = |cause| Error::File { path: path.to_owned(), cause };
    let file = encoded(path, width, pixels).map_err(|error| failed(std::io::Error::other(error)))?;
    if path == Path::new("-") {
        return std::io::stdout().write_all(&file).map_err(failed);
    }
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
