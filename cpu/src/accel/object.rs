//! The objects of a scene by number.

use crate::input::error::Error;
use crate::layout::Objects;

/// The number of an object: its index among the spheres, or the number of spheres plus its index among the cylinders.
/// [`ObjectRef`] tells which of the two.
pub type ObjectId = u32;

/// No object: where camera rays come from.
pub const NOWHERE: ObjectId = ObjectId::MAX;

/// An object by its kind, with its index among the objects of that kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ObjectRef {
    /// A sphere.
    Sphere(usize),
    /// A cylinder.
    Cylinder(usize),
}

impl ObjectRef {
    /// The object with this number.
    #[inline(always)]
    #[must_use]
    pub fn of(objects: &impl Objects, id: ObjectId) -> Self {
        match (id as usize).checked_sub(objects.sphere_count()) {
            None => Self::Sphere(id as usize),
            Some(index) => Self::Cylinder(index),
        }
    }
}

/// Number of objects.
pub fn count(objects: &impl Objects) -> usize {
    objects.sphere_count() + objects.cylinder_count()
}

/// All objects, in the order of the file.
///
/// # Errors
/// [`Error::OutOfMemory`].
pub fn in_order(objects: &impl Objects) -> Result<Vec<ObjectId>, Error> {
    let mut all = room(count(objects))?;
    all.extend(0..count(objects) as ObjectId);
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
    match ObjectRef::of(objects, id) {
        ObjectRef::Sphere(index) => objects.sphere(index).order,
        ObjectRef::Cylinder(index) => objects.cylinder(index).order,
    }
}
