//! Spheres and cylinders as the [conservative tests](crate::accel::conservative) need them.

use crate::accel::object::{ObjectId, ObjectRef};
use crate::geometry::{cylinder::CylinderRecord, sphere::SphereRecord};
use crate::layout::Objects;
use crate::math::{vec3::Vec3, vec3::broadcast};

/// How far rounding may move a point of the scene, relative to the scene's largest coordinate: thousands of roundings.
pub const SLACK: f64 = 8192.0 * f64::EPSILON;

/// A sphere or a cylinder; `T` is a number or lanes. A test of a sphere uses only centre and radius.
#[derive(Clone, Copy, Debug)]
pub struct Target<T = f64> {
    /// Its centre.
    pub center: Vec3<T>,
    /// Of length one; null for a sphere.
    pub axis: Vec3<T>,
    /// The square of its radius.
    pub radius_squared: T,
    /// The square of the radius of the sphere around it.
    pub bounding_radius_squared: T,
    /// Half its height, enlarged by how far rounding may move points of the caps; infinite for a sphere.
    pub half_height: T,
}

broadcast!(Target: center, axis; radius_squared, bounding_radius_squared, half_height);

impl<T: Copy> Target<T> {
    /// The numbers, as [lanes of objects](crate::accel::object_lanes) keep them.
    pub fn numbers(&self) -> [T; Target::NUMBERS] {
        let Self { center: c, axis: a, radius_squared, bounding_radius_squared, half_height } = *self;
        [c.x, c.y, c.z, a.x, a.y, a.z, radius_squared, bounding_radius_squared, half_height]
    }

    /// The target with these [numbers](Self::numbers).
    #[inline(always)]
    pub fn of_numbers(numbers: [T; Target::NUMBERS]) -> Self {
        let [x, y, z, ax, ay, az, radius_squared, bounding_radius_squared, half_height] = numbers;
        let (center, axis) = (Vec3::new(x, y, z), Vec3::new(ax, ay, az));
        Self { center, axis, radius_squared, bounding_radius_squared, half_height }
    }
}

impl Target {
    /// How many numbers a target has.
    pub const NUMBERS: usize = 9;

    /// The object at `id`, in a scene with this [largest coordinate](crate::accel::extent::Extent::max_coordinate).
    #[inline(always)]
    pub fn of<O: Objects>(objects: &O, id: ObjectId, max_coordinate: f64) -> Self {
        match ObjectRef::of(objects, id) {
            ObjectRef::Sphere(index) => Self::sphere(&objects.sphere(index).record),
            ObjectRef::Cylinder(index) => Self::cylinder(&objects.cylinder(index).record, max_coordinate),
        }
    }

    /// The sphere: for the tests of cylinders it is one without an axis, and of any height.
    #[inline(always)]
    pub fn sphere(&SphereRecord { center, radius_squared, .. }: &SphereRecord) -> Self {
        let (axis, half_height) = (Vec3::ZERO, f64::INFINITY);
        Self { center, axis, radius_squared, bounding_radius_squared: radius_squared, half_height }
    }

    /// The cylinder, in a scene with this largest coordinate.
    #[inline(always)]
    pub fn cylinder(record: &CylinderRecord, max_coordinate: f64) -> Self {
        let CylinderRecord { center, axis, radius_squared, half_height, .. } = *record;
        let bounding_radius_squared = radius_squared + half_height * half_height;
        let half_height = half_height + max_coordinate * SLACK;
        Self { center, axis, radius_squared, bounding_radius_squared, half_height }
    }
}
