//! Rays, the camera they come from, and the two shapes, by the plain formulas (specification, sections 6 and 9).
//!
//! The formulas round as floating point does, and may decide wrongly where a ray grazes; [`exact`](crate::exact) says
//! where they can be trusted. Uses [`math`](crate::math) and [`input`](crate::input). Begin with [`ray`], then
//! [`sphere`]. Two rules have files of their own: a hit on a [`cap`], and two hits at the same distance ([`tie`]).

pub mod camera;
pub mod cap;
pub mod cylinder;
pub mod ray;
pub mod sphere;
pub mod tie;
