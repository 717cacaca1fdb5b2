//! Writes values of Python as the texts of the input files that they stand for. So the parsers of `cpu` decide which
//! values are valid, and the messages are those for a text.

use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyString;

/// Returns the text of a number. The parsers read the same number from it.
pub fn number(value: &Bound<'_, PyAny>) -> PyResult<String> {
    if value.is_instance_of::<PyString>() {
        return Err(PyTypeError::new_err(format!("'{value}' is a text, and a number is needed")));
    }
    // Integers have this method, also those of numpy.
    match value.call_method0("__index__") {
        Ok(integer) => Ok(integer.to_string()),
        Err(_) => value.extract::<f64>().map(|number| format!("{number:?}")),
    }
}

/// Returns the text of a sequence of three numbers.
pub fn vector(value: &Bound<'_, PyAny>) -> PyResult<String> {
    match &numbers(value)?[..] {
        [x, y, z] => Ok(format!("{x} {y} {z}")),
        _ => Err(PyValueError::new_err(format!("{value} does not have three numbers"))),
    }
}

/// Returns the text of a number or of a sequence of numbers.
pub fn any(value: &Bound<'_, PyAny>) -> PyResult<String> {
    if value.hasattr("__iter__")? { Ok(numbers(value)?.join(" ")) } else { number(value) }
}

/// Returns the texts of the numbers of a sequence, but at most four, because that is more than any key takes.
fn numbers(value: &Bound<'_, PyAny>) -> PyResult<Vec<String>> {
    value.try_iter()?.take(4).map(|one| number(&one?)).collect()
}
