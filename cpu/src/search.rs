//! Finding the nearest object of a ray without asking every one.
//!
//! Everything here only decides which objects are asked, and in which order. Whether and where a ray meets an object is
//! decided by the exact formulas of [`crate::sphere`] and [`crate::cylinder`] alone, and the nearest of all hits (the
//! later object of two at the same lambda) does not depend on the order. A filter may let an object pass that the ray
//! misses; it never stops one that the exact formulas would hit (docs/performance.md derives the margins).

mod bounds;
mod build;
mod filter;
mod found;
mod hierarchy;
mod leaving;

pub use bounds::Bounds;
pub use filter::Filter;
pub use found::Found;
pub use hierarchy::{Hierarchy, Stack};

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
        } else if count <= filter::CAPACITY {
            Self::Flat(Filter::new(objects)?)
        } else {
            Self::Tree(Hierarchy::new(objects, extent)?)
        })
    }

    /// The nearest object that a ray from the surface of `from` meets.
    #[inline(always)]
    pub fn nearest<S: Simd, O: Objects>(&self, objects: &O, ray: &Ray, from: ObjectId, stack: &mut Stack) -> Found {
        match self {
            Self::Plain => plain(objects, ray),
            Self::Flat(filter) => filter.nearest::<S, O>(objects, ray, from),
            Self::Tree(tree) if tree.covers(ray.origin) => tree.nearest::<S, O>(objects, ray, from, stack),
            Self::Tree(_) => plain(objects, ray),
        }
    }
}

/// The nearest object, by asking every one.
#[inline(never)]
fn plain<O: Objects>(objects: &O, ray: &Ray) -> Found {
    let mut found = Found::NOTHING;
    for index in 0..objects.sphere_count() {
        found.ask_sphere(objects, index, ray);
    }
    for index in 0..objects.cylinder_count() {
        found.ask_cylinder(objects, index, ray);
    }
    found
}
