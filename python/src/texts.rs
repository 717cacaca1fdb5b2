//! The classes `Config` and `Scene`, read from a text or made of values.

use cpu::internals::input::{scene::Parser, text::for_each_line};
use format::hint::Kind;
use pyo3::prelude::*;
use pyo3::pybacked::PyBackedBytes;
use pyo3::types::{PyDict, PyString};

use crate::fault::Fault;
use crate::values::{any, number, vector};

/// Returns the bytes of a text, which is a `str` or `bytes`. Bytes need not be UTF-8.
fn bytes(text: &Bound<'_, PyAny>) -> PyResult<PyBackedBytes> {
    if text.is_instance_of::<PyString>() { Ok(text.call_method0("encode")?.extract()?) } else { Ok(text.extract()?) }
}

/// A picture's size, camera, samples and background.
///
/// The keyword arguments are the keys of a configuration file. Their values are numbers or sequences of numbers, as in
/// `Config(image_width=640, camera_position=(0, 1, -5))`. Absent keys have their defaults.
#[pyclass(eq, frozen, module = "exact_renderer")]
#[derive(PartialEq)]
pub struct Config(pub cpu::Config);

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
        let (mut config, mut number) = (Self(cpu::Config::default()), 0);
        for_each_line(&*bytes(text)?, |line| {
            number += 1;
            config.set(number, line)
        })?;
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
}

/// Materials and objects.
///
/// Each method adds a line of a scene file, and returns the scene, as in
/// `Scene().matte("grey", (.5, .5, .5)).sphere((0, 0, 0), 1, "grey")`. A material must be added before its objects.
#[pyclass(eq, module = "exact_renderer")]
#[derive(Default)]
pub struct Scene(Parser);

impl PartialEq for Scene {
    fn eq(&self, other: &Self) -> bool {
        self.scene() == other.scene()
    }
}

impl Scene {
    /// Returns the materials and objects.
    pub const fn scene(&self) -> &cpu::Scene {
        &self.0.scene
    }

    fn read(&mut self, line: &[u8]) -> Result<(), Fault> {
        let result = self.0.read_line(line);
        result.map_err(|error| Fault::in_line(error, Kind::Scene, (self.0.line, line), self.0.names.keys()))
    }
}

type Value<'a, 'py> = &'a Bound<'py, PyAny>;

/// Adds `line` to the scene, and returns the scene.
fn add<'py>(mut scene: PyRefMut<'py, Scene>, line: &str) -> PyResult<PyRefMut<'py, Scene>> {
    scene.read(line.as_bytes())?;
    Ok(scene)
}

#[pymethods]
impl Scene {
    #[new]
    fn new() -> Self {
        Self::default()
    }

    /// Reads the text of a scene file.
    #[staticmethod]
    #[pyo3(signature = (text, /))]
    fn parse(text: &Bound<'_, PyAny>) -> PyResult<Self> {
        let (mut scene, bytes) = (Self::default(), bytes(text)?);
        text.py().detach(|| for_each_line(&*bytes, |line| scene.read(line)))?;
        Ok(scene)
    }

    /// Adds a matte material. The reflectance has three numbers from 0 to 1.
    fn matte<'py>(this: PyRefMut<'py, Self>, name: &str, reflectance: Value<'_, 'py>) -> PyResult<PyRefMut<'py, Self>> {
        add(this, &format!("matte: {name} {}", vector(reflectance)?))
    }

    /// Adds a metal material. The diffusion is 0 for a perfect mirror.
    fn metal<'py>(
        this: PyRefMut<'py, Self>,
        name: &str,
        reflectance: Value<'_, 'py>,
        diffusion: Value<'_, 'py>,
    ) -> PyResult<PyRefMut<'py, Self>> {
        add(this, &format!("metal: {name} {} {}", vector(reflectance)?, number(diffusion)?))
    }

    /// Adds a refractive material with this refractive index.
    fn refractive<'py>(this: PyRefMut<'py, Self>, name: &str, index: Value<'_, 'py>) -> PyResult<PyRefMut<'py, Self>> {
        add(this, &format!("refractive: {name} {}", number(index)?))
    }

    /// Adds a sphere.
    fn sphere<'py>(
        this: PyRefMut<'py, Self>,
        center: Value<'_, 'py>,
        radius: Value<'_, 'py>,
        material: &str,
    ) -> PyResult<PyRefMut<'py, Self>> {
        add(this, &format!("sphere: {} {} {material}", vector(center)?, number(radius)?))
    }

    /// Adds a closed cylinder. Its axis points to the upper cap, and is as long as the cylinder is high.
    fn cylinder<'py>(
        this: PyRefMut<'py, Self>,
        center: Value<'_, 'py>,
        radius: Value<'_, 'py>,
        axis: Value<'_, 'py>,
        material: &str,
    ) -> PyResult<PyRefMut<'py, Self>> {
        let (center, radius, axis) = (vector(center)?, number(radius)?, vector(axis)?);
        add(this, &format!("cylinder: {center} {radius} {axis} {material}"))
    }
}
