//! Spheres and cylinders in the form that the [conservative tests](crate::accel::may_hit::conservative) use.

use crate::accel::{extent::Extent, object::ObjectId, object::ObjectRef, object::count};
use crate::geometry::{cylinder::CylinderRecord, sphere::SphereRecord};
use crate::input::{error::Error, error::with_room};
use crate::layout::{OBJECTS, Objects};
use crate::math::{vec3::Vec3, vec3::broadcast};

/// A bound of the rounding error in a computed hit point, relative to the scene's largest coordinate. It is 16,384 `u`,
/// with the unit roundoff `u = EPSILON / 2`, or 1.8e-12. [`Target::cylinder`] makes a cylinder longer by this error, so
/// that no ray whose hit point lies on a cap's rim is discarded. The true error is hundreds of times smaller
/// (docs/margins.md).
pub const SLACK: f64 = 8192.0 * f64::EPSILON;

/// Maximum number of objects of a scene that are tested for several rays in lanes, one object after the other. With
/// more objects, a tree that takes one ray at a time is faster.
const MOST_IN_LANES: usize = 64;

/// Returns all objects of a scene, in the order of their [numbers](ObjectId), for tests with one ray in each lane. The
/// list is empty if there are too many objects, or if the tests are not valid.
///
/// # Errors
/// [`Error::OutOfMemory`] if memory is short.
pub fn targets(objects: &impl Objects, extent: &Extent) -> Result<Vec<Target>, Error> {
    let count = if extent.is_ordinary() && count(objects) <= MOST_IN_LANES { count(objects) } else { 0 };
    let mut targets = with_room(count, OBJECTS)?;
    targets.extend((0..count as ObjectId).map(|id| Target::of(objects, id, extent.max_coordinate)));
    Ok(targets)
}

/// A sphere or a cylinder; `T` is a number or lanes. A test of a sphere uses only centre and radius.
#[derive(Clone, Copy, Debug)]
pub struct Target<T = f64> {
    /// The object's centre.
    pub center: Vec3<T>,
    /// The direction of a cylinder's axis, of length one. It is null for a sphere.
    pub axis: Vec3<T>,
    /// The square of the object's radius.
    pub radius_squared: T,
    /// The square of the radius of the smallest sphere around the object.
    pub bounding_radius_squared: T,
    /// Half of a cylinder's height, plus the distance by which rounding may move points of the caps. It is infinite for
    /// a sphere.
    pub half_height: T,
}

broadcast!(Target: center, axis; radius_squared, bounding_radius_squared, half_height);

impl<T: Copy> Target<T> {
    /// Returns the target's numbers, in the order in which
    /// [`ObjectLanes`](crate::accel::may_hit::object_lanes::ObjectLanes) stores them.
    pub(crate) fn numbers(&self) -> [T; Target::NUMBERS] {
        let Self { center: c, axis: a, radius_squared, bounding_radius_squared, half_height } = *self;
        [c.x, c.y, c.z, a.x, a.y, a.z, radius_squared, bounding_radius_squared, half_height]
    }

    /// Returns the target with these [numbers](Self::numbers).
    #[inline(always)]
    pub(crate) fn of_numbers(numbers: [T; Target::NUMBERS]) -> Self {
        let [x, y, z, ax, ay, az, radius_squared, bounding_radius_squared, half_height] = numbers;
        let (center, axis) = (Vec3::new(x, y, z), Vec3::new(ax, ay, az));
        Self { center, axis, radius_squared, bounding_radius_squared, half_height }
    }
}

impl Target {
    /// Number of numbers in a target.
    pub const NUMBERS: usize = 9;

    /// Returns the object with the number `id`, in a scene with this
    /// [largest coordinate](crate::accel::extent::Extent::max_coordinate).
    #[inline(always)]
    pub(crate) fn of<O: Objects>(objects: &O, id: ObjectId, max_coordinate: f64) -> Self {
        match ObjectRef::of(objects, id) {
            ObjectRef::Sphere(index) => Self::sphere(&objects.sphere(index).record),
            ObjectRef::Cylinder(index) => Self::cylinder(&objects.cylinder(index).record, max_coordinate),
        }
    }

    /// Returns the sphere. The tests of cylinders treat it as a cylinder without an axis and with infinite height.
    #[inline(always)]
    pub(crate) fn sphere(&SphereRecord { center, radius_squared, .. }: &SphereRecord) -> Self {
        let (axis, half_height) = (Vec3::ZERO, f64::INFINITY);
        Self { center, axis, radius_squared, bounding_radius_squared: radius_squared, half_height }
    }

    /// Returns the cylinder, in a scene with this largest coordinate.
    #[inline(always)]
    pub(crate) fn cylinder(record: &CylinderRecord, max_coordinate: f64) -> Self {
        let CylinderRecord { center, axis, radius_squared, half_height, .. } = *record;
        let bounding_radius_squared = radius_squared + half_height * half_height;
        let half_height = half_height + max_coordinate * SLACK;
        Self { center, axis, radius_squared, bounding_radius_squared, half_height }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_the_half_height_of_a_cylinder_has_the_slack() {
        let record = CylinderRecord::new(Vec3::ZERO, 3.0, Vec3::new(0.0, 8.0, 0.0));
        let target = Target::cylinder(&record, 1e6);
        assert_eq!((target.radius_squared, target.bounding_radius_squared), (9.0, 25.0));
        assert_eq!(target.half_height, 4.0 + 1e6 * SLACK);
    }
}
