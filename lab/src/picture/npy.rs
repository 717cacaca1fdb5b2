//! Reads and writes NPY, the arrays of NumPy.

use std::io::{self, BufRead, Write};

use exr::prelude::f16;

use super::floats::{Floats, fill, write_row};
use super::{Picture, check_pixels, with_room};

/// Length of an NPY file before its header: the magic bytes, the version and the length of the header.
const START: usize = 10;
/// Largest length of a header that is read.
const MOST_HEADER: u64 = 1 << 16;
/// Largest number of characters of a field of the header that a message shows.
const SHOWN: usize = 60;

pub(super) fn write(floats: &Floats, mut out: impl Write) -> io::Result<()> {
    let channels = if floats.channels == 3 { ", 3" } else { "" };
    let shape = format!("({}, {}{channels})", floats.height, floats.width);
    let header = format!("{{'descr': '<f4', 'fortran_order': False, 'shape': {shape}, }}");
    // The header ends in LF, and the numbers start at a multiple of 64.
    let length = (START + header.len() + 1).next_multiple_of(64) - START;
    out.write_all(b"\x93NUMPY\x01\0")?;
    out.write_all(&(length as u16).to_le_bytes())?;
    writeln!(out, "{header:<0$}", length - 1)?;
    floats.values.chunks_exact(floats.width * floats.channels).try_for_each(|row| write_row(row, &mut out))
}

/// A picture in an array.
pub(super) enum Array {
    Bytes(Picture),
    Numbers(Floats),
}

/// What the header of an array says.
struct Header {
    /// Size of a number in bytes, and whether it is a byte from 0 to 255 and not a floating-point number.
    size: usize,
    is_byte: bool,
    is_little: bool,
    width: usize,
    height: usize,
    /// Number of channels: 1, 3, or 4 with alpha.
    channels: usize,
}

/// Reads the picture in an NPY file of `length` bytes: an array of u1, f2, f4 or f8 with the shape (height, width), or
/// with a third side of 1, 3 or 4. Adds what the picture leaves out to `notes`.
pub(super) fn decode(mut source: impl BufRead, length: u64, notes: &mut Vec<String>) -> Result<Array, String> {
    const CUT: &str = "an NPY that ends in its header";
    let mut start = [0; START + 2];
    source.read_exact(&mut start[..START]).map_err(|_| CUT)?;
    let (before, header) = match start[6] {
        1 => (START, u64::from(u16::from_le_bytes([start[8], start[9]]))),
        2 | 3 => {
            source.read_exact(&mut start[START..]).map_err(|_| CUT)?;
            (START + 2, u64::from(u32::from_le_bytes([start[8], start[9], start[10], start[11]])))
        }
        version => return Err(format!("an NPY of version {version}; versions 1 to 3 are read")),
    };
    if header > MOST_HEADER {
        return Err(format!("an NPY with a header of {header} bytes; at most {MOST_HEADER} are read"));
    }
    let mut text = vec![0; header as usize];
    source.read_exact(&mut text).map_err(|_| CUT)?;
    let Header { size, is_byte, is_little, width, height, channels } = Header::parse(&String::from_utf8_lossy(&text))?;
    let count = check_pixels(width.checked_mul(height))?;
    let (wanted, found) = ((count * channels * size) as u64, length.saturating_sub(before as u64 + header));
    if found != wanted {
        let cause = if found > wanted { "more than one array, or something else, follows" } else { "it is cut off" };
        return Err(format!("{found} bytes of numbers where the array's shape needs {wanted}: {cause}"));
    }
    let number = |bytes: &[u8]| {
        let mut number: [u8; 8] = std::array::from_fn(|at| bytes.get(at).copied().unwrap_or(0));
        if !is_little {
            number[..size].reverse();
        }
        let [a, b, c, d, ..] = number;
        match size {
            1 => f32::from(a),
            2 => f16::from_le_bytes([a, b]).to_f32(),
            4 => f32::from_le_bytes([a, b, c, d]),
            _ => f64::from_le_bytes(number) as f32,
        }
    };
    let (mut row, opaque) = (with_room(width * channels)?, if is_byte { 255.0 } else { 1.0 });
    row.resize(width * channels, 0.0);
    let colors = channels.min(3);
    let mut bytes = with_room(if is_byte { count } else { 0 })?;
    let mut values = with_room(if is_byte { 0 } else { count * colors })?;
    let mut transparent = 0;
    for _ in 0..height {
        fill(&mut source, &mut row, size, number)?;
        transparent += row.chunks_exact(channels).filter(|pixel| channels == 4 && pixel[3] != opaque).count();
        for pixel in row.chunks_exact(channels) {
            if is_byte {
                bytes.push([0, 1, 2].map(|channel| pixel[channel.min(colors - 1)] as u8));
            } else {
                values.extend_from_slice(&pixel[..colors]);
            }
        }
    }
    if transparent > 0 {
        notes.push(format!(
            "{transparent} of its {count} pixels are not opaque; alpha is left out, their colours count"
        ));
    }
    if is_byte {
        return Ok(Array::Bytes(Picture { width, height, pixels: bytes }));
    }
    Ok(Array::Numbers(Floats { width, height, channels: colors, values, is_depth: false }))
}

impl Header {
    /// Returns what the header says, or the cause why the array is no picture, with a remedy.
    fn parse(header: &str) -> Result<Self, String> {
        let field = |name: &str| {
            let rest = header.split_once(name)?.1.trim_start().strip_prefix(':')?.trim_start();
            Some(rest)
        };
        let damaged = |name: &str| format!("an NPY whose header has no {name}; save the array again by numpy.save");
        let kind = field("'descr'").ok_or_else(|| damaged("'descr'"))?;
        let order = field("'fortran_order'").ok_or_else(|| damaged("'fortran_order'"))?;
        let shape = field("'shape'").and_then(|rest| rest.strip_prefix('(')?.split_once(')'));
        let shape = shape.ok_or_else(|| damaged("'shape'"))?.0;
        let name = kind.strip_prefix('\'').and_then(|rest| rest.split_once('\'')).map(|(name, _)| name);
        let (is_little, kind) = match name.and_then(|name| Some((name.chars().next()?, name))) {
            Some((order @ ('<' | '>' | '|' | '='), name)) => (order != '>', &name[1..]),
            Some((_, name)) => (true, name),
            None => {
                let kind: String = kind.chars().take(SHOWN).collect();
                return Err(format!("an NPY of records, {kind}; save one of its fields, array['name']"));
            }
        };
        let (size, is_byte) = match kind {
            "u1" => (1, true),
            "f2" => (2, false),
            "f4" => (4, false),
            "f8" => (8, false),
            other => {
                let other: String = other.chars().take(SHOWN).collect();
                return Err(format!(
                    "an NPY of the type {other}, and u1, f2, f4 or f8 is needed; save array.astype('u1') for bytes, or \
                     array.astype('f4') for numbers"
                ));
            }
        };
        if !order.starts_with("False") {
            return Err("an NPY in Fortran's order; save numpy.ascontiguousarray(...) instead".to_owned());
        }
        let wrong = || {
            let shown: String = shape.chars().take(SHOWN).collect();
            let remedy = match shape.split(',').next().map(str::trim) {
                Some("1" | "3" | "4") => "; put the channels last by numpy.moveaxis(array, 0, -1)",
                _ => "",
            };
            format!("an NPY of the shape ({shown}); (height, width), and a third side of 1, 3 or 4, are needed{remedy}")
        };
        // Python 2 wrote an L behind large numbers.
        let sides = shape.split(',').map(|side| side.trim().trim_end_matches('L')).filter(|side| !side.is_empty());
        let sides: Vec<usize> = sides.map(str::parse).collect::<Result<_, _>>().map_err(|_| wrong())?;
        let (width, height, channels) = match sides[..] {
            [height, width] => (width, height, 1),
            [height, width, channels @ (1 | 3 | 4)] => (width, height, channels),
            _ => return Err(wrong()),
        };
        if width == 0 || height == 0 {
            return Err(format!("an NPY without pixels, of the shape ({shape})"));
        }
        Ok(Self { size, is_byte, is_little, width, height, channels })
    }
}
