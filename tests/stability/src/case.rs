//! A case: one ray and one object. Their numbers count as exact. The oracle and every implementation intersect the
//! case.

use cpu::internals::input::scene::{Cylinder, Shape, Sphere};
use cpu::{Ray, Vec3};

/// A case: one ray and one object, which are intersected.
#[derive(Clone, Copy, Debug)]
pub struct Case {
    /// The object with which the ray is intersected.
    pub shape: Shape,
    /// The ray.
    pub ray: Ray,
}

impl Case {
    /// Returns the case of a sphere and a ray from `origin` along `direction`.
    #[must_use]
    pub fn sphere(center: Vec3, radius: f64, origin: Vec3, direction: Vec3) -> Self {
        Self { shape: Shape::Sphere(Sphere { center, radius }), ray: Ray { origin, direction } }
    }

    /// Returns the case of a cylinder and a ray from `origin` along `direction`.
    #[must_use]
    pub fn cylinder(cylinder: Cylinder, origin: Vec3, direction: Vec3) -> Self {
        Self { shape: Shape::Cylinder(cylinder), ray: Ray { origin, direction } }
    }

    /// Returns the case with every number rounded to single precision. An implementation in single precision gets these
    /// numbers.
    #[must_use]
    pub fn single(&self) -> Self {
        let round = |vector: Vec3| vector.map(|component| f64::from(component as f32));
        let shape = match self.shape {
            Shape::Sphere(Sphere { center, radius }) => {
                Shape::Sphere(Sphere { center: round(center), radius: f64::from(radius as f32) })
            }
            Shape::Cylinder(Cylinder { center, radius, axis }) => {
                let radius = f64::from(radius as f32);
                Shape::Cylinder(Cylinder { center: round(center), radius, axis: round(axis) })
            }
        };
        Self { shape, ray: Ray { origin: round(self.ray.origin), direction: round(self.ray.direction) } }
    }

    /// Returns the object's centre.
    pub fn center(&self) -> Vec3 {
        let (Shape::Sphere(Sphere { center, .. }) | Shape::Cylinder(Cylinder { center, .. })) = self.shape;
        center
    }

    /// Returns the size `S` of the case: the sum of the origin's distance from the centre, the radius and the height.
    #[must_use]
    pub fn size(&self) -> f64 {
        let distance = (self.ray.origin - self.center()).length();
        distance
            + match self.shape {
                Shape::Sphere(sphere) => sphere.radius,
                Shape::Cylinder(cylinder) => cylinder.radius + cylinder.axis.length(),
            }
    }
}
