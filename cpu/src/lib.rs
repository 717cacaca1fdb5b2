//! Renders pictures of spheres and cylinders in one thread. docs/specification.md decides every byte of a picture.
//!
//! Two texts become checked values ([`Config`] and [`Scene`]). [`render()`] turns these values into pixels, in one of
//! two layouts ([`Aos`] and [`Soa`]). [`write_ppm`] turns the pixels into PPM text. Every fault of the two texts is
//! found before the first ray. docs/design.md says what each folder holds, and which other folders it uses.
//!
//! ```
//! use cpu::{Aos, Config, Scatter, Scene};
//!
//! let config = Config::parse(&b"image_width: 8\naspect_ratio: 1 1\ncamera_position: 0 0 -3\n"[..])?;
//! let scene = Scene::parse(&b"matte: grey .5 .5 .5\nsphere: 0 0 0 1 grey\n"[..])?;
//! let image = cpu::render::<Aos>(&config, &scene, Scatter::Statement)?;
//! let mut ppm = Vec::new();
//! cpu::write_ppm(&image, &mut ppm)?;
//! assert!(ppm.starts_with(b"P3\n8 8\n255\n"));
//! # Ok::<(), cpu::Error>(())
//! ```
//!
//! This crate has two renderers. The module [`mod@reference`] follows docs/specification.md line by line, and stays
//! slow and plain: start reading there. The real renderer, [`render()`], takes every shortcut that gives the same
//! bytes.
//!
//! A program that uses this crate needs the profile of this workspace. With Cargo's own (no `lto`, 16 codegen units)
//! the compiler inlines less, so pictures take much longer (docs/measurements/flags.txt).
//!
//! The feature `internals` makes most modules public, for the project's own tests, tools and measurements. These
//! modules may change at any time.

#![allow(rustdoc::private_intra_doc_links, reason = "the modules are read with --document-private-items")]

mod accel;
mod counters;
mod exact;
mod geometry;
mod image;
mod input;
pub mod intersect;
mod layout;
mod materials;
mod math;
pub mod reference;
mod render;
mod sampling;
mod simd;

pub use crate::geometry::ray::Ray;
pub use crate::image::{Image, Rgb, ppm::write_ppm};
pub use crate::input::scene::{Object, Scene, Shape};
pub use crate::input::{config::Config, error::Error, material::Material, size::Size, text::escape};
pub use crate::layout::{Layout, aos::Aos, soa::Soa};
pub use crate::math::vec3::Vec3;
pub use crate::render::{Renderable, render};
pub use crate::sampling::scatter_vectors::Scatter;

/// Most modules, for the project's own tests, tools and measurements.
#[cfg(feature = "internals")]
#[doc(hidden)]
pub mod internals {
    pub use crate::geometry::camera::Camera;
    pub use crate::render::limits::{Ended, Limits};
    pub use crate::render::prepared::Prepared;
    pub use crate::render::span_state::Streams;
    pub use crate::render::{render_from, render_linear, render_with};
    pub use crate::simd::instruction_set::InstructionSet;

    macro_rules! open {
        ($($module:ident)+) => {
            $(pub mod $module {
                pub use crate::$module::*;
            })+
        };
    }
    open!(accel counters exact geometry image input layout materials math render sampling simd);
}
