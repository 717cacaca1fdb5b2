//! Intersects rays in lanes precisely with an object, in those lanes whose filter is uncertain.
//!
//! One call handles all uncertain lanes. It is a separate function that is not inlined. Otherwise LLVM splits the lanes
//! into single rays before the loop over the objects. It does so for every group of rays, but few groups have an
//! uncertain lane.

use crate::{geometry::cylinder::CylinderPart, geometry::ray::Ray, simd::SimdF64, simd::columns::Columns};

/// Largest number of `f64` lanes of any instruction set.
pub const MOST_LANES: usize = 8;

/// A function that intersects one ray precisely with an object. It returns lambda and the part of a cylinder, or `None`
/// for a miss.
type Intersect<'a> = &'a dyn Fn(&Ray) -> Option<(f64, CylinderPart)>;

/// Returns lambda and part of each lane. In the lanes whose bits are set in `uncertain` they come from `intersect`,
/// where lambda is NaN for a miss. All other lanes keep the given values.
#[inline(always)]
pub fn precise<V: SimdF64>(ray: &Ray<V>, (lambda, part): (V, V), uncertain: u32, intersect: Intersect<'_>) -> (V, V) {
    let Ray { origin: o, direction: d } = *ray;
    let mut lanes = Columns::of_lanes([o.x, o.y, o.z, d.x, d.y, d.z, lambda, part]);
    precise_lane_by_lane(&mut lanes, uncertain, intersect);
    let [.., lambda, part] = lanes.load(0);
    (lambda, part)
}

#[cold]
#[inline(never)]
fn precise_lane_by_lane(lanes: &mut Columns<8, MOST_LANES>, uncertain: u32, intersect: Intersect<'_>) {
    for_each_lane(uncertain, |lane| {
        let [x, y, z, dx, dy, dz, ..] = lanes.get(lane);
        let ray = Ray { origin: [x, y, z].into(), direction: [dx, dy, dz].into() };
        let (lambda, part) = intersect(&ray).unwrap_or((f64::NAN, CylinderPart::Side));
        lanes.set(lane, [x, y, z, dx, dy, dz, lambda, f64::from(part as u32)]);
    });
}

/// Calls `visit` with the index of every lane whose bit is set, the lowest first.
#[inline(always)]
pub fn for_each_lane(mut bits: u32, mut visit: impl FnMut(usize)) {
    while bits != 0 {
        visit(bits.trailing_zeros() as usize % MOST_LANES);
        bits &= bits - 1;
    }
}
