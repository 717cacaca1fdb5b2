//! Spheres and cylinders as the [filter](crate::accel::conservative) in double precision sees them: one, several in
//! lanes, or rows of them.

use crate::geometry::cylinder::CylinderRecord;
use crate::geometry::sphere::SphereRecord;
use crate::math::vec3::Vec3;

/// By its part of the scene's reach, how far rounding may move a point of the scene, many times over.
pub const SLACK: f64 = 8192.0 * f64::EPSILON;

/// What the filter knows of a sphere; a number, lanes, or an array of each.
#[derive(Clone, Copy, Debug)]
pub struct ConservativeSphere<T = f64> {
    /// Its centre.
    pub center: Vec3<T>,
    /// The square of its radius.
    pub radius_squared: T,
}

/// What the filter knows of a cylinder.
#[derive(Clone, Copy, Debug)]
pub struct ConservativeCylinder<T = f64> {
    /// Its centre.
    pub center: Vec3<T>,
    /// Of length one; null for a sphere.
    pub axis: Vec3<T>,
    /// The square of its radius.
    pub radius_squared: T,
    /// The squares of its radius and of half its height: no point of it is farther from the centre than their root.
    pub squares: T,
    /// Half the distance of its bases, rounding included.
    pub half_height: T,
}

impl ConservativeSphere {
    /// The sphere.
    #[inline(always)]
    pub fn new(record: &SphereRecord) -> Self {
        Self { center: record.center, radius_squared: record.radius_squared }
    }

    /// The same to the filter: a cylinder without an axis, and of any height.
    pub fn as_cylinder(self) -> ConservativeCylinder {
        let Self { center, radius_squared } = self;
        ConservativeCylinder {
            center,
            axis: Vec3::ZERO,
            radius_squared,
            squares: radius_squared,
            half_height: f64::INFINITY,
        }
    }
}

impl ConservativeCylinder {
    /// The cylinder, in a scene of this [reach](crate::accel::extent::Extent::reach).
    #[inline(always)]
    pub fn new(record: &CylinderRecord, reach: f64) -> Self {
        let CylinderRecord { center, axis, radius_squared, half_height, .. } = *record;
        let squares = radius_squared + half_height * half_height;
        Self { center, axis, radius_squared, squares, half_height: half_height + reach * SLACK }
    }
}
