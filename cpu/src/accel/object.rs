//! The objects of a scene by number.

use crate::{input::error::Error, layout::Objects, layout::with_room, math::vec3::Vec3};

/// The number of an object: its index among the spheres, or the number of spheres plus its index among the cylinders.
/// [`ObjectRef`] distinguishes the two.
pub type ObjectId = u32;

/// No object: where camera rays come from.
pub const NO_OBJECT: ObjectId = ObjectId::MAX;

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
    let mut all = with_room(count(objects))?;
    all.extend(0..count(objects) as ObjectId);
    all.sort_unstable_by_key(|&id| order_of(objects, id));
    Ok(all)
}

/// An object's place in the file.
pub fn order_of(objects: &impl Objects, id: ObjectId) -> u32 {
    match ObjectRef::of(objects, id) {
        ObjectRef::Sphere(index) => objects.sphere(index).order,
        ObjectRef::Cylinder(index) => objects.cylinder(index).order,
    }
}

/// Centre and radius of the smallest sphere around an object, rounded.
pub fn bounding_sphere(objects: &impl Objects, id: ObjectId) -> (Vec3, f64) {
    match ObjectRef::of(objects, id) {
        ObjectRef::Sphere(index) => {
            let record = objects.sphere(index).record;
            (record.center, record.radius)
        }
        ObjectRef::Cylinder(index) => {
            let record = objects.cylinder(index).record;
            (record.center, (record.radius_squared + record.half_height * record.half_height).sqrt())
        }
    }
}
