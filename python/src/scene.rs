//! The class `Scene`, read from a text or made of values.

use std::borrow::Cow;

use cpu::Material;
use cpu::internals::input::scene::{Cylinder, Object, Parser, Shape, Sphere};
use format::hint::Kind;
use pyo3::exceptions::{PyIndexError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyIterator, PyList, PyTuple};

use crate::fault::Fault;
use crate::texts::{bytes, each_line, triple};
use crate::values::{number, vector};

/// Materials and objects.
///
/// A scene is a sequence: of its materials, such as `("matte", "grey", (0.5, 0.5, 0.5))`, and then of its objects, such
/// as `("sphere", (0.0, 0.0, 0.0), 1.0, "grey")`. `Scene(list(scene))` gives an equal one. It can be copied and
/// pickled.
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

/// An entry of a scene: the method that adds it, and its arguments.
type Entry<'py> = Bound<'py, PyTuple>;

/// Largest number of entries that `repr` shows.
const MOST_SHOWN: usize = 100;

impl Scene {
    /// Returns the names of the materials, in the order of the scene.
    fn names(&self) -> Vec<Cow<'_, str>> {
        let mut names: Vec<_> = self.0.names.iter().map(|(name, id)| (*id, String::from_utf8_lossy(name))).collect();
        names.sort_unstable();
        names.into_iter().map(|(_, name)| name).collect()
    }

    /// Returns the entry at a place, counted from 0, of which there are `__len__`.
    fn entry<'py>(&self, py: Python<'py>, names: &[Cow<'_, str>], index: usize) -> PyResult<Entry<'py>> {
        let scene = self.scene();
        if let Some(material) = scene.materials.get(index) {
            let name = &names[index];
            return match *material {
                Material::Matte { reflectance } => ("matte", name, triple(reflectance)).into_pyobject(py),
                Material::Metal { reflectance, diffusion } => {
                    ("metal", name, triple(reflectance), diffusion).into_pyobject(py)
                }
                Material::Refractive { index } => ("refractive", name, index).into_pyobject(py),
            };
        }
        let Object { shape, material } = scene.objects[index - scene.materials.len()];
        let name = &names[material as usize];
        match shape {
            Shape::Sphere(Sphere { center, radius }) => ("sphere", triple(center), radius, name).into_pyobject(py),
            Shape::Cylinder(Cylinder { center, radius, axis }) => {
                ("cylinder", triple(center), radius, triple(axis), name).into_pyobject(py)
            }
        }
    }

    fn entries<'py>(&self, py: Python<'py>) -> PyResult<Vec<Entry<'py>>> {
        let names = self.names();
        (0..self.__len__()).map(|index| self.entry(py, &names, index)).collect()
    }
}

/// Returns the line of a scene file for an entry.
fn line(entry: &[Bound<'_, PyAny>]) -> PyResult<String> {
    let text = |value: &Bound<'_, PyAny>| value.extract::<String>();
    let (kind, values) = match entry {
        [kind, values @ ..] => (text(kind)?, values),
        [] => (String::new(), entry),
    };
    match (&kind[..], values) {
        ("matte", [name, reflectance]) => Ok(format!("matte: {} {}", text(name)?, vector(reflectance)?)),
        ("metal", [name, reflectance, diffusion]) => {
            Ok(format!("metal: {} {} {}", text(name)?, vector(reflectance)?, number(diffusion)?))
        }
        ("refractive", [name, index]) => Ok(format!("refractive: {} {}", text(name)?, number(index)?)),
        ("sphere", [center, radius, name]) => {
            Ok(format!("sphere: {} {} {}", vector(center)?, number(radius)?, text(name)?))
        }
        ("cylinder", [center, radius, axis, name]) => {
            Ok(format!("cylinder: {} {} {} {}", vector(center)?, number(radius)?, vector(axis)?, text(name)?))
        }
        _ => Err(PyValueError::new_err(format!(
            "[{kind}] with {} values is no entry of a scene, such as (\"sphere\", center, radius, material)",
            values.len()
        ))),
    }
}

#[pymethods]
impl Scene {
    #[new]
    #[pyo3(signature = (entries = None, /))]
    fn new(entries: Option<&Bound<'_, PyAny>>) -> PyResult<Self> {
        let mut scene = Self::default();
        for entry in entries.map(|entries| entries.try_iter()).transpose()?.into_iter().flatten() {
            let entry = entry?.try_iter()?.collect::<PyResult<Vec<_>>>()?;
            scene.read(line(&entry)?.as_bytes())?;
        }
        Ok(scene)
    }

    fn __getnewargs__<'py>(&self, py: Python<'py>) -> PyResult<(Vec<Entry<'py>>,)> {
        Ok((self.entries(py)?,))
    }

    fn __len__(&self) -> usize {
        self.scene().materials.len() + self.scene().objects.len()
    }

    fn __getitem__<'py>(&self, py: Python<'py>, index: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        let Ok(place) = index.extract::<isize>() else {
            return PyList::new(py, self.entries(py)?)?.as_any().get_item(index);
        };
        let count = self.__len__() as isize;
        let place = if place < 0 { place + count } else { place };
        if !(0..count).contains(&place) {
            return Err(PyIndexError::new_err("scene index out of range"));
        }
        Ok(self.entry(py, &self.names(), place as usize)?.into_any())
    }

    fn __iter__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyIterator>> {
        PyList::new(py, self.entries(py)?)?.try_iter()
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let names = self.names();
        let shown = |index: usize| Ok(self.entry(py, &names, index)?.repr()?.to_string());
        let shown: PyResult<Vec<_>> = (0..self.__len__().min(MOST_SHOWN)).map(shown).collect();
        let more = if self.__len__() > MOST_SHOWN { ", ..." } else { "" };
        Ok(format!("Scene([{}{more}])", shown?.join(", ")))
    }

    /// Reads the text of a scene file.
    #[staticmethod]
    #[pyo3(signature = (text, /))]
    fn parse(text: &Bound<'_, PyAny>) -> PyResult<Self> {
        let (mut scene, bytes) = (Self::default(), bytes(text)?);
        text.py().detach(|| each_line(&bytes, |_, line| scene.read(line)))?;
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
