//! The implementations that are held against the oracle.
//!
//! Another one, such as a shader, joins by implementing [`Method`]: it gets cases and says what each ray meets.

mod projected;

use std::hint::black_box;
use std::marker::PhantomData;
use std::time::Instant;

use cpu::certified::{Certified, Intersect, Textbook};
use cpu::cylinder::{CylinderRecord, Part};
use cpu::real::Real;
use cpu::scene::Shape;
use cpu::sphere::SphereRecord;
use cpu::{Hit, Ray, Vec3};

use crate::case::Case;

/// What an implementation says of a case in which the ray meets the object.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Answer {
    /// Where.
    pub lambda: f64,
    /// What.
    pub part: Part,
    /// The point, as the implementation rounds it.
    pub point: Vec3,
    /// Whether it finds the ray outside.
    pub front: bool,
}

/// An implementation of both intersections.
pub trait Method {
    /// Its name in tables.
    fn name(&self) -> &'static str;
    /// Its unit roundoff.
    fn unit_roundoff(&self) -> f64 {
        f64::EPSILON / 2.0
    }
    /// What it says of each case. One call for all, so that a device can take them in one go.
    fn answer(&self, cases: &[Case]) -> Vec<Option<Answer>>;
    /// What a test costs, where that is known: in nanoseconds, the object's record being ready.
    fn nanoseconds(&self, _cases: &[Case]) -> Option<f64> {
        None
    }
}

/// All that run on this machine, in the order of the table's columns.
#[must_use]
pub fn all() -> Vec<Box<dyn Method>> {
    vec![
        Box::new(Double::<Textbook>(TEXTBOOK, PhantomData)),
        Box::new(Double::<Certified>(CERTIFIED, PhantomData)),
        Box::new(Single {
            name: "textbook f32",
            sphere: SphereRecord::intersect,
            cylinder: |cylinder, ray| cylinder.intersect(ray),
        }),
        Box::new(Single { name: PROJECTED, sphere: projected::sphere, cylinder: projected::cylinder }),
    ]
}

/// The name of what the specification writes down.
pub const TEXTBOOK: &str = "textbook f64";
/// The name of what the renderer uses.
pub const CERTIFIED: &str = "certified f64";
/// The name of what a shader without double precision should use.
pub const PROJECTED: &str = "projected f32";

struct Double<P>(&'static str, PhantomData<P>);

impl<P: Intersect> Method for Double<P> {
    fn name(&self) -> &'static str {
        self.0
    }

    fn answer(&self, cases: &[Case]) -> Vec<Option<Answer>> {
        let answer = |case: &Case| match &case.shape {
            Shape::Sphere(sphere) => {
                let record = SphereRecord::new(sphere.center, sphere.radius);
                let lambda = P::sphere(&record, &case.ray)?;
                Some(arrived(&case.ray, lambda, Part::Side, |point| record.outward(point)))
            }
            Shape::Cylinder(cylinder) => {
                let record = CylinderRecord::new(cylinder.center, cylinder.radius, cylinder.axis);
                let (lambda, part) = P::cylinder(&record, &cylinder.axis, &case.ray)?;
                Some(arrived(&case.ray, lambda, part, |point| record.outward(part, point)))
            }
        };
        cases.iter().map(answer).collect()
    }

    fn nanoseconds(&self, cases: &[Case]) -> Option<f64> {
        let (mut spheres, mut cylinders) = (Vec::new(), Vec::new());
        for case in cases {
            match &case.shape {
                Shape::Sphere(sphere) => spheres.push((SphereRecord::new(sphere.center, sphere.radius), case.ray)),
                Shape::Cylinder(cylinder) => {
                    let record = CylinderRecord::new(cylinder.center, cylinder.radius, cylinder.axis);
                    cylinders.push((record, cylinder.axis, case.ray));
                }
            }
        }
        let pass = || {
            let start = Instant::now();
            for (record, ray) in &spheres {
                black_box(P::sphere(record, ray));
            }
            for (record, axis, ray) in &cylinders {
                black_box(P::cylinder(record, axis, ray));
            }
            start.elapsed().as_secs_f64() * 1e9 / cases.len() as f64
        };
        // The least of a few: what else the machine does only adds.
        (0..3).map(|_| pass()).reduce(f64::min)
    }
}

/// Single precision.
struct Single {
    name: &'static str,
    sphere: Intersection<SphereRecord<f32>, f32>,
    cylinder: Intersection<CylinderRecord<f32>, (f32, Part)>,
}

type Intersection<R, H> = fn(&R, &Ray<f32>) -> Option<H>;

impl Method for Single {
    fn name(&self) -> &'static str {
        self.name
    }

    fn unit_roundoff(&self) -> f64 {
        f64::from(f32::EPSILON) / 2.0
    }

    fn answer(&self, cases: &[Case]) -> Vec<Option<Answer>> {
        let narrow = |vector: Vec3| vector.map(|component| component as f32);
        let answer = |case: &Case| {
            let ray = Ray { origin: narrow(case.ray.origin), direction: narrow(case.ray.direction) };
            match &case.shape {
                Shape::Sphere(sphere) => {
                    let record = SphereRecord::new(narrow(sphere.center), sphere.radius as f32);
                    let lambda = (self.sphere)(&record, &ray)?;
                    Some(arrived(&ray, lambda, Part::Side, |point| record.outward(point)))
                }
                Shape::Cylinder(cylinder) => {
                    let axis = narrow(cylinder.axis);
                    let record = CylinderRecord::new(narrow(cylinder.center), cylinder.radius as f32, axis);
                    let (lambda, part) = (self.cylinder)(&record, &ray)?;
                    Some(arrived(&ray, lambda, part, |point| record.outward(part, point)))
                }
            }
        };
        cases.iter().map(answer).collect()
    }
}

fn arrived<T: Real<Mask = bool> + Into<f64>>(
    ray: &Ray<T>,
    lambda: T,
    part: Part,
    outward: impl Fn(Vec3<T>) -> Vec3<T>,
) -> Answer {
    let point = ray.at(lambda);
    let front = Hit::facing(ray.direction, point, outward(point)).front;
    Answer { lambda: lambda.into(), part, point: point.map(Into::into), front }
}
