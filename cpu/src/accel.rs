//! Acceleration structures: they find the closest hit of a ray without intersecting every object.
//!
//! A structure only decides which objects are intersected, and in which order. [`exact`](crate::exact) alone decides
//! whether and where a ray hits an object, and the closest hit does not depend on the order. A conservative test may
//! keep an object that the ray misses, but it never discards the one that the ray hits first. docs/margins.md
//! derives the margins.
//!
//! Uses [`exact`](crate::exact), [`layout`](crate::layout) and what these use. Begin with [`choice`], the rule that
//! chooses a structure, then [`every_object`], the simplest structure, and [`may_hit`], the conservative tests.

pub mod accelerator;
pub mod bounds;
pub mod bvh;
pub mod choice;
pub mod closest_hit;
pub(crate) mod dominant_sphere;
pub mod every_object;
pub mod extent;
pub mod flat_filter;
mod giants;
pub mod inside;
pub mod isolated;
pub mod may_hit;
pub mod object;
pub mod small_scene;
pub mod stack;

#[cfg(test)]
mod tests;
