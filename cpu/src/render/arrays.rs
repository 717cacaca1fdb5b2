//! Arrays with one number for each sample of a span.

use crate::render::lane_numbers::SampleIndex;

/// Maximum number of samples in a [span](crate::render::span::Span). A span has the samples of up to 32 neighbouring
/// pixels of a row, or a part of the samples of one pixel.
pub const CAPACITY: usize = 1024;

/// Length of an array: one number for each sample, and 16 more, because the last lanes may lie beyond the last sample.
pub const ROOM: usize = CAPACITY + 16;

/// An array with one number for each sample.
pub type Values = [f64; ROOM];

/// The [`SampleIndex`] of each sample in its span.
pub const SAMPLES: Values = {
    let mut samples = [0.0; ROOM];
    let mut at = 0;
    while at < ROOM {
        samples[at] = SampleIndex::new(at).0;
        at += 1;
    }
    samples
};
