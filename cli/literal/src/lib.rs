//! The statement as a slow program whose rules can be broken. Two tools are made of it, without files and without a
//! clock.
//!
//! - [`diagnose`] finds the deviations from the statement that explain a program's pictures. [`rules`] is the table of
//!   deviations, and [`cases`](mod@cases) are the scenes that tell them apart.
//! - [`explain`] tells the life of a pixel: draws, rays, intersections, colours and bytes.
//!
//! Both use the literal [`renderer`]. `camera`, `random`, `intersect`, `scatter` and [`develop`] are its parts. Begin
//! with [`rules`].

mod camera;
pub mod cases;
pub mod develop;
pub mod diagnose;
pub mod explain;
mod intersect;
mod random;
pub mod renderer;
pub mod rules;
mod scatter;
