//! The real renderer: pixels in order, a span of a row at a time.
//!
//! A span's primary rays need no material's random numbers, so they are drawn, intersected and shaded ahead, several at
//! once ([`primary`], [`glass`]), up to the first matte or metal surface. What follows there takes its random vectors
//! from one stream in the order of the samples and is walked one ray after the other ([`walk`]). Where rays leave the
//! scene, their background is computed several at once again ([`ends`]), and the samples are summed in order
//! ([`pixels`]).

mod batch;
mod ends;
mod glass;
mod pixels;
mod primary;
mod shade;
mod span;
mod vectors;
mod walk;

use std::ops::ControlFlow;

use crate::config::Config;
use crate::error::Error;
use crate::image::{Image, Rgb};
use crate::layout::Layout;
use crate::prepare::Prepared;
use crate::rng::BlockUniform;
use crate::scatter::Scatter;
use crate::scene::Scene;
use crate::simd::{InstructionSet, Kernel, Simd};
use crate::vec3::Vec3;

use batch::Batch;
use pixels::Sums;
use span::{Candidates, Spans};
use walk::Walk;

/// Renders `scene` as `config` asks, in the layout `L`, with the instruction set that this machine offers.
///
/// # Errors
/// [`Error::Picture`] when the configuration makes no picture, [`Error::OutOfMemory`] when it does not fit.
pub fn render<L: Layout>(config: &Config, scene: &Scene, scatter: Scatter) -> Result<L::Image, Error> {
    render_with::<L>(&Prepared::new(config, scene, scatter)?, InstructionSet::chosen())
}

/// Renders what was prepared, with a given instruction set.
///
/// # Errors
/// [`Error::OutOfMemory`] when the picture does not fit.
pub fn render_with<L: Layout>(prepared: &Prepared<L>, set: InstructionSet) -> Result<L::Image, Error> {
    let mut image = L::Image::black(prepared.size)?;
    // Nobody stops this one.
    let _ = render_into(prepared, set, &mut image, |_| ControlFlow::Continue(()));
    Ok(image)
}

/// Renders what was prepared into an image of its size, and calls `after_row` with the number of rows that are done; the
/// rendering stops where it breaks off, with the rows done so far in the image.
pub fn render_into<L: Layout>(
    prepared: &Prepared<L>,
    set: InstructionSet,
    image: &mut L::Image,
    after_row: impl FnMut(usize) -> ControlFlow<()>,
) -> ControlFlow<()> {
    let quantizer = &prepared.quantizer;
    let pixel = |index: usize, mean: Vec3| {
        let [red, green, blue] = mean.to_array().map(|channel| quantizer.quantize(channel));
        image.set_pixel(index, Rgb { red, green, blue });
    };
    set.run(Picture { prepared, pixel, after_row })
}

/// Renders what was prepared and hands every pixel's mean, before it becomes bytes, to `pixel` with its index.
pub fn render_linear<L: Layout>(prepared: &Prepared<L>, set: InstructionSet, pixel: impl FnMut(usize, Vec3)) {
    // Nobody stops this one.
    let _ = set.run(Picture { prepared, pixel, after_row: |_| ControlFlow::Continue(()) });
}

/// The whole picture, every pixel's mean handed to `pixel` with its index.
struct Picture<'a, L: Layout, P, R> {
    prepared: &'a Prepared<L>,
    pixel: P,
    after_row: R,
}

impl<L: Layout, P: FnMut(usize, Vec3), R: FnMut(usize) -> ControlFlow<()>> Kernel for Picture<'_, L, P, R> {
    type Output = ControlFlow<()>;

    #[inline(always)]
    fn call<S: Simd>(self, simd: S) -> ControlFlow<()> {
        let Self { prepared, mut pixel, mut after_row } = self;
        let mut offsets = BlockUniform::new(prepared.ray_seed);
        let mut batch = Batch::new();
        let mut walk = Walk::new(prepared);
        let mut candidates = Candidates::new(prepared);
        let mut sums = Sums::new(prepared.samples);
        for row in 0..prepared.size.height() {
            candidates.begin_row(prepared, row);
            for span in Spans::of_row(prepared.size.width(), prepared.samples) {
                candidates.narrow(prepared, row, &span);
                simd.run(batch::Draw { prepared, span: &span, offsets: &mut offsets, batch: &mut batch });
                simd.run(primary::Trace { prepared, row, candidates: &candidates, batch: &mut batch });
                simd.run(glass::Trace { prepared, batch: &mut batch });
                simd.run(walk::Follow { prepared, walk: &mut walk, batch: &mut batch });
                simd.run(ends::Color { prepared, ended: &mut walk.ended, batch: &mut batch });
                sums.add(&span, &batch, |column, mean| pixel(row * prepared.size.width() + column, mean));
            }
            after_row(row + 1)?;
        }
        ControlFlow::Continue(())
    }
}
