//! Reads and writes OpenEXR files by the crate `exr`, block by block.

mod choose;
mod write;

use std::io::{BufRead, Seek};

use exr::block::UncompressedBlock;
use exr::meta::{BlockDescription, MetaData, header::Header};
use exr::prelude::{SampleType, Vec2, f16};

use super::floats::Floats;
use super::{DEFLATE_GROWTH, check_pixels, spare};
use choose::Choice;
pub(super) use write::write;

/// Largest size of a block of pixels in bytes, with all its channels.
const MOST_BLOCK: usize = 1 << 27;
/// Largest number of blocks of a part.
const MOST_BLOCKS: usize = 1 << 20;
/// Channels of whole numbers hold larger numbers than this, which `f32` rounds.
const MOST_WHOLE: u32 = 1 << 24;

/// Reads the picture in an EXR file of `length` bytes: that of the part or layer `wanted`, or the one with R, G and B.
/// Its size is that of the display window; where there are no data, it is black. Adds what the picture leaves out to
/// `notes`.
pub(super) fn decode(
    source: impl BufRead + Seek,
    length: u64,
    wanted: Option<&str>,
    notes: &mut Vec<String>,
) -> Result<Floats, String> {
    let text = |error: exr::error::Error| {
        format!("an EXR that cannot be read: {error}; save it with scan lines, without subsampling and deep data")
    };
    let reader = exr::block::read(source, false).map_err(text)?;
    let meta = MetaData { requirements: reader.meta_data().requirements, headers: reader.headers().into() };
    meta.headers.iter().try_for_each(|header| check(header, length))?;
    let choice = Choice::of(&meta.headers, wanted, notes)?;
    let header = &meta.headers[choice.part];
    let display = header.shared_attributes.display_window;
    let (width, height) = (display.size.width(), display.size.height());
    check_pixels(width.checked_mul(height))?;
    let mut floats = Floats::zeros(width, height, choice.channels.len())?;
    floats.is_depth = choice.is_depth;
    // The crate holds a block and its compressed bytes, and copies them.
    spare(4 * block_bytes(header) + header.max_block_byte_size().min(length as usize))?;
    let data = header.own_attributes.layer_position;
    let offset = [data.x() - display.position.x(), data.y() - display.position.y()].map(|at| at as isize);
    let size = header.layer_size;
    if offset != [0; 2] || (size.width(), size.height()) != (width, height) {
        notes.push(format!(
            "its data are {} x {} pixels from column {}, row {} of a picture of {width} x {height}; the rest is black",
            size.width(),
            size.height(),
            offset[0],
            offset[1]
        ));
    }
    let is_wanted =
        |_: &MetaData, _, block: exr::block::BlockIndex| block.layer == choice.part && block.level == Vec2(0, 0);
    let chunks = reader.filter_chunks(false, is_wanted).map_err(text)?;
    let (mut transparent, mut is_rounded, mut filled) = (0, false, 0);
    for chunk in chunks {
        let block = UncompressedBlock::decompress_chunk(chunk.map_err(text)?, &meta, false).map_err(text)?;
        if block.index.layer != choice.part || block.index.level != Vec2(0, 0) {
            return Err("an EXR whose table of blocks leads to another part".to_owned());
        }
        for line in block.lines(&header.channels) {
            let slot = choice.channels.iter().position(|&channel| channel == line.location.channel);
            let is_alpha = choice.alpha == Some(line.location.channel);
            let (Some(kind), true) = (header.channels.list.get(line.location.channel), slot.is_some() || is_alpha)
            else {
                continue;
            };
            let kind = kind.sample_type;
            let row = line.location.position.y() as isize + offset[1];
            let start = line.location.position.x() as isize + offset[0];
            for (value, column) in line.value.chunks_exact(kind.bytes_per_sample()).zip(start..) {
                let value = number(kind, value, &mut is_rounded);
                filled += usize::from(slot == Some(0));
                let is_inside = (0..width as isize).contains(&column) && (0..height as isize).contains(&row);
                transparent += usize::from(is_alpha && is_inside && value != 1.0);
                if let (Some(slot), true) = (slot, is_inside) {
                    floats.values[(row as usize * width + column as usize) * floats.channels + slot] = value;
                }
            }
        }
    }
    if filled != size.width() * size.height() {
        return Err("an EXR in which blocks are missing".to_owned());
    }
    if transparent > 0 {
        notes.push(format!("{transparent} of its pixels are not opaque; alpha is left out, their colours count"));
    }
    if is_rounded {
        notes.push(format!("whole numbers above {MOST_WHOLE} are rounded"));
    }
    Ok(floats)
}

fn number(kind: SampleType, bytes: &[u8], is_rounded: &mut bool) -> f32 {
    match (kind, bytes) {
        (SampleType::F16, &[a, b]) => f16::from_ne_bytes([a, b]).to_f32(),
        (SampleType::F32, &[a, b, c, d]) => f32::from_ne_bytes([a, b, c, d]),
        (SampleType::U32, &[a, b, c, d]) => {
            let number = u32::from_ne_bytes([a, b, c, d]);
            *is_rounded |= number > MOST_WHOLE;
            number as f32
        }
        _ => f32::NAN,
    }
}

/// Refuses a part that would take more memory than its file accounts for. A few bytes can announce a part of any size.
fn check(header: &Header, length: u64) -> Result<(), String> {
    let Vec2(width, height) = header.layer_size;
    let count = check_pixels(width.checked_mul(height))?;
    let announced = count.saturating_mul(header.channels.bytes_per_pixel);
    if announced as u64 > length.saturating_mul(DEFLATE_GROWTH) {
        return Err(format!("an EXR that announces {announced} bytes of pixels and cannot hold them"));
    }
    if header.chunk_count > MOST_BLOCKS {
        return Err(format!("an EXR of {} blocks; at most {MOST_BLOCKS} are read", header.chunk_count));
    }
    let size = block_bytes(header);
    if size > MOST_BLOCK {
        return Err(format!(
            "an EXR with blocks of {size} bytes; at most {MOST_BLOCK} are read: save it with smaller tiles, or scan lines"
        ));
    }
    Ok(())
}

/// Returns the size in bytes of the largest block of the part.
fn block_bytes(header: &Header) -> usize {
    let Vec2(width, height) = match header.blocks {
        BlockDescription::Tiles(tiles) => tiles.tile_size,
        BlockDescription::ScanLines => {
            let lines = header.compression.scan_lines_per_block().min(header.layer_size.height());
            Vec2(header.layer_size.width(), lines)
        }
    };
    width.saturating_mul(height).saturating_mul(header.channels.bytes_per_pixel)
}
