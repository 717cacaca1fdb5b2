//! A sequential renderer of spheres and cylinders, exact to the byte.
//!
//! Text becomes checked values ([`Config`], [`Scene`]), these become what the rendering needs and nothing more
//! ([`prepare`]), then pixels in one of two layouts ([`layout`]), then a PPM file ([`ppm`]). Errors are found on the
//! way to `prepare`; after it nothing can fail but writing the file.
//!
//! ```
//! use cpu::{Aos, Config, Scatter, Scene};
//!
//! let config = Config::parse(&b"image_width: 8\naspect_ratio: 1 1\ncamera_position: 0 0 -3\n"[..])?;
//! let scene = Scene::parse(&b"matte: grey .5 .5 .5\nsphere: 0 0 0 1 grey\n"[..])?;
//! let image = cpu::render::<Aos>(&config, &scene, Scatter::Statement)?;
//! let mut ppm = Vec::new();
//! cpu::ppm::write_ppm(&image, &mut ppm)?;
//! assert!(ppm.starts_with(b"P3\n8 8\n255\n"));
//! # Ok::<(), cpu::Error>(())
//! ```
//!
//! Two renderers live here. The module [`mod@reference`] follows the specification line by line and stays slow and
//! plain; the real one ([`render`](crate::render())) takes every shortcut that gives the same bytes.

pub mod background;
pub mod camera;
pub mod certified;
pub mod config;
pub mod counters;
pub mod cylinder;
pub mod error;
pub mod exact_sums;
pub mod image;
pub mod input;
pub mod layout;
pub mod material;
pub mod output;
pub mod ppm;
pub mod prepare;
pub mod program;
pub mod quantize;
pub mod ray;
pub mod real;
pub mod reference;
mod render;
pub mod rng;
pub mod rounding;
pub mod scatter;
pub mod scatter_vectors;
pub mod scene;
pub mod search;
pub mod simd;
pub mod size;
pub mod sphere;
mod surface;
pub mod text;
pub mod vec3;

pub use camera::Camera;
pub use config::Config;
pub use error::Error;
pub use image::{Image, Rgb};
pub use layout::{Aos, Layout, Soa};
pub use material::Material;
pub use prepare::Prepared;
pub use ray::{Hit, Ray};
#[cfg(feature = "bench")]
#[doc(hidden)]
pub use render::stages;
pub use render::{render, render_into, render_linear, render_with};
pub use scatter_vectors::Scatter;
pub use scene::Scene;
pub use simd::InstructionSet;
pub use size::Size;
pub use vec3::Vec3;
