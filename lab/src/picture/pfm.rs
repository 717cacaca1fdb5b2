//! Reads and writes PFM.

use std::io::{self, BufRead, Write};

use super::floats::{Floats, fill, write_row};
use super::{LINE_ENDS, check_pixels};

const WRONG: &str = "a PFM whose header is damaged; it has PF or Pf, width and height, and a number whose sign is that \
                     of little-endian numbers (-1.0) or big-endian ones (1.0)";
const CR_LF: &str = "the header of this PFM ends in CR LF, as the text mode of Windows writes it, and one byte belongs \
                     there; write the file again in binary mode, with LF in the header";

pub(super) fn write(floats: &Floats, mut out: impl Write) -> io::Result<()> {
    let letter = if floats.channels == 3 { 'F' } else { 'f' };
    // The negative number stands for little-endian numbers. The last row comes first.
    write!(out, "P{letter}\n{} {}\n-1.0\n", floats.width, floats.height)?;
    floats.values.chunks_exact(floats.width * floats.channels).rev().try_for_each(|row| write_row(row, &mut out))
}

/// Reads the picture in a PFM file of `length` bytes.
pub(super) fn decode(mut source: impl BufRead, length: u64) -> Result<Floats, String> {
    let mut at = 0;
    let mut next = |source: &mut dyn BufRead| -> Result<u8, String> {
        let byte = *source.fill_buf().map_err(|error| error.to_string())?.first().ok_or(WRONG)?;
        source.consume(1);
        at += 1;
        Ok(byte)
    };
    let magic = [next(&mut source)?, next(&mut source)?];
    let (mut words, mut end) = ([const { String::new() }; 3], 0);
    for word in &mut words {
        loop {
            end = next(&mut source)?;
            match end.is_ascii_whitespace() {
                // One white-space byte ends each word, and the numbers follow that of the last one.
                true if word.is_empty() => {}
                true => break,
                false if word.len() < 32 => word.push(char::from(end)),
                false => return Err(WRONG.to_owned()),
            }
        }
    }
    let [width, height, scale] = &words;
    let (width, height): (usize, usize) = (width.parse().map_err(|_| WRONG)?, height.parse().map_err(|_| WRONG)?);
    // The sign of the scale tells the order of the bytes, so 0 and NaN have no meaning.
    let scale = scale.parse().ok().filter(|&scale: &f32| scale.abs() > 0.0).ok_or(WRONG)?;
    let channels = if magic[1] == b'F' { 3 } else { 1 };
    let wanted = 4 * (check_pixels(width.checked_mul(height))? * channels) as u64;
    let found = length.saturating_sub(at);
    if found > wanted && end == b'\r' && source.fill_buf().is_ok_and(|rest| rest.first() == Some(&b'\n')) {
        return Err(CR_LF.to_owned());
    }
    if wanted == 0 || found < wanted || found > wanted + 2 {
        return Err(format!("{found} bytes of numbers where {width} x {height} pixels need {wanted}"));
    }
    let mut floats = Floats::zeros(width, height, channels)?;
    let number = |bytes: &[u8]| {
        let bytes = bytes.try_into().unwrap_or_default();
        if scale < 0.0 { f32::from_le_bytes(bytes) } else { f32::from_be_bytes(bytes) }
    };
    for row in floats.values.chunks_exact_mut(width * channels).rev() {
        fill(&mut source, row, 4, number)?;
    }
    let mut tail = Vec::new();
    io::Read::read_to_end(&mut source, &mut tail).map_err(|error| error.to_string())?;
    if !LINE_ENDS.contains(&&tail[..]) {
        return Err(format!("{} bytes follow the numbers of its {width} x {height} pixels", tail.len()));
    }
    Ok(floats)
}
