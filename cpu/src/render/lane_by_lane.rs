//! Decides what lanes leave open: intersections whose filter is uncertain, and which of two near hits is closer.
//!
//! One call handles all open lanes. It is a separate function that is not inlined. Otherwise LLVM splits the lanes into
//! single rays before the loop over the objects. It does so for every group of rays, but few groups have an open lane.

use crate::render::lane_numbers::ObjectNumber;
use crate::{
    accel::closest_hit::ClosestHit, accel::object::NO_OBJECT, geometry::cylinder::CylinderPart, geometry::ray::Ray,
    simd::MOST_LANES, simd::SimdF64, simd::columns::Columns,
};

/// A function that intersects one ray precisely with an object. It returns lambda and the part of a cylinder, or `None`
/// for a miss.
type IntersectAlone<'a> = &'a dyn Fn(&Ray) -> Option<(f64, CylinderPart)>;

/// Returns lambda and part of each lane. In the lanes whose bits are set in `uncertain` they come from `intersect`,
/// where lambda is NaN for a miss. All other lanes keep the given values.
#[inline(always)]
pub(crate) fn lane_by_lane<V: SimdF64>(
    ray: &Ray<V>,
    (lambda, part): (V, V),
    uncertain: u32,
    intersect: IntersectAlone<'_>,
) -> (V, V) {
    let Ray { origin: o, direction: d } = *ray;
    let mut lanes = Columns::of_lanes([o.x, o.y, o.z, d.x, d.y, d.z, lambda, part]);
    replace_lane_by_lane(&mut lanes, uncertain, intersect);
    let [.., lambda, part] = lanes.load(0);
    (lambda, part)
}

/// Replaces lambda and part of the lanes whose bits are set in `uncertain`, as [`lane_by_lane`] does.
#[cold]
#[inline(never)]
pub(crate) fn replace_lane_by_lane(lanes: &mut Columns<8, MOST_LANES>, uncertain: u32, intersect: IntersectAlone<'_>) {
    for_each_lane(uncertain, |lane| {
        let [x, y, z, dx, dy, dz, ..] = lanes.get(lane);
        let ray = Ray { origin: [x, y, z].into(), direction: [dx, dy, dz].into() };
        let (lambda, part) = intersect(&ray).unwrap_or((f64::NAN, CylinderPart::Side));
        lanes.set(lane, [x, y, z, dx, dy, dz, lambda, f64::from(part as u32)]);
    });
}

/// The lambda, the object's number and the part of several hits, one in each lane.
type Hits<V> = [V; 3];

/// A function that tells whether the first of two hits of a ray is closer.
type IsCloser<'a> = &'a dyn Fn(&Ray, [ClosestHit; 2]) -> bool;

/// In the lanes whose bits are set in `near`, replaces the second of two hits by the first if the first is closer.
/// Returns the hits, and a bit for each lane in which this happened.
#[inline(always)]
pub(crate) fn closer_of_near<V: SimdF64>(
    ray: &Ray<V>,
    ([lambda, object, part], closest): (Hits<V>, Hits<V>),
    near: u32,
    is_closer: IsCloser<'_>,
) -> (Hits<V>, u32) {
    let Ray { origin: o, direction: d } = *ray;
    let hits = Columns::of_lanes([o.x, o.y, o.z, d.x, d.y, d.z, lambda, object, part]);
    let mut closest = Columns::of_lanes(closest);
    let closer = closer_lane_by_lane(&hits, &mut closest, near, is_closer);
    (closest.load(0), closer)
}

/// Compares the hit of each near lane alone with the closest one, and returns the lanes whose hits are closer.
#[cold]
#[inline(never)]
fn closer_lane_by_lane(
    hits: &Columns<9, MOST_LANES>,
    closest: &mut Columns<3, MOST_LANES>,
    near: u32,
    is_closer: IsCloser<'_>,
) -> u32 {
    let mut closer = 0;
    for_each_lane(near, |lane| {
        let [x, y, z, dx, dy, dz, hit @ ..] = hits.get(lane);
        let ray = Ray { origin: [x, y, z].into(), direction: [dx, dy, dz].into() };
        let of = |[lambda, object, part]: [f64; 3]| {
            let object = if object < 0.0 { NO_OBJECT } else { ObjectNumber(object).id() };
            ClosestHit { lambda, object, part: CylinderPart::of_number(part) }
        };
        if is_closer(&ray, [of(hit), of(closest.get(lane))]) {
            closest.set(lane, hit);
            closer |= 1 << lane;
        }
    });
    closer
}

/// Calls `visit` with the index of every lane whose bit is set, the lowest first.
#[inline(always)]
pub(crate) fn for_each_lane(mut bits: u32, mut visit: impl FnMut(usize)) {
    while bits != 0 {
        visit(bits.trailing_zeros() as usize % MOST_LANES);
        bits &= bits - 1;
    }
}
