//! Writes an EXR file as every reader takes it: scan lines with ZIP, in memory only a block at a time.

use std::io::{self, Seek, SeekFrom, Write};

use exr::block::UncompressedBlock;
use exr::block::writer::ChunksWriter;
use exr::meta::BlockDescription;
use exr::meta::header::{Header, LayerAttributes};
use exr::prelude::{ChannelDescription, Compression, LineOrder, SampleType};

use super::block_bytes;
use crate::picture::floats::Floats;
use crate::picture::spare;

/// Writes the picture with the channels R, G and B, or with one channel: Z for depths, else Y.
///
/// A table of the blocks' places stands before the blocks, and their lengths are known when they are compressed. So all
/// blocks are compressed twice: first for the table, and then to be written.
pub(in crate::picture) fn write(floats: &Floats, out: impl Write) -> io::Result<()> {
    let names = match floats.channels {
        3 => &[("B", 2), ("G", 1), ("R", 0)][..],
        _ if floats.is_depth => &[("Z", 0)],
        _ => &[("Y", 0)],
    };
    let channels = names.iter().map(|(name, _)| ChannelDescription::named(*name, SampleType::F32)).collect();
    let header = Header::new("".into(), (floats.width, floats.height), channels)
        .with_encoding(Compression::ZIP16, BlockDescription::ScanLines, LineOrder::Increasing)
        .with_attributes(LayerAttributes::default());
    spare(4 * block_bytes(&header)).map_err(io::Error::other)?;
    let mut known = (0, Vec::new());
    for out in [&mut io::sink() as &mut dyn Write, &mut { out }] {
        let mut sink = Ordered { out, at: 0, table_at: known.0, table: known.1, is_in_table: false };
        exr::block::write(&mut sink, [header.clone()].into_iter().collect(), true, |meta, writer| {
            let mut compressor = writer.sequential_blocks_compressor(&meta);
            for (index, place) in exr::block::enumerate_ordered_header_block_indices(&meta.headers) {
                let block = UncompressedBlock::from_lines(&meta.headers[0].channels, place, |line| {
                    let row = &floats.values[line.location.position.y() * floats.width * floats.channels..];
                    let values = row.iter().skip(names[line.location.channel].1).step_by(floats.channels);
                    let samples = line.value.as_chunks_mut().0.iter_mut();
                    samples.zip(values).for_each(|(bytes, value)| *bytes = value.to_ne_bytes());
                });
                compressor.compress_block(index, block)?;
            }
            Ok(())
        })
        .map_err(io::Error::other)?;
        known = (sink.table_at, sink.table);
    }
    Ok(())
}

/// Takes a file whose table is written after all else, and writes it from its start to its end, with a table that is
/// known. Collects the table for the next time.
struct Ordered<'a> {
    out: &'a mut dyn Write,
    at: u64,
    /// Where the table begins, and its bytes.
    table_at: u64,
    table: Vec<u8>,
    /// Whether the table is being written.
    is_in_table: bool,
}

impl Write for Ordered<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if self.is_in_table {
            self.table.extend_from_slice(bytes);
            return Ok(bytes.len());
        }
        // The place of the table has zeros at first.
        let end = self.at + bytes.len() as u64;
        let [first, last] = [self.table_at, self.table_at + self.table.len() as u64].map(|at| at.clamp(self.at, end));
        let part = |at: u64| (at - self.at) as usize;
        self.out.write_all(&bytes[..part(first)])?;
        if first < last {
            let of_table = |at: u64| (at - self.table_at) as usize;
            self.out.write_all(&self.table[of_table(first)..of_table(last)])?;
        }
        self.out.write_all(&bytes[part(last)..])?;
        self.at = end;
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        self.out.flush()
    }
}

impl Seek for Ordered<'_> {
    fn seek(&mut self, place: SeekFrom) -> io::Result<u64> {
        let SeekFrom::Start(place) = place else { return Err(io::ErrorKind::Unsupported.into()) };
        self.is_in_table = true;
        self.table_at = place;
        self.table.clear();
        Ok(place)
    }
}
