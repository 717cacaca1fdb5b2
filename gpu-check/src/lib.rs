//! Runs the WGSL port of the renderer's mathematics and compares it with `cpu`, bit by bit.
//!
//! The port ([`shaders`]) is an independent second implementation, in another language and with another compiler. If
//! two such implementations give the same bits, a mistake in one of them is very unlikely. On Mesa's lavapipe, a Vulkan
//! driver that calculates on the CPU, the results in f64 are equal. `docs/gpu.md` lists the results that cannot be
//! equal, with the reasons.
//!
//! - [`adapter`] and [`gpu`] open a device, and [`form`] says in which form it gets shaders;
//! - [`rows`] runs kernels that turn rows of numbers into rows of numbers, and [`reader`] reads such a row;
//! - [`methods`] lets `stability` compare the intersections in WGSL with exact arithmetic;
//! - [`renderer`] and the package [`mod@twin`] render whole pictures in deterministic mode, on the GPU and in Rust;
//! - [`sampled`] renders pictures with random numbers, on the GPU and in Rust;
//! - [`hierarchy`] lets a device render large scenes, and [`closest_hits`] compares it ray by ray;
//! - [`steps`] traces single pixels step by step on both, and [`first_difference`] finds the function that differs;
//! - [`shader_lab`] renders with a user's own modules, and [`guard`] limits what their compilation may take.
//!
//! The tests compare all formulas, operations on f64 by integers and whole pictures, and they must notice deliberate
//! errors.
//!
//! ```no_run
//! use gpu_check::{Gpu, Picture, Renderer, features_of};
//! use shaders::Library;
//!
//! let gpu = Gpu::open()?;
//! println!("{gpu}");
//! let config = cpu::internals::input::config::Config::default();
//! let scene = cpu::internals::input::scene::Scene::parse(&b"matte: grey .5 .5 .5\nsphere: 0 0 0 1 grey\n"[..])?;
//! let features = features_of(&config, &scene)?;
//! let renderer = Renderer::<f64>::new(&gpu, &Library::standard(), &features, &[])?;
//! let rendering = renderer.render(&Picture::new(&config, &scene)?)?;
//! println!("{} pixels in {:?}", rendering.pixels.len(), rendering.time);
//! # Ok::<(), gpu_check::Error>(())
//! ```

pub mod adapter;
pub mod closest_hits;
pub mod difference;
pub mod error;
pub mod first_difference;
pub mod form;
pub mod gpu;
pub mod guard;
pub mod methods;
pub mod pipeline;
mod ray_loop;
pub mod reader;
pub mod renderer;
pub mod rows;
pub mod runtime;
pub mod sampled;
pub mod shader_lab;
pub mod steps;
pub mod terminal;

pub use error::Error;
pub use form::Form;
pub use gpu::Gpu;
pub use pipeline::Pipeline;
pub use renderer::{Renderer, Rendering};
pub use twin::{Float, Picture, features_of, head, hierarchy, packed, picture};
