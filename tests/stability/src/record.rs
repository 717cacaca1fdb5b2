//! The object of a case in the form that formulas use.

use cpu::internals::exact;
use cpu::internals::exact::error_bound::Decision;
use cpu::internals::geometry::cylinder::{CylinderPart, CylinderRecord};
use cpu::internals::geometry::sphere::SphereRecord;
use cpu::internals::input::scene::{Cylinder, Shape, Sphere};
use cpu::internals::math::real::Real;
use cpu::internals::math::rounding::Rounding;
use cpu::{Ray, Vec3};

use crate::case::Case;

/// The lambda and the part of a hit, or `None` for a miss. The part of a sphere is always the side.
pub type Found<T = f64> = Option<(T, CylinderPart)>;

/// The record of an object, in one number type.
#[derive(Clone, Copy, Debug)]
pub enum Record<T = f64> {
    /// The record of a sphere.
    Sphere(SphereRecord<T>),
    /// The record of a cylinder, and its axis in the scene file.
    Cylinder(CylinderRecord<T>, Vec3<T>),
}

impl Case {
    /// Returns the record and the ray of the case, in the number type `T`.
    #[must_use]
    pub fn of<T: Real>(&self) -> (Record<T>, Ray<T>) {
        let ray = Ray { origin: self.ray.origin.map(T::of), direction: self.ray.direction.map(T::of) };
        (Record::new(&self.shape), ray)
    }
}

impl<T: Real> Record<T> {
    /// Returns the record of an object.
    #[must_use]
    pub fn new(shape: &Shape) -> Self {
        match shape {
            Shape::Sphere(Sphere { center, radius }) => {
                Self::Sphere(SphereRecord::new(center.map(T::of), T::of(*radius)))
            }
            Shape::Cylinder(Cylinder { center, radius, axis }) => {
                let axis = axis.map(T::of);
                Self::Cylinder(CylinderRecord::new(center.map(T::of), T::of(*radius), axis), axis)
            }
        }
    }

    /// Returns a vector that points out of the object at `point`, which is on `part`.
    pub fn outward(&self, part: CylinderPart, point: Vec3<T>) -> Vec3<T> {
        match self {
            Self::Sphere(record) => record.outward(point),
            Self::Cylinder(record, _) => record.outward(part, point),
        }
    }
}

impl<T: Real<Mask = bool>> Record<T> {
    /// Returns the hit by one function for spheres and another one for cylinders.
    pub fn by(
        &self,
        ray: &Ray<T>,
        sphere: impl Fn(&SphereRecord<T>, &Ray<T>) -> Option<T>,
        cylinder: impl Fn(&CylinderRecord<T>, &Vec3<T>, &Ray<T>) -> Found<T>,
    ) -> Found<T> {
        match self {
            Self::Sphere(record) => sphere(record, ray).map(|lambda| (lambda, CylinderPart::Side)),
            Self::Cylinder(record, axis) => cylinder(record, axis, ray),
        }
    }

    /// Returns the hit by the plain formulas of the specification.
    #[must_use]
    pub fn plain(&self, ray: &Ray<T>) -> Found<T> {
        self.by(ray, SphereRecord::intersect, |record, _, ray| record.intersect(ray))
    }
}

/// Returns a sphere's hit as that of its only part.
fn on_the_side<T>(decision: Decision<Option<T>>) -> Decision<Found<T>> {
    match decision {
        Decision::Certain(lambda) => Decision::Certain(lambda.map(|lambda| (lambda, CylinderPart::Side))),
        Decision::Uncertain => Decision::Uncertain,
    }
}

impl<T: Rounding<Mask = bool>> Record<T> {
    /// Returns the hit by the plain formulas with their error bounds.
    pub fn filtered(&self, ray: &Ray<T>) -> Decision<Found<T>> {
        match self {
            Self::Sphere(record) => on_the_side(exact::sphere::filtered(record, ray)),
            Self::Cylinder(record, _) => exact::cylinder::filtered(record, ray),
        }
    }
}

impl Record {
    /// Returns the exact intersection, with all fallbacks.
    #[must_use]
    pub fn exact(&self, ray: &Ray) -> Found {
        self.by(ray, exact::sphere::intersect, exact::cylinder::intersect)
    }

    /// Returns the hit by the compensated formulas with their error bounds.
    #[must_use]
    pub fn compensated(&self, ray: &Ray) -> Decision<Found> {
        match self {
            Self::Sphere(record) => on_the_side(exact::sphere_compensated::compensated(record, ray)),
            Self::Cylinder(record, axis) => exact::cylinder::compensated(record, axis, ray),
        }
    }

    /// Whether dyadic arithmetic answers, because the plain and the compensated formulas are uncertain.
    #[must_use]
    pub fn needs_dyadic(&self, ray: &Ray) -> bool {
        [self.filtered(ray), self.compensated(ray)] == [Decision::Uncertain; 2]
    }
}

#[cfg(test)]
mod tests;
