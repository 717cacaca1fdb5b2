//! Reads and writes PNG.

use std::io::{self, BufRead, Seek, Write};

use super::{DEFLATE_GROWTH, Picture, check_pixels, spare, with_room};

/// Largest size in bytes of a chunk beside the pixels, such as a palette.
const MOST_BESIDE: usize = 1 << 20;

/// Number of bytes of the compressed picture that are written at once.
const PIECE: usize = 1 << 16;

impl Picture {
    /// Writes the picture to `out` in the format PNG.
    ///
    /// # Errors
    /// An error of `out`.
    pub fn write_png(&self, out: impl Write) -> io::Result<()> {
        // The encoder keeps a few rows.
        spare(16 * self.width).map_err(io::Error::other)?;
        let mut writer = encoder(out, [self.width, self.height])?.write_header()?;
        // Writes pieces of [`PIECE`] bytes, so that the whole compressed picture is never in memory.
        let mut stream = writer.stream_writer_with_size(PIECE)?;
        stream.write_all(self.pixels.as_flattened())?;
        stream.finish()?;
        Ok(writer.finish()?)
    }
}

/// Returns an encoder for a PNG of this width and height, with three channels of 8 bits.
///
/// # Errors
/// An error if the picture is too large for a PNG.
pub fn encoder<'a, W: Write + 'a>(out: W, size: [usize; 2]) -> io::Result<png::Encoder<'a, W>> {
    let [width, height] = size.map(|pixels| u32::try_from(pixels).map_err(io::Error::other));
    let mut encoder = png::Encoder::new(out, width?, height?);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    Ok(encoder)
}

/// Reads the picture in a PNG file of `length` bytes. Adds what the picture leaves out to `notes`.
pub(super) fn decode(source: impl BufRead + Seek, length: u64, notes: &mut Vec<String>) -> Result<Picture, String> {
    let text = |error: png::DecodingError| error.to_string();
    let mut decoder = png::Decoder::new_with_limits(source, png::Limits { bytes: MOST_BESIDE });
    decoder.set_transformations(png::Transformations::EXPAND);
    decoder.set_ignore_text_chunk(true);
    decoder.set_ignore_iccp_chunk(true);
    let mut reader = decoder.read_info().map_err(text)?;
    // The size is checked before memory is allocated for the pixels, because a few bytes can announce a picture of any
    // size.
    let (info, line) = (reader.info(), reader.output_line_size(reader.info().width).ok_or("too large a PNG")?);
    let (width, height, is_interlaced) = (info.width as usize, info.height as usize, info.interlaced);
    let count = check_pixels(width.checked_mul(height))?;
    let announced = info.raw_bytes();
    if announced as u64 > length.saturating_mul(DEFLATE_GROWTH) {
        return Err(format!("a PNG that announces {announced} bytes of pixels and cannot hold them"));
    }
    // png 0.18.1 panics on a palette whose length is no multiple of 3.
    if info.palette.as_ref().is_some_and(|palette| palette.len() % 3 != 0) {
        return Err("a PNG whose palette ends within a colour".to_owned());
    }
    if let Some(animation) = info.animation_control {
        notes.push(format!("of an animation of {} frames only the still picture is taken", animation.num_frames));
    }
    let (color, depth) = reader.output_color_type();
    let mut rows = Rows {
        samples: color.samples(),
        bytes: if depth == png::BitDepth::Sixteen { 2 } else { 1 },
        pixels: with_room(count)?,
        transparent: 0,
        is_rounded: false,
    };
    // The decoder keeps a few rows. Those of an interlaced picture come in seven passes, so all are kept.
    let kept = if is_interlaced { line.saturating_mul(height) } else { line };
    spare(line.saturating_mul(8))?;
    let mut buffer = with_room(kept)?;
    buffer.resize(kept, 0);
    if is_interlaced {
        reader.next_frame(&mut buffer).map_err(text)?;
        rows.take(&buffer);
    } else {
        for _ in 0..height {
            reader.read_row(&mut buffer).map_err(text)?.ok_or("a PNG that ends before its last row")?;
            rows.take(&buffer);
        }
        // The checksum behind the last row is read too.
        reader.read_row(&mut buffer).map_err(text)?;
    }
    if rows.transparent > 0 {
        let transparent = rows.transparent;
        notes.push(format!(
            "{transparent} of its {count} pixels are not opaque; alpha is left out, their colours count"
        ));
    }
    if rows.is_rounded {
        notes.push("its 16 bits a channel are rounded to 8".to_owned());
    }
    Ok(Picture { width, height, pixels: rows.pixels })
}

/// Collects the pixels of rows.
struct Rows {
    /// Number of channels: grey, grey and alpha, three colours, three colours and alpha.
    samples: usize,
    /// Number of bytes of a channel, of which the first is the largest part.
    bytes: usize,
    pixels: Vec<[u8; 3]>,
    /// Number of pixels with an alpha below the largest.
    transparent: usize,
    /// Whether a channel of 16 bits is not exactly one of 8 bits.
    is_rounded: bool,
}

impl Rows {
    fn take(&mut self, rows: &[u8]) {
        let Self { samples, bytes, transparent, is_rounded, pixels } = self;
        let (samples, bytes) = (*samples, *bytes);
        pixels.extend(rows.chunks_exact(samples * bytes).map(|pixel| {
            let mut byte = |channel: usize| match pixel[channel * bytes..][..bytes] {
                [high, low] => {
                    let value = u32::from(u16::from_be_bytes([high, low]));
                    *is_rounded |= high != low;
                    ((value * 255 + 32_767) / 65_535) as u8
                }
                [byte, ..] => byte,
                [] => 0,
            };
            let color = if samples < 3 { [byte(0); 3] } else { [byte(0), byte(1), byte(2)] };
            let alpha = &pixel[(samples - 1) * bytes..];
            *transparent += usize::from(samples % 2 == 0 && alpha.iter().any(|&byte| byte < 255));
            color
        }));
    }
}
