//! Renders the picture of the two texts, and tells the caller about each row.

use std::ops::ControlFlow;

use cpu::internals::image::Image;
use cpu::internals::{InstructionSet, Limits, Prepared, render_from};
use cpu::{Error, Renderable, Scatter};

use crate::fault::Fault;
use crate::page;
use crate::state::State;

/// The words for the PPM file in the message about too little memory.
const FILE: &str = "the file of the picture";

/// Returns the picture of the two texts as a PPM file.
///
/// # Errors
/// The first fault of the texts, or too little memory.
pub fn file<L: Renderable>(state: &State, scatter: Scatter, set: InstructionSet) -> Result<Vec<u8>, Fault> {
    let (config, scene) = (state.config()?, state.scene()?);
    let prepared = Prepared::<L>::new(&config, &scene, scatter);
    prepared.and_then(|prepared| ppm(&prepared, set)).map_err(|error| Fault::without_line(error, 0))
}

fn ppm<L: Renderable>(prepared: &Prepared<L>, set: InstructionSet) -> Result<Vec<u8>, Error> {
    let (width, height) = (prepared.size.width(), prepared.size.height());
    let mut image = L::Image::black(prepared.size)?;
    let mut row = Vec::new();
    row.try_reserve_exact(4 * width).map_err(|_| Error::OutOfMemory { what: "the image" })?;
    page::begin(width, height);
    // A renderer that draws no vectors does not know how many the statement draws.
    let is_drawn = prepared.scatter_stream == prepared.scatter;
    // The result is always `None`: the caller ends a picture by ending the module.
    let _ = render_from(prepared, set, &Limits::default(), (0, &[]), &mut image, |rows, image, streams| {
        row.clear();
        for index in (rows - 1) * width..rows * width {
            let color = image.pixel(index);
            row.extend_from_slice(&[color.red, color.green, color.blue, 255]);
        }
        let vectors = if is_drawn { streams.scatter_samples() as f64 } else { f64::NAN };
        page::row(rows - 1, row.as_ptr(), vectors);
        ControlFlow::Continue(())
    })?;
    let short = || Error::OutOfMemory { what: FILE };
    let mut bytes = Vec::new();
    // A pixel has at most twelve bytes in the file, and the header has less than a hundred.
    bytes.try_reserve_exact(prepared.size.pixels().saturating_mul(12).saturating_add(100)).map_err(|_| short())?;
    cpu::write_ppm(&image, &mut bytes).map_err(|_| short())?;
    Ok(bytes)
}
