//! Finding the nearest object of a ray without asking every one.
//!
//! Everything here only decides which objects are asked, and in which order. Whether and where a ray meets an object is
//! decided by the exact formulas of [`crate::sphere`] and [`crate::cylinder`] alone, and the nearest of all hits (the
//! later object of two at the same lambda) does not depend on the order. A filter may let an object pass that the ray
//! misses; it never stops one that the exact formulas would hit (docs/performance.md derives the margins).

mod alone;
mod bounds;
mod box_ray;
mod build;
mod choice;
mod every_object;
mod few;
mod filter;
mod filter_ray;
mod find;
mod found;
mod ground;
mod hierarchy;
mod inside;
mod node;
mod object;
mod side_by_side;
mod stack;
mod target;
mod top;
mod touch;

pub use bounds::Bounds;
pub use choice::Search;
pub use every_object::Plain;
pub use few::{Few, nearest_of};
pub use filter::Filter;
pub use find::{Find, Origin};
pub use found::Found;
pub use hierarchy::Hierarchy;
pub(crate) use object::room;
pub use object::{NOWHERE, ObjectId, in_order, order_of};
pub use side_by_side::TouchedByEach;
pub use stack::Stack;
pub use touch::{Touch, is_too_short};

#[cfg(test)]
mod tests;
