//! The intersection of a ray with a sphere and with a cylinder in the projected form, for the cases of the plain
//! formulas.

use cpu::Ray;
use cpu::internals::Hit;
use cpu::internals::geometry::cylinder::CylinderRecord;
use cpu::internals::geometry::sphere::SphereRecord;
use cpu::internals::math::real::Real;
use cpu::internals::sampling::uniform::Uniform;
use stability::methods::projected;

use super::{HIT_REPORT, cylinder, report, sphere};
use crate::kernel::{Formula, Reader};

pub enum Sphere {}
pub enum Cylinder {}

impl Formula for Sphere {
    const MODULE: &'static str = "kernels/projected_sphere";
    const INPUTS: usize = sphere::Sphere::INPUTS;
    const OUTPUTS: &'static [&'static str] = HIT_REPORT;

    fn evaluate<T: Real<Mask = bool>>(case: &[T], result: &mut [T]) {
        let mut case = Reader(case);
        let ray = Ray { origin: case.vector(), direction: case.vector() };
        let sphere = SphereRecord::new(case.vector(), case.number());
        let hit = projected::sphere(&sphere, &ray).map(|lambda| {
            let point = ray.at(lambda);
            (lambda, 0, Hit::facing(ray.direction, point, sphere.outward(point)))
        });
        report(hit, result);
    }

    fn edges() -> Vec<f64> {
        sphere::Sphere::edges()
    }

    fn random(draws: &mut Uniform, case: &mut [f64]) {
        sphere::Sphere::random(draws, case);
    }
}

impl Formula for Cylinder {
    const MODULE: &'static str = "kernels/projected_cylinder";
    const INPUTS: usize = cylinder::Cylinder::INPUTS;
    const OUTPUTS: &'static [&'static str] = HIT_REPORT;

    fn evaluate<T: Real<Mask = bool>>(case: &[T], result: &mut [T]) {
        let mut case = Reader(case);
        let ray = Ray { origin: case.vector(), direction: case.vector() };
        let cylinder = CylinderRecord::new(case.vector(), case.number(), case.vector());
        let hit = projected::cylinder(&cylinder, &ray).map(|(lambda, part)| {
            let point = ray.at(lambda);
            (lambda, part as u32, Hit::facing(ray.direction, point, cylinder.outward(part, point)))
        });
        report(hit, result);
    }

    fn edges() -> Vec<f64> {
        cylinder::Cylinder::edges()
    }

    fn random(draws: &mut Uniform, case: &mut [f64]) {
        cylinder::Cylinder::random(draws, case);
    }
}
