//! A sequential renderer of spheres and cylinders, exact to the byte.
//!
//! Text becomes checked values ([`Config`], [`Scene`]), these become what the rendering needs and nothing more
//! ([`Prepared`]), then pixels in one of two layouts ([`layout`]), then a PPM file ([`image::ppm`]). What is wrong with
//! the two texts is found on the way to [`Prepared`]; after it only memory and the file can fail. docs/design.md says
//! what each folder holds, and which others it uses.
//!
//! ```
//! use cpu::{Aos, Config, Scatter, Scene};
//!
//! let config = Config::parse(&b"image_width: 8\naspect_ratio: 1 1\ncamera_position: 0 0 -3\n"[..])?;
//! let scene = Scene::parse(&b"matte: grey .5 .5 .5\nsphere: 0 0 0 1 grey\n"[..])?;
//! let image = cpu::render::<Aos>(&config, &scene, Scatter::Statement)?;
//! let mut ppm = Vec::new();
//! cpu::image::ppm::write_ppm(&image, &mut ppm)?;
//! assert!(ppm.starts_with(b"P3\n8 8\n255\n"));
//! # Ok::<(), cpu::Error>(())
//! ```
//!
//! Two renderers live here. The module [`mod@reference`] follows the specification line by line and stays slow and
//! plain; the real one ([`render`](crate::render())) takes every shortcut that gives the same bytes.

pub mod accel;
pub mod counters;
pub mod exact;
pub mod geometry;
pub mod image;
pub mod input;
pub mod layout;
pub mod materials;
pub mod math;
pub mod output;
pub mod program;
pub mod reference;
pub mod render;
pub mod sampling;
pub mod simd;

pub use crate::geometry::camera::Camera;
pub use crate::geometry::ray::{Hit, Ray};
pub use crate::image::{Image, Rgb};
pub use crate::input::config::Config;
pub use crate::input::error::Error;
pub use crate::input::material::Material;
pub use crate::input::scene::Scene;
pub use crate::input::size::Size;
pub use crate::layout::Layout;
pub use crate::layout::aos::Aos;
pub use crate::layout::soa::Soa;
pub use crate::math::vec3::Vec3;
pub use crate::render::prepared::Prepared;
#[cfg(feature = "bench")]
#[doc(hidden)]
pub use crate::render::stages;
pub use crate::render::{render, render_into, render_linear, render_with};
pub use crate::sampling::scatter_vectors::Scatter;
pub use crate::simd::instruction_set::InstructionSet;
