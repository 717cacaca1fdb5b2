//! Finding the nearest object of a ray without asking every one.
//!
//! Everything here only decides which objects are asked, and in which order. Whether and where a ray meets an object is
//! decided by [`exact`](crate::exact) alone, and the nearest of all hits (the later object of two at the same lambda)
//! does not depend on the order. A filter may let an object pass that the ray misses; it never stops one that the ray
//! meets (docs/margins.md derives the margins).
//!
//! Uses [`exact`](crate::exact), [`layout`](crate::layout), [`materials`](crate::materials) and what these use. Begin
//! with [`choice`], which says what structure a scene gets, then [`every_object`], the plainest.

pub mod bounds;
pub mod bvh;
pub mod choice;
pub mod closest_hit;
pub mod conservative;
pub(crate) mod dominant_sphere;
pub mod every_object;
pub mod extent;
pub mod filter_ray;
pub mod find;
pub mod flat_filter;
mod inside;
pub(crate) mod isolated;
pub mod object;
pub mod side_by_side;
pub mod small_scene;
pub mod target;

#[cfg(test)]
mod tests;
