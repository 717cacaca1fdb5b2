//! Renders the programs' real pictures on a device: with random positions in the pixels, and random scatter vectors.
//!
//! All paths of a picture share one stream of random numbers, so a path starts where the path before it has ended.
//! [`Recording`] is a picture by the reference, with the number of words that each path took from this stream. With
//! these numbers [`SampleRenderer`] traces any paths at once. It counts the words that each path takes on the device.
//! If all counts are the recorded ones, every path has started at its true place: the first path starts at 0, and each
//! other one where its predecessor has ended on the device. So a wrong recording cannot go unnoticed.
//!
//! Data go one way: [`Recording`], [`streams`] (the words of one run), [`renderer`] (two kernels for each run). In f32
//! paths take other words, and [`twin`] is the picture that a device should give.

pub mod recording;
pub mod renderer;
pub mod streams;
pub mod twin;

pub use recording::{Convention, Recording};
pub use renderer::{SampleRenderer, SampledRendering};
