//! The hit of a ray on one object.

use crate::exact::order::Surface;
use crate::geometry::{cylinder::CylinderPart, cylinder::CylinderRecord, ray::Ray, sphere::SphereRecord};
use crate::input::scene::{Cylinder, Shape, Sphere};
use crate::math::vec3::Vec3;
use crate::reference::{intersect::Intersect, nearest::in_range};

/// A hit of a ray on an object: where it is, and where the surface faces there. It does not say which object is hit;
/// the caller keeps that object's material.
#[derive(Clone, Copy)]
pub(super) struct Hit {
    pub lambda: f64,
    pub surface: Surface,
    pub point: Vec3,
    /// The normal that points out of the object.
    pub outward: Vec3,
}

impl Hit {
    /// Returns the ray's hit on an object with this shape, at the lambda and on the part that `P` returns
    /// (specification, section 9). If there is no hit, the result is `None`.
    pub(super) fn new<P: Intersect>(shape: &Shape, ray: &Ray) -> Option<Self> {
        let (lambda, surface) = match *shape {
            Shape::Sphere(Sphere { center, radius }) => {
                let record = SphereRecord::new(center, radius);
                (P::sphere(&record, ray)?, Surface::Sphere(record))
            }
            Shape::Cylinder(Cylinder { center, radius, axis: file_axis }) => {
                let record = CylinderRecord::new(center, radius, file_axis);
                let (lambda, part) = P::cylinder(&record, &file_axis, ray)?;
                (lambda, Surface::Cylinder(record, file_axis, part))
            }
        };
        let point = ray.origin + ray.direction * lambda;
        let outward = match surface {
            Surface::Sphere(sphere) => (point - sphere.center) / sphere.radius,
            Surface::Cylinder(cylinder, file_axis, part) => {
                let (axis, _) = file_axis.unit_and_length();
                match part {
                    CylinderPart::Side => (point - cylinder.center) - axis * (point - cylinder.center).dot(axis),
                    CylinderPart::Top => axis,
                    CylinderPart::Bottom => -axis,
                }
            }
        };
        in_range(lambda).then_some(Self { lambda, surface, point, outward })
    }

    /// Whether the hit is on a cap of a cylinder.
    pub(super) fn is_on_cap(&self) -> bool {
        matches!(self.surface, Surface::Cylinder(.., CylinderPart::Top | CylinderPart::Bottom))
    }
}
