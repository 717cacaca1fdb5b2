//! Which acceleration structure a scene gets.

use crate::accel::bvh::Hierarchy;
use crate::accel::bvh::stack::Stack;
use crate::accel::closest_hit::Found;
use crate::accel::every_object::Plain;
use crate::accel::extent::Extent;
use crate::accel::find::Find;
use crate::accel::flat_filter;
use crate::accel::flat_filter::Filter;
use crate::accel::object::ObjectId;
use crate::accel::small_scene;
use crate::accel::small_scene::Few;
use crate::counters::{Counter, add};
use crate::geometry::ray::Ray;
use crate::input::error::Error;
use crate::layout::Objects;
use crate::simd::Simd;

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
        } else if small_scene::suits(objects) {
            Self::Few(Few::new(objects, extent)?)
        } else if count <= flat_filter::CAPACITY && extent.reach <= flat_filter::LARGEST_REACH {
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
