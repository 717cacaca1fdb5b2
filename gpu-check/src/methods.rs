//! Makes the intersections in WGSL available as methods of `stability`, which compares them with exact arithmetic.

use std::marker::PhantomData;
use std::rc::Rc;
use std::time::Duration;

use cpu::Vec3;
use cpu::internals::geometry::cylinder::CylinderPart;
use cpu::internals::input::scene::Shape;
use shaders::Library;
use stability::case::Case;
use stability::methods::{Answer, Failure, Method, Stopwatch};

use crate::reader::Reader;
use crate::rows::results;
use crate::{Error, Float, Gpu, Pipeline};

/// Name of the method with the plain formulas in f64.
pub const PLAIN: &str = "WGSL plain f64";
/// Name of the method with the plain formulas in f32.
pub const PLAIN_SINGLE: &str = "WGSL plain f32";
/// Name of the method with the projected form in f32.
pub const PROJECTED: &str = "WGSL projected f32";

/// Returns all methods, in the order of the table's rows.
///
/// # Errors
/// The errors of [`Pipeline::new`].
pub fn all(gpu: Gpu) -> Result<Vec<Box<dyn Method>>, Error> {
    let gpu = Rc::new(gpu);
    Ok(vec![
        Box::new(Wgsl::<f64>::new(PLAIN, &gpu, ["kernels/sphere", "kernels/cylinder"])?),
        Box::new(Wgsl::<f32>::new(PLAIN_SINGLE, &gpu, ["kernels/sphere", "kernels/cylinder"])?),
        Box::new(Wgsl::<f32>::new(PROJECTED, &gpu, ["kernels/projected_sphere", "kernels/projected_cylinder"])?),
    ])
}

/// Number of numbers of a sphere's and of a cylinder's case; see [`rows`].
const INPUTS: [usize; 2] = [10, 13];
/// Number of numbers of a `HitReport` in `kernels/hit_report.wgsl`.
const OUTPUTS: usize = 10;

/// A method: a kernel for spheres and a kernel for cylinders, compiled for one precision.
struct Wgsl<T> {
    name: &'static str,
    gpu: Rc<Gpu>,
    pipelines: [Pipeline; 2],
    precision: PhantomData<T>,
}

impl<T: Float> Wgsl<T> {
    fn new(name: &'static str, gpu: &Rc<Gpu>, [sphere, cylinder]: [&str; 2]) -> Result<Self, Error> {
        let compile = |kernel| Pipeline::new(gpu, &Library::standard().compose(kernel, T::PRECISION)?, &[]);
        let pipelines = [compile(sphere)?, compile(cylinder)?];
        Ok(Self { name, gpu: Rc::clone(gpu), pipelines, precision: PhantomData })
    }

    /// Returns the reports for rows of spheres if `shape` is 0, or of cylinders if it is 1, and the time of the device.
    fn reports(&self, shape: usize, rows: &[T]) -> Result<(Vec<T>, Duration), Error> {
        results(&self.gpu, &self.pipelines[shape], [INPUTS[shape], OUTPUTS], rows)
    }
}

impl<T: Float> Method for Wgsl<T> {
    fn name(&self) -> &'static str {
        self.name
    }

    fn unit_roundoff(&self) -> f64 {
        match T::PRECISION {
            shaders::Precision::F32 => f64::from(f32::EPSILON) / 2.0,
            shaders::Precision::F64 => f64::EPSILON / 2.0,
        }
    }

    fn answer(&self, cases: &[Case]) -> Result<Vec<Option<Answer>>, Failure> {
        let (reports, _) = self.reports(shape(cases), &rows(cases))?;
        Ok(reports.chunks(OUTPUTS).map(answer).collect())
    }

    /// Returns a stopwatch that measures the device's time. Unlike the renderer's time, it includes computing the
    /// records of the objects, and all cores of the processor work.
    fn stopwatch<'a>(&'a self, cases: &[Case]) -> Result<Stopwatch<'a>, Failure> {
        let (shape, rows) = (shape(cases), rows(cases));
        Ok(Box::new(move || Ok(self.reports(shape, &rows)?.1)))
    }
}

/// Returns 0 if the cases are spheres, and 1 if they are cylinders. They must be all of one shape.
fn shape(cases: &[Case]) -> usize {
    usize::from(matches!(cases.first(), Some(Case { shape: Shape::Cylinder(_), .. })))
}

/// Returns the cases as rows of inputs for the kernels.
#[must_use]
pub fn rows<T: Float>(cases: &[Case]) -> Vec<T> {
    let mut rows = Vec::new();
    for Case { shape, ray } in cases {
        let mut vector = |vector: Vec3| rows.extend(vector.to_array().map(T::of));
        vector(ray.origin);
        vector(ray.direction);
        match shape {
            Shape::Sphere(sphere) => {
                vector(sphere.center);
                rows.push(T::of(sphere.radius));
            }
            Shape::Cylinder(cylinder) => {
                vector(cylinder.center);
                rows.push(T::of(cylinder.radius));
                rows.extend(cylinder.axis.to_array().map(T::of));
            }
        }
    }
    rows
}

/// Returns the answer in one row of a kernel's output, which is a `HitReport`, or `None` for a miss.
fn answer<T: Float>(report: &[T]) -> Option<Answer> {
    let mut report = Reader(report);
    let some = report.number().wide() == 1.0;
    let lambda = report.number().wide();
    let part = match report.number().wide() {
        1.0 => CylinderPart::Top,
        2.0 => CylinderPart::Bottom,
        _ => CylinderPart::Side,
    };
    let front = report.number().wide() == 1.0;
    let point = report.vector().map(Float::wide);
    some.then_some(Answer { lambda, part, point, front })
}
