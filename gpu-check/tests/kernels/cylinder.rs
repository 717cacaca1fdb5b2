//! The intersection of a ray with a closed cylinder: its side and both caps.

use cpu::Vec3;
use cpu::internals::Hit;
use cpu::internals::geometry::cylinder::CylinderRecord;
use cpu::internals::math::real::Real;
use cpu::internals::sampling::uniform::Uniform;
use gpu_check::reader::Reader;
use stability::methods::projected;

use super::kernel::Formula;
use super::special::{self, DIRECTIONS, NUMBERS, Row};
use super::{HIT_REPORT, report};

/// The plain formula, or the projected form if `PROJECTED`.
pub enum Cylinder<const PROJECTED: bool> {}

/// Origins of rays, relative to an upright cylinder of radius 1 and height 4.
const ORIGINS: [[f64; 3]; 25] = [
    [0.0, 0.0, 0.0],  // at the centre
    [0.0, 0.0, -3.0], // beside, before and behind
    [0.0, 0.0, 3.0],
    [0.0, 5.0, 0.0], // above and below, on the axis
    [0.0, -5.0, 0.0],
    [1.0, 5.0, 0.0], // along the side, on the rim
    [0.6, 5.0, 0.8],
    [1.000_000_000_000_000_2, 5.0, 0.0],
    [1.1, 5.0, 0.0],  // past the rim
    [0.0, 2.0, -3.0], // level with the caps
    [0.0, -2.0, -3.0],
    [0.0, 2.000_000_000_000_000_4, -3.0],
    [0.0, 4.0, -3.0], // rays at 45 degrees hit the rim
    [0.0, -4.0, -3.0],
    [0.0, 4.5, -3.0],
    [0.0, 2.0, 0.5], // on a cap, on the side, on the rim
    [0.0, -2.0, 0.5],
    [1.0, 0.5, 0.0],
    [0.0, 2.0, -1.0],
    [1.0, 0.0, -3.0],           // tangent
    [0.5, 1.0, -0.25],          // inside
    [-0.5, 2.000_000_001, 0.0], // just above a cap, for directions nearly in its plane
    [-0.5, -2.000_000_001, 0.0],
    [0.0, 2.001, 0.25], // a thousandth above a cap
    [1e-20, 1e6, -1e150],
];

const CENTERS: [[f64; 3]; 3] = [[0.0; 3], [1.0, -2.0, 0.5], [1e-40, 1e6, 0.1]];
/// Axes of cylinders. The length of an axis is the height of the cylinder.
const AXES: [[f64; 3]; 10] = [
    [0.0, 4.0, 0.0],
    [0.0, -4.0, 0.0],
    [0.0, 0.002, 0.0], // from the centre, the top cap is exactly at the smallest lambda in range
    [4.0, 0.0, 0.0],
    [0.0, 0.0, 1e-6],
    [1.0, 2.0, -2.0],
    [0.3, 0.1, 0.2],
    [1e9, 1e9, 0.0],
    [1e-40, 0.0, 0.0],
    [0.0, 1e-170, 0.0],
];
const RADII: [f64; 6] = [1.0, 0.3, 1e-6, 1000.0, 1e9, 1e-40];

impl<const PROJECTED: bool> Formula for Cylinder<PROJECTED> {
    const MODULE: &'static str = if PROJECTED { "kernels/projected_cylinder" } else { "kernels/cylinder" };
    const INPUTS: usize = 13;
    const OUTPUTS: &'static [&'static str] = HIT_REPORT;

    fn evaluate<T: Real<Mask = bool>>(mut case: Reader<'_, T>, result: &mut [T]) {
        let ray = case.ray();
        let cylinder = CylinderRecord::new(case.vector(), case.number(), case.vector());
        let hit = if PROJECTED { projected::cylinder(&cylinder, &ray) } else { cylinder.intersect(&ray) };
        let hit = hit.map(|(lambda, part)| {
            let point = ray.at(lambda);
            (lambda, part as u32, Hit::facing(ray.direction, point, cylinder.outward(part, point)))
        });
        report(hit, result);
    }

    fn edges(rows: &mut Row) {
        for center in CENTERS.map(Vec3::from) {
            for radius in RADII {
                for axis in AXES {
                    for origin in ORIGINS {
                        for direction in DIRECTIONS {
                            let origin = center + Vec3::from(origin);
                            rows.vector(origin).vector(direction).vector(center).number(radius).vector(axis);
                        }
                    }
                }
            }
        }
        for number in NUMBERS {
            for other in NUMBERS {
                let axis = [0.0, 4.0, 0.0];
                rows.vector([number, 5.0, 0.0]).vector([other, -1.0, 0.0]).vector([0.0; 3]).number(1.0).vector(axis);
                rows.vector([0.0, 1.0, number]).vector([0.0, 0.5, other]).vector([0.0; 3]).number(1.0).vector(axis);
                let axis = [0.0, other, 0.0];
                rows.vector([0.0, 5.0, -3.0]).vector([0.0, -1.0, 1.0]).vector([0.0; 3]);
                rows.number(number.abs()).vector(axis);
            }
        }
    }

    fn random(draws: &mut Uniform, row: &mut Row) {
        let ordinary = draws.canonical() < 0.7;
        let size = if ordinary { 1.0 } else { special::of_any_size(draws, -6.0, 6.0).abs() };
        let (radius, height) = (size * draws.draw(0.1, 3.0), size * draws.draw(0.1, 6.0));
        let center = special::in_cube(draws, 10.0 * size);
        let axis = special::direction(draws);
        // The ray aims at a point on the side, on a cap, on a rim or inside. `out` is that point's distance from the
        // axis in radii, and `along` its distance from the centre in heights.
        let across = special::direction(draws).perpendicular_to(axis);
        let across = across / across.length().max(1e-9);
        let place = draws.canonical();
        let (out, along) = match place {
            _ if place < 0.4 => (1.0, draws.draw(-0.5, 0.5)),
            _ if place < 0.6 => (draws.canonical(), 0.5),
            _ if place < 0.8 => (draws.canonical(), -0.5),
            _ if place < 0.9 => (1.0, if place < 0.85 { 0.5 } else { -0.5 }),
            _ => (draws.canonical(), draws.draw(-0.5, 0.5)),
        };
        let aim = center + across * (radius * out) + axis * (height * along);
        let start = draws.canonical();
        let away = if ordinary { draws.draw(0.0, 20.0) } else { special::of_any_size(draws, -2.0, 9.0).abs() };
        let (origin, direction) = match start {
            _ if start < 0.2 => (aim, special::direction(draws)),
            _ if start < 0.3 => (center + axis * draws.draw(-0.4, 0.4) * height, aim - center),
            _ => {
                let origin = aim + special::direction(draws) * (size * away);
                (origin, aim - origin)
            }
        };
        let direction = if ordinary { direction } else { direction * special::of_any_size(draws, -6.0, 6.0).abs() };
        row.vector(origin).vector(direction).vector(center).number(radius).vector(axis * height);
    }
}
