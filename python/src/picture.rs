//! The function `render`.

use std::ops::ControlFlow;
use std::sync::Arc;

use cpu::internals::input::{error::with_room, size::Size};
use cpu::internals::{InstructionSet, Limits, Prepared, render_from, render_linear};
use cpu::{Aos, Image, Layout, Scatter};
use numpy::{Element, PyArray1, PyArrayMethods};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::config::Config;
use crate::fault::Fault;
use crate::scene::Scene;
use crate::worker;

/// Renders a scene, and returns an array of the shape (height, width, 3).
///
/// The array has the bytes of the picture file. If `linear` is true it has the means of the samples as float64, before
/// gamma correction. `scatter` is "statement", as for render-aos and render-soa, "published" or "deterministic".
#[pyfunction]
#[pyo3(signature = (config, scene, scatter = "statement", linear = false))]
pub fn render<'py>(
    py: Python<'py>,
    config: &Config,
    scene: &Scene,
    scatter: &str,
    linear: bool,
) -> PyResult<Bound<'py, PyAny>> {
    let scatter = match scatter {
        "statement" => Scatter::Statement,
        "published" => Scatter::Published,
        "deterministic" => Scatter::Deterministic,
        other => {
            let text = format!("scatter is [{other}]; choose statement, published or deterministic");
            return Err(PyValueError::new_err(text));
        }
    };
    let (config, scene) = (&config.0, scene.scene());
    let limits = Limits::prompt(scene.objects.len());
    let stop = Arc::clone(&limits.stop);
    let size = config.image_size().map_err(cpu::Error::from).map_err(Fault::from)?;
    let prepare = || Prepared::<Aos>::new(config, scene, scatter);
    if linear {
        array(py, size, worker::run(py, &stop, || means(&prepare()?, &limits))?)
    } else {
        array(py, size, worker::run(py, &stop, || bytes(&prepare()?, &limits))?)
    }
}

/// Returns the means of all pixels' channels. They are incomplete if the picture was stopped.
fn means(prepared: &Prepared<Aos>, limits: &Limits) -> Result<Vec<f64>, Fault> {
    let count = 3 * prepared.size.pixels();
    let mut means = with_room(count, "the image")?;
    means.resize(count, 0.0);
    render_linear(prepared, InstructionSet::chosen(), limits, |index, mean| {
        means[3 * index..][..3].copy_from_slice(&mean.to_array());
    })?;
    Ok(means)
}

/// Returns the bytes of all pixels' channels. They are incomplete if the picture was stopped.
fn bytes(prepared: &Prepared<Aos>, limits: &Limits) -> Result<Vec<u8>, Fault> {
    let mut image = <Aos as Layout>::Image::black(prepared.size)?;
    let mut bytes = with_room(3 * prepared.size.pixels(), "the image")?;
    render_from(prepared, InstructionSet::chosen(), limits, (0, &[]), &mut image, |_, _, _| ControlFlow::Continue(()))?;
    for index in 0..prepared.size.pixels() {
        let color = image.pixel(index);
        bytes.extend([color.red, color.green, color.blue]);
    }
    Ok(bytes)
}

/// Returns the array of a picture, which takes over the memory of `channels`.
fn array<T: Element>(py: Python<'_>, size: Size, channels: Vec<T>) -> PyResult<Bound<'_, PyAny>> {
    Ok(PyArray1::from_vec(py, channels).reshape([size.height(), size.width(), 3])?.into_any())
}
