//! One ray and one object, as exact numbers: what the oracle and every implementation are asked about.

use cpu::internals::input::scene::{Cylinder, Shape, Sphere};
use cpu::{Ray, Vec3};

/// One ray and one object.
#[derive(Clone, Copy, Debug)]
pub struct Case {
    /// The object.
    pub shape: Shape,
    /// The ray that is tried on it.
    pub ray: Ray,
}

impl Case {
    /// A ray from `origin` along `direction`, and a sphere.
    #[must_use]
    pub fn sphere(center: Vec3, radius: f64, origin: Vec3, direction: Vec3) -> Self {
        Self { shape: Shape::Sphere(Sphere { center, radius }), ray: Ray { origin, direction } }
    }

    /// A ray from `origin` along `direction`, and a cylinder.
    #[must_use]
    pub fn cylinder(cylinder: Cylinder, origin: Vec3, direction: Vec3) -> Self {
        Self { shape: Shape::Cylinder(cylinder), ray: Ray { origin, direction } }
    }

    /// The case with every number rounded to single precision. To an implementation in single precision these are
    /// the exact inputs.
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

    /// The object's centre.
    #[must_use]
    pub fn center(&self) -> Vec3 {
        match self.shape {
            Shape::Sphere(sphere) => sphere.center,
            Shape::Cylinder(cylinder) => cylinder.center,
        }
    }

    /// `S`, the size of what an intersection has to resolve: distance of the origin from the centre, radius, height.
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
