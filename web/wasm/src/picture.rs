//! Renders the picture of the two texts, and tells the caller about each row.

use std::io::{self, Write};
use std::ops::ControlFlow;

use cpu::internals::image::Image;
use cpu::internals::{InstructionSet, Limits, Prepared, render_within};
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
    // The result is always `None`: the caller ends a picture by ending the module.
    let _ = render_within(prepared, set, &Limits::default(), &mut image, |rows, image| {
        row.clear();
        for index in (rows - 1) * width..rows * width {
            let color = image.pixel(index);
            row.extend_from_slice(&[color.red, color.green, color.blue, 255]);
        }
        page::row(rows - 1, row.as_ptr());
        ControlFlow::Continue(())
    })?;
    let mut bytes = Checked(Vec::new());
    // The only reason for which this writer fails is too little memory.
    cpu::write_ppm(&image, &mut bytes).map_err(|_| Error::OutOfMemory { what: FILE })?;
    Ok(bytes.0)
}

/// A list of bytes that can be written to. If memory is short, writing fails instead of ending the module.
struct Checked(Vec<u8>);

impl Write for Checked {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.try_reserve(bytes.len()).map_err(|_| io::Error::from(io::ErrorKind::OutOfMemory))?;
        self.0.extend_from_slice(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}
