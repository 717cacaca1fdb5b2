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
mod few;
mod filter;
mod filter_ray;
mod find;
mod found;
mod ground;
mod hierarchy;
mod inside;
mod node;
mod side_by_side;
mod stack;
mod target;
mod top;
mod touch;

pub use bounds::Bounds;
pub use few::{Few, nearest_of};
pub use filter::Filter;
pub use find::{Find, Origin, Plain};
pub use found::Found;
pub use hierarchy::Hierarchy;
pub use side_by_side::TouchedByEach;
pub use stack::Stack;
pub use touch::{Touch, is_too_short};

use crate::counters::{Counter, add};
use crate::error::Error;
use crate::layout::Objects;
use crate::prepare::Extent;
use crate::ray::Ray;
use crate::simd::Simd;

/// Position of an object in the search: its index among the spheres, or the number of spheres plus its index among the
/// cylinders.
pub type ObjectId = u32;

/// No object: where primary rays come from.
pub const NOWHERE: ObjectId = ObjectId::MAX;

/// How the nearest object is found; chosen once for a scene.
#[derive(Debug)]
#[expect(clippy::large_enum_variant, reason = "a scene has one")]
pub enum Search {
    /// Every object is asked: for scenes whose magnitudes no filter bears.
    Plain,
    /// All objects at once: for a handful.
    Few(Few),
    /// A filter over all objects, several at once.
    Flat(Filter),
    /// A tree of boxes.
    Tree(Hierarchy),
}

impl Search {
    /// The search that fits the objects.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`].
    pub fn new(objects: &impl Objects, extent: &Extent) -> Result<Self, Error> {
        let count = objects.sphere_count().max(objects.cylinder_count());
        Ok(if !extent.moderate {
            Self::Plain
        } else if few::suits(objects) {
            Self::Few(Few::new(objects, extent)?)
        } else if count <= filter::CAPACITY && extent.reach <= filter::LARGEST_REACH {
            Self::Flat(Filter::new(objects, extent)?)
        } else {
            Self::Tree(Hierarchy::new(objects, extent)?)
        })
    }

    /// Forgets which objects no other reaches into, so that rays inside them are searched for like all others: for measuring
    /// what it gains to know.
    pub fn forget_who_is_alone(&mut self) {
        match self {
            Self::Plain | Self::Few(_) => {}
            Self::Flat(filter) => filter.forget_who_is_alone(),
            Self::Tree(tree) => tree.forget_who_is_alone(),
        }
    }

    /// The nearest object that a ray from the surface of `from` meets.
    #[inline(always)]
    pub fn nearest<S: Simd, O: Objects>(&self, objects: &O, ray: &Ray, from: ObjectId, stack: &mut Stack) -> Found {
        add(Counter::WalkRays, 1);
        match self {
            Self::Plain => Plain.find::<S, O>(objects, ray, Plain.origin(objects, ray, from), stack),
            Self::Few(search) => search.find::<S, O>(objects, ray, search.origin(objects, ray, from), stack),
            Self::Flat(search) => search.find::<S, O>(objects, ray, search.origin(objects, ray, from), stack),
            Self::Tree(search) => search.find::<S, O>(objects, ray, search.origin(objects, ray, from), stack),
        }
    }
}

/// All objects, in the order of the file.
///
/// # Errors
/// [`Error::OutOfMemory`].
pub fn in_order(objects: &impl Objects) -> Result<Vec<ObjectId>, Error> {
    let count = objects.sphere_count() + objects.cylinder_count();
    let mut all = room(count)?;
    all.extend(0..count as ObjectId);
    all.sort_unstable_by_key(|&id| order_of(objects, id));
    Ok(all)
}

/// A list with room for `count` objects.
///
/// # Errors
/// [`Error::OutOfMemory`].
pub(crate) fn room<T>(count: usize) -> Result<Vec<T>, Error> {
    let mut list = Vec::new();
    list.try_reserve_exact(count).map_err(|_| Error::OutOfMemory { what: "the objects" })?;
    Ok(list)
}

/// An object's place in the file.
#[must_use]
pub fn order_of(objects: &impl Objects, id: ObjectId) -> u32 {
    match (id as usize).checked_sub(objects.sphere_count()) {
        None => objects.sphere(id as usize).order,
        Some(index) => objects.cylinder(index).order,
    }
}

/// The nearest object, by asking every one.
#[inline(never)]
fn plain<O: Objects>(objects: &O, ray: &Ray) -> Found {
    add(Counter::PlainAsks, (objects.sphere_count() + objects.cylinder_count()) as u64);
    let mut found = Found::NOTHING;
    for index in 0..objects.sphere_count() {
        found.ask_sphere(objects, index, ray);
    }
    for index in 0..objects.cylinder_count() {
        found.ask_cylinder(objects, index, ray);
    }
    found
}

#[cfg(test)]
mod tests;
