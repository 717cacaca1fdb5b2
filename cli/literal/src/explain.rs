//! The life of a pixel, as the statement tells it: each random number with its place in its stream, each ray, each
//! lambda, what the surface does, the colour, the mean and the bytes.

use std::ops::ControlFlow;

use cpu::internals::image::quantize::{channel_level, quantize};
use cpu::internals::{InstructionSet, Limits, Prepared, render_from};
use cpu::{Aos, Config, Error, Image, Layout, Scatter, Scene, Vec3};
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

    /// Returns [`life`] of the pixel in this column and row, with its bytes in the picture as `picture`.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`] if memory is short.
    pub fn explain(&self, [column, row]: [usize; 2]) -> Result<Option<Value>, Error> {
        let vectors = self.vectors.as_ref().and_then(|vectors| vectors.get(row)).copied();
        let mut life = life(self.config, self.scene, self.scatter, vectors, [column, row])?;
        if let Some(life) = &mut life {
            let pixel = self.image.pixel(row * self.image.size().width() + column);
            life["picture"] = json!([pixel.red, pixel.green, pixel.blue]);
        }
        Ok(life)
    }
}

/// Returns the life of the pixel in this column and row: the events of each sample, the mean and the bytes. The result
/// is `None` if there is no such pixel.
///
/// An event `sample`, `ray`, `candidate`, `hit` or `end` has the values of its step. `place` is the number of random
/// numbers of a stream before those of the event. A `candidate` without a lambda has `null`; a sphere or a side with a
/// negative discriminant has none. `count` is the number of samples, `window` the statement's O, dx and dy, and
/// `background` the light and the dark colour.
///
/// `vectors` is the number of random vectors that surfaces take before the pixel's row. Without it, all pixels before
/// are traced.
///
/// # Errors
/// [`Error::OutOfMemory`] if memory is short, or [`Error::Picture`] if the picture is too large.
pub fn life(
    config: &Config,
    scene: &Scene,
    scatter: Scatter,
    vectors: Option<u64>,
    [column, row]: [usize; 2],
) -> Result<Option<Value>, Error> {
    let mut renderer = Renderer::new(config, scene, scatter, Rules::default())?;
    let [width, height] = [renderer.size.width(), renderer.size.height()];
    if column >= width || row >= height {
        return Ok(None);
    }
    let first_row = if vectors.is_some() { row } else { 0 };
    renderer.skip(first_row, vectors.unwrap_or(0));
    for place in first_row * width..row * width + column {
        let _ = renderer.mean([place / width, place % width])?;
    }
    renderer.told = Some(Vec::new());
    let camera = [renderer.camera.origin, renderer.camera.delta_x, renderer.camera.delta_y];
    let sky = [config.background_light_color, config.background_dark_color];
    let (mean, gamma) = (renderer.mean([row, column])?.to_array(), config.gamma);
    Ok(Some(json!({
        "pixel": [column, row], "size": [width, height], "objects": scene.objects.len(), "count": renderer.samples(),
        "window": camera.map(Vec3::to_array), "background": sky.map(Vec3::to_array),
        "samples": renderer.told, "mean": mean, "gamma": gamma, "scaled": mean.map(|mean| channel_level(mean, gamma)),
        "bytes": mean.map(|mean| quantize(mean, gamma)),
    })))
}
