//! The Python module `exact_renderer`: pictures, exact intersections, depth and normals as arrays of numpy.
//!
//! `config` and `scene` have the classes `Config` and `Scene`, whose values all go through the parsers of `cpu`.
//! `picture` and `rays` have the functions, whose work `worker` runs without the interpreter's lock. `fault` turns
//! errors into exceptions. `exact_renderer.pyi` has the types for Python.

mod arrays;
mod closest;
mod config;
mod fault;
mod picture;
mod rays;
mod scene;
mod texts;
mod values;
mod worker;

/// Exact renderer of spheres and cylinders. Pictures have the bytes of render-aos and render-soa, and intersections are
/// decided as by exact arithmetic.
#[pyo3::pymodule]
mod exact_renderer {
    #[pymodule_export]
    use crate::config::Config;
    #[pymodule_export]
    use crate::fault::Error;
    #[pymodule_export]
    use crate::picture::render;
    #[pymodule_export]
    use crate::rays::{depth, intersect, normals};
    #[pymodule_export]
    use crate::scene::Scene;
}
