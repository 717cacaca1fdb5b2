//! The functions `intersect`, `depth` and `normals`.

use std::sync::atomic::AtomicBool;

use cpu::internals::{Prepared, input::size::Size};
use cpu::{Aos, Ray, Scatter};
use numpy::{PyArray1, PyArray2, PyArray3, PyArrayMethods, PyUntypedArrayMethods};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::arrays::{largest, vectors};
use crate::closest::{self, Hits};
use crate::config::Config;
use crate::fault::Fault;
use crate::scene::Scene;
use crate::worker;

/// What `intersect` returns: objects, lambdas, normals and parts.
type Arrays<'py> =
    (Bound<'py, PyArray1<i64>>, Bound<'py, PyArray1<f64>>, Bound<'py, PyArray2<f64>>, Bound<'py, PyArray1<i8>>);

/// Finds the closest hit of each ray, decided as by exact arithmetic.
///
/// `origins` and `directions` have the shape (n, 3). The results are four arrays with an entry for each ray:
///
/// - the index of the object that is hit, in the order of the scene, or -1;
/// - lambda: the hit is at origin + lambda * direction. It is at least 0.001, and NaN without a hit;
/// - the normal that points out of the object, of length one, or NaN without a hit;
/// - the part: 0 for a sphere or the side of a cylinder, 1 for the upper cap, to which the axis points, 2 for the lower
///   cap, -1 without a hit.
///
/// Each call prepares the scene, so give many rays at once. Other threads must not change the arrays meanwhile.
#[pyfunction]
pub fn intersect<'py>(
    origins: &Bound<'py, PyAny>,
    directions: &Bound<'py, PyAny>,
    scene: &Scene,
) -> PyResult<Arrays<'py>> {
    let (py, scene) = (origins.py(), scene.scene());
    let (origins, directions) = (vectors("origins", origins)?, vectors("directions", directions)?);
    let counts = [origins.shape()[0], directions.shape()[0]];
    if counts[0] != counts[1] {
        return Err(PyValueError::new_err(format!("there are {} origins and {} directions", counts[0], counts[1])));
    }
    let (origins, directions) = (origins.as_slice()?.as_chunks().0, directions.as_slice()?.as_chunks().0);
    let (origin, direction) = (largest("origins", origins)?, largest("directions", directions)?);
    let stop = AtomicBool::new(false);
    // This thread requests the memory. The C library gives memory of other threads back to the system after each call.
    let hits = Hits::with_room(counts[0]).map_err(Fault::from)?;
    let Hits { object, lambda, normal, part } = worker::run(py, &stop, || {
        let structure = closest::structure(scene, origin, direction)?;
        let ray = |index: usize| Ray { origin: origins[index].into(), direction: directions[index].into() };
        Ok(closest::append(hits, &structure, counts[0], ray, &stop))
    })?;
    Ok((
        PyArray1::from_vec(py, object),
        PyArray1::from_vec(py, lambda),
        PyArray1::from_vec(py, normal).reshape([counts[0], 3])?,
        PyArray1::from_vec(py, part),
    ))
}

/// Returns the distances from the camera to what the rays through the middles of the pixels hit.
///
/// The array has the shape (height, width), and is NaN where there is no object, as in the files of `render-lab render
/// --show depth`.
#[pyfunction]
pub fn depth<'py>(py: Python<'py>, config: &Config, scene: &Scene) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let (size, hits) = pixels(py, config, scene)?;
    PyArray1::from_vec(py, hits.lambda).reshape([size.height(), size.width()])
}

/// Returns the normals of what the rays through the middles of the pixels hit.
///
/// The array has the shape (height, width, 3). The normals point out of the objects and have length one, or are NaN
/// where there is no object.
#[pyfunction]
pub fn normals<'py>(py: Python<'py>, config: &Config, scene: &Scene) -> PyResult<Bound<'py, PyArray3<f64>>> {
    let (size, hits) = pixels(py, config, scene)?;
    PyArray1::from_vec(py, hits.normal).reshape([size.height(), size.width(), 3])
}

/// Returns the size of the picture, and what the rays through the middles of its pixels hit. A lambda is
/// multiplied by the length of its ray's direction, so that it is the distance from the camera.
fn pixels(py: Python<'_>, config: &Config, scene: &Scene) -> PyResult<(Size, Hits)> {
    let (config, scene, stop) = (&config.0, scene.scene(), AtomicBool::new(false));
    worker::run(py, &stop, || {
        let prepared = Prepared::<Aos>::new(config, scene, Scatter::Deterministic)?;
        let Prepared { size, camera, objects, accel, .. } = prepared;
        let ray = |index: usize| {
            let (row, column) = (index / size.width(), index % size.width());
            camera.ray(row as f64, column as f64, [0.0; 2])
        };
        let hits = Hits::with_room(size.pixels())?;
        let mut hits = closest::append(hits, &(objects, accel), size.pixels(), ray, &stop);
        hits.lambda.iter_mut().enumerate().for_each(|(index, lambda)| *lambda *= ray(index).direction.length());
        Ok((size, hits))
    })
}
