//! Formulas in Rust as a [`Method`], which runs and is timed on this machine.

use std::hint::black_box;
use std::marker::PhantomData;
use std::time::Instant;

use cpu::internals::geometry::sphere::SphereRecord;
use cpu::internals::geometry::{cylinder::CylinderRecord, ray::front_and_normal};
use cpu::internals::math::real::Real;
use cpu::{Ray, Vec3};

use super::{Answer, Failure, Method, Stopwatch};
use crate::case::Case;
use crate::record::{Found, Record};

/// A function for spheres of type `S`, and one for cylinders of type `C`, in the number type `T`. Each function has its
/// own type, so that the compiler inlines it into the loop whose time is measured.
pub struct Host<T, S, C> {
    name: &'static str,
    unit_roundoff: f64,
    sphere: S,
    cylinder: C,
    number: PhantomData<T>,
}

impl<T, S, C> Host<T, S, C>
where
    S: Fn(&SphereRecord<T>, &Ray<T>) -> Option<T>,
    C: Fn(&CylinderRecord<T>, &Vec3<T>, &Ray<T>) -> Found<T>,
{
    /// Returns the method with this name. `cylinder` also gets the axis in the scene file.
    pub const fn new(name: &'static str, unit_roundoff: f64, sphere: S, cylinder: C) -> Self {
        Self { name, unit_roundoff, sphere, cylinder, number: PhantomData }
    }
}

impl<T, S, C> Method for Host<T, S, C>
where
    T: Real<Mask = bool> + Into<f64>,
    S: Fn(&SphereRecord<T>, &Ray<T>) -> Option<T>,
    C: Fn(&CylinderRecord<T>, &Vec3<T>, &Ray<T>) -> Found<T>,
{
    fn name(&self) -> &'static str {
        self.name
    }

    fn unit_roundoff(&self) -> f64 {
        self.unit_roundoff
    }

    fn answer(&self, cases: &[Case]) -> Result<Vec<Option<Answer>>, Failure> {
        let answer = |case: &Case| {
            let (record, ray) = case.of::<T>();
            let (lambda, part) = record.by(&ray, &self.sphere, &self.cylinder)?;
            let point = ray.at(lambda);
            let (front, _) = front_and_normal(ray.direction, record.outward(part, point));
            Some(Answer { lambda: lambda.into(), part, point: point.map(Into::into), front })
        };
        Ok(cases.iter().map(answer).collect())
    }

    /// The records of the objects are computed before the measured time begins, as in the renderer.
    fn stopwatch<'a>(&'a self, cases: &[Case]) -> Result<Stopwatch<'a>, Failure> {
        let (mut spheres, mut cylinders) = (Vec::new(), Vec::new());
        for (record, ray) in cases.iter().map(Case::of::<T>) {
            match record {
                Record::Sphere(record) => spheres.push((record, ray)),
                Record::Cylinder(record, axis) => cylinders.push((record, axis, ray)),
            }
        }
        Ok(Box::new(move || {
            let start = Instant::now();
            for (record, ray) in &spheres {
                black_box((self.sphere)(record, ray));
            }
            for (record, axis, ray) in &cylinders {
                black_box((self.cylinder)(record, axis, ray));
            }
            Ok(start.elapsed())
        }))
    }
}
