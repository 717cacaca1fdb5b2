//! The objects of a scene by number.

use crate::input::error::Error;
use crate::layout::Objects;

/// Position of an object in the search: its index among the spheres, or the number of spheres plus its index among the
/// cylinders.
pub type ObjectId = u32;

/// No object: where primary rays come from.
pub const NOWHERE: ObjectId = ObjectId::MAX;

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
