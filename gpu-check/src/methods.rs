//! Makes the intersections in WGSL available as methods of `stability`, which compares them with exact arithmetic.

use std::rc::Rc;

use cpu::Vec3;
use cpu::internals::geometry::cylinder::CylinderPart;
use cpu::internals::input::scene::Shape;
use shaders::Library;
use stability::case::Case;
use stability::methods::{Answer, Failure, Method, Stopwatch};

use crate::check::RowKernel;
use crate::kernel::Reader;
use crate::kernels::{CYLINDER, PROJECTED_CYLINDER, PROJECTED_SPHERE, SPHERE};
use crate::{Error, Float, Formulas, Gpu, Kernel, Pipeline};

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
        Box::new(Wgsl::<f64>::new(PLAIN, &gpu, [SPHERE, CYLINDER])?),
        Box::new(Wgsl::<f32>::new(PLAIN_SINGLE, &gpu, [SPHERE, CYLINDER])?),
        Box::new(Wgsl::<f32>::new(PROJECTED, &gpu, [PROJECTED_SPHERE, PROJECTED_CYLINDER])?),
    ])
}

/// A method: a kernel for spheres and a kernel for cylinders, compiled for one precision.
struct Wgsl<T> {
    name: &'static str,
    gpu: Rc<Gpu>,
    kernels: [(RowKernel<T>, Pipeline); 2],
}

impl<T: Formulas> Wgsl<T> {
    fn new(name: &'static str, gpu: &Rc<Gpu>, kernels: [Kernel; 2]) -> Result<Self, Error> {
        let [spheres, cylinders] = kernels.map(|kernel| kernel.rows::<T>());
        let compiled = |kernel: RowKernel<T>| Ok::<_, Error>((kernel, kernel.compile(gpu, &Library::standard())?));
        let kernels = [compiled(spheres)?, compiled(cylinders)?];
        Ok(Self { name, gpu: Rc::clone(gpu), kernels })
    }

    /// Returns the kernel for `cases`, which must be all spheres or all cylinders.
    fn kernel(&self, cases: &[Case]) -> &(RowKernel<T>, Pipeline) {
        let cylinders = matches!(cases.first(), Some(Case { shape: Shape::Cylinder(_), .. }));
        &self.kernels[usize::from(cylinders)]
    }
}

impl<T: Formulas> Method for Wgsl<T> {
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
        let (kernel, pipeline) = self.kernel(cases);
        let (reports, _) = kernel.results(&self.gpu, pipeline, &rows::<T>(cases))?;
        Ok(reports.chunks(kernel.outputs.len()).map(answer).collect())
    }

    /// Returns a stopwatch that measures the device's time. Unlike the renderer's time, it includes computing the
    /// records of the objects, and all cores of the processor work.
    fn stopwatch<'a>(&'a self, cases: &[Case]) -> Result<Stopwatch<'a>, Failure> {
        let ((kernel, pipeline), rows) = (self.kernel(cases), rows::<T>(cases));
        Ok(Box::new(move || Ok(kernel.results(&self.gpu, pipeline, &rows)?.1)))
    }
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
