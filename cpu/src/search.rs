//! Finding the nearest object of a ray without asking every one.
//!
//! Everything here only decides which objects are asked, and in which order. Whether and where a ray meets an object is
//! decided by the exact formulas of [`crate::sphere`] and [`crate::cylinder`] alone, and the nearest of all hits (the
//! later object of two at the same lambda) does not depend on the order. A filter may let an object pass that the ray
//! misses; it never stops one that the exact formulas would hit (docs/performance.md derives the margins).

mod bounds;
mod build;
mod few;
mod filter;
mod found;
mod hierarchy;
mod leaving;

pub use bounds::Bounds;
pub use few::Few;
pub use filter::Filter;
pub use found::Found;
pub use hierarchy::{Hierarchy, Stack};

use crate::certified::Intersect;
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
pub enum Search {
    /// Every object is asked: for scenes whose magnitudes no filter bears.
    Plain,
    /// All objects at once: for a handful.
    Few(Box<Few>),
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
            Self::Few(Box::new(Few::new(objects)))
        } else if count <= filter::CAPACITY {
            Self::Flat(Filter::new(objects)?)
        } else {
            Self::Tree(Hierarchy::new(objects, extent)?)
        })
    }

    /// The nearest object that a ray from the surface of `from` meets.
    #[inline(always)]
    pub fn nearest<S: Simd, O: Objects, P: Intersect>(
        &self,
        objects: &O,
        ray: &Ray,
        from: ObjectId,
        stack: &mut Stack,
    ) -> Found {
        match self {
            Self::Plain => plain::<O, P>(objects, ray),
            Self::Few(few) => few.nearest::<S, O, P>(objects, ray),
            Self::Flat(filter) => filter.nearest::<S, O, P>(objects, ray, from),
            Self::Tree(tree) if tree.covers(ray.origin) => tree.nearest::<S, O, P>(objects, ray, from, stack),
            Self::Tree(_) => plain::<O, P>(objects, ray),
        }
    }
}

/// All objects, in the order of the file.
#[must_use]
pub fn in_order(objects: &impl Objects) -> Vec<ObjectId> {
    let mut all: Vec<ObjectId> = (0..(objects.sphere_count() + objects.cylinder_count()) as ObjectId).collect();
    all.sort_by_key(|&id| order_of(objects, id));
    all
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
fn plain<O: Objects, P: Intersect>(objects: &O, ray: &Ray) -> Found {
    let mut found = Found::NOTHING;
    for index in 0..objects.sphere_count() {
        found.ask_sphere::<O, P>(objects, index, ray);
    }
    for index in 0..objects.cylinder_count() {
        found.ask_cylinder::<O, P>(objects, index, ray);
    }
    found
}
