//! The precise answers of those of several rays that are in doubt.
//!
//! They are calls, one for all rays in doubt, so that nothing of them is done ahead: where the compiler sees them it
//! takes the rays apart in front of the loop over the objects, once for every group of rays, of which hardly any is in
//! doubt.

use crate::exact;
use crate::geometry::cylinder::{CylinderPart, CylinderRecord};
use crate::geometry::ray::Ray;
use crate::geometry::sphere::SphereRecord;
use crate::math::vec3::Vec3;
use crate::render::lane_by_lane::{LaneByLane, MOST_LANES, for_each_lane};
use crate::simd::SimdF64;

/// Components of origin and direction.
type Rays = LaneByLane<6>;

/// Replaces lambda in the doubtful lanes by the precise answer.
#[inline(always)]
pub fn precise_spheres<V: SimdF64>(record: &SphereRecord, ray: &Ray<V>, lambda: V, doubtful: u32) -> V {
    let mut lambdas = [0.0; MOST_LANES];
    lambda.store(&mut lambdas);
    precise_spheres_apart(record, &apart(ray), doubtful, &mut lambdas);
    V::load(&lambdas)
}

#[cold]
#[inline(never)]
fn precise_spheres_apart(record: &SphereRecord, rays: &Rays, doubtful: u32, lambdas: &mut [f64; MOST_LANES]) {
    for_each_lane(doubtful, |lane| {
        lambdas[lane] = exact::sphere::precise(record, &ray_of(rays, lane)).unwrap_or(f64::INFINITY);
    });
}

/// Replaces lambda and part in the doubtful lanes by the precise answer.
#[inline(always)]
pub fn precise_cylinders<V: SimdF64>(
    cylinder: (&CylinderRecord, &Vec3),
    ray: &Ray<V>,
    (lambda, part): (V, V),
    doubtful: u32,
) -> (V, V) {
    let (mut lambdas, mut parts) = ([0.0; MOST_LANES], [0.0; MOST_LANES]);
    lambda.store(&mut lambdas);
    part.store(&mut parts);
    precise_cylinders_apart(cylinder, &apart(ray), doubtful, (&mut lambdas, &mut parts));
    (V::load(&lambdas), V::load(&parts))
}

#[cold]
#[inline(never)]
fn precise_cylinders_apart(
    (record, axis): (&CylinderRecord, &Vec3),
    rays: &Rays,
    doubtful: u32,
    (lambdas, parts): (&mut [f64; MOST_LANES], &mut [f64; MOST_LANES]),
) {
    for_each_lane(doubtful, |lane| {
        let (lambda, part) =
            exact::cylinder::precise(record, axis, &ray_of(rays, lane)).unwrap_or((f64::INFINITY, CylinderPart::Side));
        (lambdas[lane], parts[lane]) = (lambda, f64::from(part as u32));
    });
}

#[inline(always)]
fn apart<V: SimdF64>(Ray { origin: o, direction: d }: &Ray<V>) -> Rays {
    Rays::new([o.x, o.y, o.z, d.x, d.y, d.z])
}

fn ray_of(rays: &Rays, lane: usize) -> Ray {
    let [x, y, z, dx, dy, dz] = rays.of(lane);
    Ray { origin: Vec3::new(x, y, z), direction: Vec3::new(dx, dy, dz) }
}
