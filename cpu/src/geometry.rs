//! Rays, the camera, spheres and cylinders, with the plain formulas (specification, sections 6 and 9).
//!
//! The formulas have the rounding errors of `f64`. So they may decide wrongly if a ray grazes a surface.
//! [`exact`](crate::exact) tells when their decisions are certain. Two rules have files of their own: a hit on a
//! [`cap`], and two hits at the same lambda ([`tie`]). Uses [`math`](crate::math) and [`input`](crate::input). Begin
//! with [`ray`], then [`sphere`].

pub mod camera;
pub mod cap;
pub mod cylinder;
pub mod ray;
pub mod sphere;
pub mod tie;
