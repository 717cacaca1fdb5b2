//! Numbers for the objects of a scene.

use crate::{layout::Objects, math::vec3::Vec3};

/// The number of an object. Spheres come first: for a sphere it is the index among the spheres. For a cylinder it is
/// the number of spheres plus the index among the cylinders. [`ObjectRef`] distinguishes the two kinds.
pub type ObjectId = u32;

/// The number that stands for no object. It is the start object of a camera ray.
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
    /// Returns kind and index of the object with the number `id`.
    #[inline(always)]
    pub fn of(objects: &impl Objects, id: ObjectId) -> Self {
        Self::of_number(id, objects.sphere_count())
    }

    /// Returns kind and index of the object with the number `id`, in a scene of `sphere_count` spheres.
    #[inline(always)]
    pub(crate) fn of_number(id: ObjectId, sphere_count: usize) -> Self {
        match (id as usize).checked_sub(sphere_count) {
            None => Self::Sphere(id as usize),
            Some(index) => Self::Cylinder(index),
        }
    }

    /// Returns the object's number, in a scene of `sphere_count` spheres.
    #[inline(always)]
    pub(crate) const fn number(self, sphere_count: usize) -> ObjectId {
        match self {
            Self::Sphere(index) => index as ObjectId,
            Self::Cylinder(index) => (sphere_count + index) as ObjectId,
        }
    }
}

/// Returns the index, among the cylinders, of the cylinder with the number `id`. It saves the branch of
/// [`ObjectRef::of`] if the kind is known.
#[inline(always)]
pub(crate) fn cylinder_index(objects: &impl Objects, id: ObjectId) -> usize {
    id as usize - objects.sphere_count()
}

/// Returns the number of objects.
pub fn count(objects: &impl Objects) -> usize {
    objects.sphere_count() + objects.cylinder_count()
}

/// Returns the object's place among all objects of the scene file, from 0.
pub fn file_index_of(objects: &impl Objects, id: ObjectId) -> u32 {
    match ObjectRef::of(objects, id) {
        ObjectRef::Sphere(index) => objects.sphere(index).file_index,
        ObjectRef::Cylinder(index) => objects.cylinder(index).file_index,
    }
}

/// Returns centre and radius of the smallest sphere around an object, in scene units and rounded.
pub(crate) fn bounding_sphere(objects: &impl Objects, id: ObjectId) -> (Vec3, f64) {
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
