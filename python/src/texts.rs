//! The texts of files, and the values of Python that stand for them.

use cpu::internals::input::text::for_each_line;
use pyo3::prelude::*;
use pyo3::pybacked::PyBackedBytes;
use pyo3::types::PyString;

use crate::fault::Fault;

/// Three numbers of Python.
pub type Triple = (f64, f64, f64);

/// Returns the three numbers of a vector or a colour.
pub fn triple(vector: cpu::Vec3) -> Triple {
    let [x, y, z] = vector.to_array();
    (x, y, z)
}

/// Returns the bytes of a text, which is a `str` or `bytes`. Bytes need not be UTF-8.
pub fn bytes(text: &Bound<'_, PyAny>) -> PyResult<PyBackedBytes> {
    if text.is_instance_of::<PyString>() { Ok(text.call_method0("encode")?.extract()?) } else { Ok(text.extract()?) }
}

/// Calls `read` with the number and the bytes of each line of `text`.
pub fn each_line(text: &[u8], mut read: impl FnMut(u64, &[u8]) -> Result<(), Fault>) -> Result<(), Fault> {
    let mut number = 0;
    for_each_line(text, |line| {
        number += 1;
        read(number, line)
    })
}
