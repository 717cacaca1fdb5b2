//! The class `Config`, read from a text or made of values.

use format::hint::Kind;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};

use crate::fault::Fault;
use crate::texts::{Triple, bytes, each_line, triple};
use crate::values::any;

/// A picture's size, camera, samples and background.
///
/// The keyword arguments are the keys of a configuration file. Their values are numbers or sequences of numbers, as in
/// `Config(image_width=640, camera_position=(0, 1, -5))`. Absent keys have their defaults.
///
/// Each key is an attribute too, as in `config.image_width`. A configuration can be copied and pickled.
#[pyclass(eq, frozen, module = "exact_renderer")]
#[derive(PartialEq)]
pub struct Config(pub cpu::Config);

/// The keys, in the order of the documentation.
const KEYS: [&str; 13] = [
    "aspect_ratio",
    "image_width",
    "gamma",
    "camera_position",
    "camera_target",
    "camera_north",
    "field_of_view",
    "samples_per_pixel",
    "max_depth",
    "material_rng_seed",
    "ray_rng_seed",
    "background_dark_color",
    "background_light_color",
];

impl Config {
    fn set(&mut self, number: u64, line: &[u8]) -> Result<(), Fault> {
        self.0.set(line).map_err(|error| Fault::in_line(error, Kind::Config, (number, line), std::iter::empty()))
    }
}

#[pymethods]
impl Config {
    #[new]
    #[pyo3(signature = (**keys))]
    fn new(keys: Option<&Bound<'_, PyDict>>) -> PyResult<Self> {
        Self(cpu::Config::default()).replace(keys)
    }

    /// Reads the text of a configuration file.
    #[staticmethod]
    #[pyo3(signature = (text, /))]
    fn parse(text: &Bound<'_, PyAny>) -> PyResult<Self> {
        let mut config = Self(cpu::Config::default());
        each_line(&bytes(text)?, |number, line| config.set(number, line))?;
        Ok(config)
    }

    /// Returns the configuration with other values of these keys.
    #[pyo3(signature = (**keys))]
    fn replace(&self, keys: Option<&Bound<'_, PyDict>>) -> PyResult<Self> {
        let mut config = Self(self.0.clone());
        for (line, (key, value)) in (1..).zip(keys.into_iter().flatten()) {
            config.set(line, format!("{key}: {}", any(&value)?).as_bytes())?;
        }
        Ok(config)
    }

    fn __getnewargs_ex__<'py>(this: &Bound<'py, Self>) -> PyResult<(Bound<'py, PyTuple>, Bound<'py, PyDict>)> {
        let keys = PyDict::new(this.py());
        KEYS.iter().try_for_each(|name| keys.set_item(name, this.getattr(*name)?))?;
        Ok((PyTuple::empty(this.py()), keys))
    }

    fn __repr__(this: &Bound<'_, Self>) -> PyResult<String> {
        let key = |name: &&str| Ok(format!("{name}={}", this.getattr(*name)?.repr()?));
        let keys: PyResult<Vec<_>> = KEYS.iter().map(key).collect();
        Ok(format!("Config({})", keys?.join(", ")))
    }

    #[getter]
    fn aspect_ratio(&self) -> (u64, u64) {
        self.0.aspect_ratio.into()
    }

    #[getter]
    fn image_width(&self) -> u64 {
        self.0.image_width
    }

    #[getter]
    fn gamma(&self) -> f64 {
        self.0.gamma
    }

    #[getter]
    fn camera_position(&self) -> Triple {
        triple(self.0.camera_position)
    }

    #[getter]
    fn camera_target(&self) -> Triple {
        triple(self.0.camera_target)
    }

    #[getter]
    fn camera_north(&self) -> Triple {
        triple(self.0.camera_north)
    }

    #[getter]
    fn field_of_view(&self) -> f64 {
        self.0.field_of_view
    }

    #[getter]
    fn samples_per_pixel(&self) -> u64 {
        self.0.samples_per_pixel
    }

    #[getter]
    fn max_depth(&self) -> u64 {
        self.0.max_depth
    }

    #[getter]
    fn material_rng_seed(&self) -> u64 {
        self.0.material_rng_seed
    }

    #[getter]
    fn ray_rng_seed(&self) -> u64 {
        self.0.ray_rng_seed
    }

    #[getter]
    fn background_dark_color(&self) -> Triple {
        triple(self.0.background_dark_color)
    }

    #[getter]
    fn background_light_color(&self) -> Triple {
        triple(self.0.background_light_color)
    }
}
