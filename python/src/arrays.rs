//! Checks the arrays of numpy that a caller gives.

use numpy::{PyReadonlyArray2, PyReadonlyArrayDyn, PyUntypedArrayMethods};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::IntoPyDict;

/// Returns the vectors in `value`, anything of which numpy can make an array of the shape (n, 3). Numbers that float64
/// cannot hold are refused.
///
/// # Errors
/// The exception of numpy, or a `ValueError` that names the array as `name`.
pub fn vectors<'py>(name: &str, value: &Bound<'py, PyAny>) -> PyResult<PyReadonlyArray2<'py, f64>> {
    let py = value.py();
    let options = [("order", "C"), ("casting", "safe")].into_py_dict(py)?;
    options.set_item("copy", false)?;
    let numpy = py.import("numpy")?;
    let array = numpy.call_method1("asarray", (value,))?;
    // A contiguous array may begin at an odd address, and have numbers in the order of another machine.
    let native = array.getattr("dtype")?.call_method1("newbyteorder", ("=",))?;
    let array = numpy.call_method1("require", (array, native, ["C", "ALIGNED"]))?;
    refuse_rounding(name, &array)?;
    let array = array.call_method("astype", ("float64",), Some(&options))?;
    let shape = array.getattr("shape")?;
    match array.extract::<PyReadonlyArray2<'py, f64>>() {
        Ok(vectors) if vectors.shape()[1] == 3 => Ok(vectors),
        _ => Err(PyValueError::new_err(format!("{name} has the shape {shape}, and (n, 3) is needed"))),
    }
}

/// Refuses whole numbers that float64 would round. numpy calls the conversion of 64-bit integers safe.
fn refuse_rounding(name: &str, array: &Bound<'_, PyAny>) -> PyResult<()> {
    let is_exact = if let Ok(numbers) = array.extract::<PyReadonlyArrayDyn<'_, i64>>() {
        numbers.as_array().iter().all(|&number| number as f64 as i128 == i128::from(number))
    } else if let Ok(numbers) = array.extract::<PyReadonlyArrayDyn<'_, u64>>() {
        numbers.as_array().iter().all(|&number| number as f64 as i128 == i128::from(number))
    } else {
        true
    };
    let text = || format!("{name} has a whole number that float64 cannot hold; round it by array.astype(float)");
    if is_exact { Ok(()) } else { Err(PyValueError::new_err(text())) }
}

/// Returns the largest magnitude of all components of `vectors`, or 0 without vectors.
///
/// # Errors
/// A `ValueError` that names the array as `name`, if a number is infinite or NaN.
pub fn largest(name: &str, vectors: &[[f64; 3]]) -> PyResult<f64> {
    // Eight sums and maxima at once, so that the compiler uses vectors. A comparison with NaN is false, and the sum of
    // products with 0 is 0 unless a number is not finite.
    let (mut largest, mut zero) = ([0.0_f64; 8], [0.0; 8]);
    let (chunks, rest) = vectors.as_flattened().as_chunks::<8>();
    let mut last = [0.0; 8];
    last[..rest.len()].copy_from_slice(rest);
    for chunk in chunks.iter().chain([&last]) {
        for lane in 0..8 {
            let magnitude = chunk[lane].abs();
            largest[lane] = if magnitude > largest[lane] { magnitude } else { largest[lane] };
            zero[lane] += chunk[lane] * 0.0;
        }
    }
    if zero != [0.0; 8] {
        return Err(PyValueError::new_err(format!("{name} has a number that is not finite")));
    }
    Ok(largest.into_iter().fold(0.0, f64::max))
}
