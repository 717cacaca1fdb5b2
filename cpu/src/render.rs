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
    let quantizer = &prepared.quantizer;
    set.run(Picture {
        prepared,
        pixel: |index: usize, mean: Vec3| {
            let [red, green, blue] = mean.to_array().map(|channel| quantizer.quantize(channel));
            image.set_pixel(index, Rgb { red, green, blue });
        },
    });
    Ok(image)
}

/// The whole picture, every pixel's mean handed to `pixel` with its index.
struct Picture<'a, L: Layout, P> {
    prepared: &'a Prepared<L>,
    pixel: P,
}

impl<L: Layout, P: FnMut(usize, Vec3)> Kernel for Picture<'_, L, P> {
    type Output = ();

    #[inline(always)]
    fn call<S: Simd>(self) {
        let Self { prepared, mut pixel } = self;
        let mut offsets = BlockUniform::new(prepared.ray_seed);
        let mut batch = Batch::new();
        let mut walk = Walk::new(prepared);
        let mut candidates = Candidates::new(prepared);
        let mut sums = Sums::new(prepared.samples);
        for row in 0..prepared.size.height() {
            candidates.begin_row(prepared, row);
            for span in Spans::of_row(prepared.size.width(), prepared.samples) {
                candidates.narrow(prepared, row, &span);
                batch.draw(prepared, &span, &mut offsets);
                primary::trace::<S, L>(prepared, row, &candidates, &mut batch);
                glass::trace::<S, L>(prepared, &mut batch);
                walk.follow::<S, L>(prepared, &mut batch);
                ends::color::<S, L>(prepared, &mut walk.ended, &mut batch);
                sums.add(&span, &batch, |column, mean| pixel(row * prepared.size.width() + column, mean));
            }
        }
    }
}
