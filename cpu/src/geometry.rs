//! Rays, the camera they come from, and the two shapes, by the plain formulas (specification, sections 6 and 9).
//!
//! The formulas round as floating point does, and may decide wrongly where a ray grazes; [`exact`](crate::exact) says
//! where they can be trusted. Uses [`math`](crate::math) and [`input`](crate::input). Begin with [`ray`], then
//! [`sphere`].

pub mod camera;
pub mod cylinder;
pub mod ray;
pub mod sphere;
