//! Intersects the rays with a cylinder for which the plain formulas are uncertain, several at once.

use crate::counters::{Counter, add};
use crate::exact::cylinder::precise;
use crate::exact::cylinder_compensated::{CompensatedCaps, CompensatedSide};
use crate::exact::cylinder_lanes::SideLanes;
use crate::exact::error_bound::in_scale;
use crate::geometry::{cylinder::CylinderRecord, ray::Ray};
use crate::math::{real::Real as _, vec3::Vec3};
use crate::render::lane_by_lane::{for_each_lane, replace_lane_by_lane};
use crate::simd::{Kernel, MOST_LANES, Simd, SimdF64, columns::Columns, instruction_set::InstructionSet};

/// A cylinder and its axis in the scene file.
pub type CylinderAndFileAxis<'a> = (&'a CylinderRecord, &'a Vec3);

/// The origin and the direction of several rays, and lambda and part of their hits.
type RaysAndHits = Columns<8, MOST_LANES>;

/// Returns lambda and part of each lane. In the lanes whose bits are set in `uncertain` they come from the compensated
/// formulas or, if these are uncertain too, from dyadic arithmetic, and lambda is NaN for a miss. All other lanes keep
/// the given values.
#[inline(always)]
pub(crate) fn uncertain_cylinder<V: SimdF64>(
    ray: &Ray<V>,
    hits: (V, V),
    uncertain: u32,
    cylinder: CylinderAndFileAxis,
) -> (V, V) {
    let Ray { origin: o, direction: d } = *ray;
    let mut lanes = Columns::of_lanes([o.x, o.y, o.z, d.x, d.y, d.z, hits.0, hits.1]);
    replace_uncertain(&mut lanes, uncertain, cylinder);
    let [.., lambda, part] = lanes.load(0);
    (lambda, part)
}

/// Replaces lambda and part of the `uncertain` lanes. This function is not inlined, so that the loop over the objects
/// keeps its registers.
#[cold]
#[inline(never)]
fn replace_uncertain(lanes: &mut RaysAndHits, uncertain: u32, cylinder: CylinderAndFileAxis) {
    let left = InstructionSet::fused().run(Compensated { lanes, uncertain, cylinder });
    add(Counter::Compensated, u64::from((uncertain & !left).count_ones()));
    replace_lane_by_lane(lanes, left, &|ray| precise(cylinder.0, cylinder.1, ray));
}

/// A kernel that intersects the rays of the `uncertain` lanes by the compensated formulas. It returns the lanes that
/// still are uncertain.
struct Compensated<'a> {
    lanes: &'a mut RaysAndHits,
    uncertain: u32,
    cylinder: CylinderAndFileAxis<'a>,
}

impl Kernel for Compensated<'_> {
    type Output = u32;

    #[inline(always)]
    fn call<S: Simd>(self, _: S) -> u32 {
        let Self { lanes, uncertain, cylinder: (record, file_axis) } = self;
        let (record, file_axis) = (record.lanes::<S::F64>(), file_axis.map(S::F64::of));
        let (mut left, mut at) = (uncertain, 0);
        while at < MOST_LANES {
            let [x, y, z, dx, dy, dz, ..] = lanes.load::<S::F64>(at);
            let ray = Ray { origin: Vec3::new(x, y, z), direction: Vec3::new(dx, dy, dz) };
            let side = SideLanes::new(&CompensatedSide::new(&record, file_axis, &ray));
            let hits = side.with_needed_caps(&record, &ray, &CompensatedCaps(file_axis), uncertain >> at);
            let certain = S::F64::bits(hits.certain & in_scale(ray.direction.dot(ray.direction))) << at & uncertain;
            let found = Columns::<2, MOST_LANES>::of_lanes([hits.lambda, hits.part()]);
            for_each_lane(certain, |lane| {
                let [lambda, part] = found.get(lane - at);
                let [.., lambdas, parts] = &mut lanes.0;
                lambdas[lane] = if lambda < f64::INFINITY { lambda } else { f64::NAN };
                parts[lane] = part;
            });
            left &= !certain;
            at += S::F64::LANES;
        }
        left
    }
}
