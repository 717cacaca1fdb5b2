//! The intersection of a ray with a sphere.

use cpu::Vec3;
use cpu::internals::Hit;
use cpu::internals::geometry::sphere::SphereRecord;
use cpu::internals::math::real::Real;
use cpu::internals::sampling::uniform::Uniform;
use gpu_check::reader::Reader;
use stability::methods::projected;

use super::kernel::Formula;
use super::special::{self, DIRECTIONS, NUMBERS, Row};
use super::{HIT_REPORT, report};

/// The plain formula, or the projected form if `PROJECTED`.
pub enum Sphere<const PROJECTED: bool> {}

/// Origins of rays, relative to the centre of the sphere, in radii.
const ORIGINS: [[f64; 3]; 20] = [
    [0.0, 0.0, 0.0],  // at the centre
    [0.0, 0.0, -3.0], // outside, before and behind
    [0.0, 0.0, 3.0],
    [0.0, 0.25, 0.5], // inside
    [0.0, 0.0, -1.0], // on the surface
    [1.0, 0.0, 0.0],
    [0.0, -1.0, 0.0],
    [0.6, 0.8, 0.0],
    [0.0, 0.0, -0.999_999_999],
    [0.0, 0.0, -1.001], // a thousandth before the surface, and behind it
    [0.0, 0.0, 1.001],
    [0.0, 0.0, -0.999],
    [1.0, 0.0, -3.0], // tangent, and one unit in the last place inside and outside
    [0.999_999_999_999_999_9, 0.0, -3.0],
    [1.000_000_000_000_000_2, 0.0, -3.0],
    [0.999_999_94, 0.0, -3.0],
    [0.6, -0.8, -5.0],
    [0.0, -0.999_999, -2.0],
    [0.0, 1e6, -1e6],
    [1e-20, 5e-324, -1e150],
];

const CENTERS: [[f64; 3]; 4] = [[0.0; 3], [1.0, -2.0, 0.5], [0.0, -1000.0, 0.0], [1e-40, 1e10, 0.1]];
const RADII: [f64; 9] = [1.0, 2.0, 0.3, 1e-6, 1000.0, 1e9, 1e-40, 1e-160, 1e160];

impl<const PROJECTED: bool> Formula for Sphere<PROJECTED> {
    const MODULE: &'static str = if PROJECTED { "kernels/projected_sphere" } else { "kernels/sphere" };
    const INPUTS: usize = 10;
    const OUTPUTS: &'static [&'static str] = HIT_REPORT;

    fn evaluate<T: Real<Mask = bool>>(mut case: Reader<'_, T>, result: &mut [T]) {
        let ray = case.ray();
        let sphere = SphereRecord::new(case.vector(), case.number());
        let lambda = if PROJECTED { projected::sphere(&sphere, &ray) } else { sphere.intersect(&ray) };
        let hit = lambda.map(|lambda| {
            let point = ray.at(lambda);
            (lambda, 0, Hit::facing(ray.direction, point, sphere.outward(point)))
        });
        report(hit, result);
    }

    fn edges(rows: &mut Row) {
        for center in CENTERS.map(Vec3::from) {
            for radius in RADII {
                for origin in ORIGINS {
                    for direction in DIRECTIONS {
                        let origin = center + Vec3::from(origin) * radius;
                        rows.vector(origin).vector(direction).vector(center).number(radius);
                    }
                }
            }
        }
        for number in NUMBERS {
            for other in NUMBERS {
                rows.vector([number, 0.0, -3.0]).vector([other, 0.0, 1.0]).vector([0.0; 3]).number(1.0);
                rows.vector([0.0, 0.0, number]).vector([0.0, 0.0, other]).vector([0.0; 3]).number(1.0);
                rows.vector([0.0, 0.0, -3.0]).vector([0.0, 0.0, 1.0]).vector([number, 0.0, 0.0]).number(other.abs());
            }
        }
    }

    fn random(draws: &mut Uniform, row: &mut Row) {
        let ordinary = draws.canonical() < 0.7;
        let radius = if ordinary { draws.draw(0.1, 5.0) } else { special::of_any_size(draws, -6.0, 9.0).abs() };
        let center = special::in_cube(draws, if ordinary { 10.0 } else { radius * 3.0 });
        // The ray starts on the surface, inside, near the sphere or far away.
        let place = draws.canonical();
        let distance = match place {
            _ if place < 0.2 => radius,
            _ if place < 0.3 => radius * draws.canonical(),
            _ if ordinary => radius + draws.draw(0.0, 20.0),
            _ => radius + special::of_any_size(draws, -2.0, 12.0).abs(),
        };
        let origin = center + special::direction(draws) * distance;
        // The ray aims at a point inside the sphere in 8 of 10 cases, at its surface in one case, and anywhere in one
        // case.
        let aim = draws.canonical();
        let spread = if aim < 0.1 { 1.0 } else { draws.canonical() };
        let towards = center + special::direction(draws) * (radius * spread) - origin;
        let direction = if aim > 0.9 { special::direction(draws) } else { towards };
        let direction = if ordinary { direction } else { direction * special::of_any_size(draws, -6.0, 6.0).abs() };
        row.vector(origin).vector(direction).vector(center).number(radius);
    }
}
