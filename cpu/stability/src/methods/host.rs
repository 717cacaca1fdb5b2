//! Formulas in Rust as a [`Method`], which runs and is timed on this machine.

use std::hint::black_box;
use std::marker::PhantomData;
use std::time::Instant;

use cpu::internals::Hit;
use cpu::internals::geometry::cylinder::{CylinderPart, CylinderRecord};
use cpu::internals::geometry::sphere::SphereRecord;
use cpu::internals::input::scene::{Cylinder, Shape, Sphere};
use cpu::internals::math::real::Real;
use cpu::{Ray, Vec3};

use super::formulas::Formulas;
use super::{Answer, Failure, Method, Stopwatch};
use crate::case::Case;

/// Formulas in Rust, with the name of the method.
pub struct Host<F> {
    name: &'static str,
    formulas: PhantomData<F>,
}

impl<F> Host<F> {
    pub const fn new(name: &'static str) -> Self {
        Self { name, formulas: PhantomData }
    }
}

impl<F: Formulas> Method for Host<F> {
    fn name(&self) -> &'static str {
        self.name
    }

    fn unit_roundoff(&self) -> f64 {
        F::UNIT_ROUNDOFF
    }

    fn answer(&self, cases: &[Case]) -> Result<Vec<Option<Answer>>, Failure> {
        let answer = |case: &Case| {
            let ray = ray::<F::Number>(case);
            match &case.shape {
                Shape::Sphere(sphere) => {
                    let record = sphere_record(sphere);
                    let lambda = F::sphere(&record, &ray)?;
                    Some(answer_at(&ray, lambda, CylinderPart::Side, |point| record.outward(point)))
                }
                Shape::Cylinder(cylinder) => {
                    let (record, axis) = cylinder_record(cylinder);
                    let (lambda, part) = F::cylinder(&record, &axis, &ray)?;
                    Some(answer_at(&ray, lambda, part, |point| record.outward(part, point)))
                }
            }
        };
        Ok(cases.iter().map(answer).collect())
    }

    /// The records of the objects are computed before the measured time begins, as in the renderer.
    fn stopwatch<'a>(&'a self, cases: &[Case]) -> Result<Stopwatch<'a>, Failure> {
        let (mut spheres, mut cylinders) = (Vec::new(), Vec::new());
        for case in cases {
            let ray = ray::<F::Number>(case);
            match &case.shape {
                Shape::Sphere(sphere) => spheres.push((sphere_record(sphere), ray)),
                Shape::Cylinder(cylinder) => cylinders.push((cylinder_record(cylinder), ray)),
            }
        }
        Ok(Box::new(move || {
            let start = Instant::now();
            for (record, ray) in &spheres {
                black_box(F::sphere(record, ray));
            }
            for ((record, axis), ray) in &cylinders {
                black_box(F::cylinder(record, axis, ray));
            }
            Ok(start.elapsed())
        }))
    }
}

fn vector<T: Real>(vector: Vec3) -> Vec3<T> {
    vector.map(T::of)
}

fn ray<T: Real>(case: &Case) -> Ray<T> {
    Ray { origin: vector(case.ray.origin), direction: vector(case.ray.direction) }
}

fn sphere_record<T: Real>(sphere: &Sphere) -> SphereRecord<T> {
    SphereRecord::new(vector(sphere.center), T::of(sphere.radius))
}

/// Returns the record of a cylinder, and its axis in the scene file.
fn cylinder_record<T: Real>(cylinder: &Cylinder) -> (CylinderRecord<T>, Vec3<T>) {
    let axis = vector(cylinder.axis);
    (CylinderRecord::new(vector(cylinder.center), T::of(cylinder.radius), axis), axis)
}

fn answer_at<T: Real<Mask = bool> + Into<f64>>(
    ray: &Ray<T>,
    lambda: T,
    part: CylinderPart,
    outward: impl Fn(Vec3<T>) -> Vec3<T>,
) -> Answer {
    let point = ray.at(lambda);
    let front = Hit::facing(ray.direction, point, outward(point)).front;
    Answer { lambda: lambda.into(), part, point: point.map(Into::into), front }
}
