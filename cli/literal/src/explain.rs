//! The life of a pixel, as the statement tells it: each random number with its place in its stream, each ray, each
//! lambda, what the surface does, the colour, the mean and the bytes.

use std::ops::ControlFlow;

use cpu::internals::image::quantize::{quantize, scaled};
use cpu::internals::{InstructionSet, Limits, Prepared, render_from};
use cpu::{Aos, Config, Error, Image, Layout, Scatter, Scene};
use serde_json::{Value, json};

use crate::renderer::Renderer;
use crate::rules::Rules;

/// A picture whose pixels can be explained.
#[derive(Debug)]
pub struct Walk<'a> {
    config: &'a Config,
    scene: &'a Scene,
    scatter: Scatter,
    /// The picture.
    pub image: <Aos as Layout>::Image,
    /// The numbers of random vectors that were drawn before each row, or `None` if the real renderer draws none.
    vectors: Option<Vec<u64>>,
}

impl<'a> Walk<'a> {
    /// Renders the picture.
    ///
    /// # Errors
    /// The errors of [`cpu::render()`].
    pub fn new(config: &'a Config, scene: &'a Scene, scatter: Scatter) -> Result<Self, Error> {
        let prepared = Prepared::<Aos>::new(config, scene, scatter)?;
        let mut image = <Aos as Layout>::Image::black(prepared.size)?;
        let (mut vectors, set, limits) = (vec![0], InstructionSet::chosen(), Limits::default());
        let _ = render_from(&prepared, set, &limits, (0, &[]), &mut image, |_, _, streams| {
            vectors.push(streams.scatter_samples());
            ControlFlow::Continue(())
        })?;
        let is_drawn = prepared.scatter_stream == scatter;
        Ok(Self { config, scene, scatter, image, vectors: is_drawn.then_some(vectors) })
    }

    /// Returns the life of the pixel in this column and row: the events of each sample, the mean and the bytes. The
    /// result is `None` if there is no such pixel.
    ///
    /// An event `sample`, `ray`, `candidate`, `hit` or `end` has the values of its step. `place` is the number of
    /// random numbers of a stream before those of the event.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`] if memory is short.
    pub fn explain(&self, [column, row]: [usize; 2]) -> Result<Option<Value>, Error> {
        let size = self.image.size();
        if column >= size.width() || row >= size.height() {
            return Ok(None);
        }
        let mut renderer = Renderer::new(self.config, self.scene, self.scatter, Rules::default())?;
        // Without the numbers of vectors, all pixels before are traced.
        let first_row = if self.vectors.is_some() { row } else { 0 };
        renderer.skip(first_row, self.vectors.as_ref().map_or(0, |vectors| vectors[row]));
        for place in first_row * size.width()..row * size.width() + column {
            let _ = renderer.mean([place / size.width(), place % size.width()])?;
        }
        renderer.told = Some(Vec::new());
        let (mean, gamma) = (renderer.mean([row, column])?.to_array(), self.config.gamma);
        let pixel = self.image.pixel(row * size.width() + column);
        Ok(Some(json!({
            "pixel": [column, row], "size": [size.width(), size.height()], "objects": self.scene.objects.len(),
            "samples": renderer.told, "mean": mean, "gamma": gamma, "scaled": mean.map(|mean| scaled(mean, gamma)),
            "bytes": mean.map(|mean| quantize(mean, gamma)), "picture": [pixel.red, pixel.green, pixel.blue],
        })))
    }
}
