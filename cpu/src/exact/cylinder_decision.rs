//! Decides which part of a cylinder one ray hits. A crossing or a cap is computed only if the decision needs it.
//!
//! The cylinder is convex, so the ray's line crosses its surface only where it enters and where it leaves. If the ray
//! enters through the side, no cap is nearer. If it leaves through the side, only the cap that faces the ray can be
//! nearer. The other cap counts only if nothing else is hit. For rays that start inside, or go inward from the surface,
//! the exit through the side mostly decides alone.

use crate::exact::cylinder_filter::{CapFormulas, Crossing, SideFacts, SideFormulas, filtered_cap};
use crate::exact::{error_bound::Decision, error_bound::in_scale};
use crate::geometry::{cylinder::CylinderPart, cylinder::CylinderRecord, ray::Ray};
use crate::math::rounding::Rounding;

/// The lambda and the part of a hit, or `None` for a miss.
pub(super) type Hit<T> = Option<(T, CylinderPart)>;

/// Returns the closest hit or a miss, if these formulas of the side and of the caps decide it.
#[inline(always)]
pub(super) fn decide<T: Rounding<Mask = bool>>(
    record: &CylinderRecord<T>,
    ray: &Ray<T>,
    side: &impl SideFormulas<T>,
    caps: &impl CapFormulas<T>,
) -> Decision<Hit<T>> {
    if !in_scale(ray.direction.dot(ray.direction)) {
        return Decision::Uncertain;
    }
    let SideFacts { misses, is_accurate, inside } = side.facts();
    if misses {
        return Decision::Certain(None);
    }
    let leaving = if !is_accurate {
        Decision::Uncertain
    } else if side.enters_behind() {
        let exit = side.crossing(true);
        if exit.straight {
            return Decision::Certain(Some((exit.lambda, CylinderPart::Side)));
        }
        if exit.behind {
            return Decision::Certain(None);
        }
        hit_at(&exit)
    } else {
        let entry = side.crossing(false);
        if entry.hits {
            return Decision::Certain(Some((entry.lambda, CylinderPart::Side)));
        }
        if entry.fails() {
            let exit = side.crossing(true);
            if entry.passes_by(&exit) {
                return Decision::Certain(None);
            }
            hit_at(&exit)
        } else {
            Decision::Uncertain
        }
    };
    // The caps can decide alone if the ray certainly starts inside the infinite cylinder.
    if matches!(leaving, Decision::Uncertain) && !inside {
        return Decision::Uncertain;
    }
    with_caps(record, ray, caps, leaving)
}

/// Returns the hit with the side at this crossing, or a certain miss there.
#[inline(always)]
fn hit_at<T: Rounding<Mask = bool>>(crossing: &Crossing<T>) -> Decision<Hit<T>> {
    match (crossing.hits, crossing.fails()) {
        (false, false) => Decision::Uncertain,
        (hits, _) => Decision::Certain(hits.then_some((crossing.lambda, CylinderPart::Side))),
    }
}

/// Returns the closest hit with a cap or with the side. The ray certainly does not hit the side where its line enters
/// the infinite cylinder. `leaving` is the hit with the side where the line leaves, or a certain miss there. It may be
/// uncertain if the ray certainly starts inside the infinite cylinder. Then only a hit with a cap is certain, as for
/// rays that run nearly along the axis.
#[inline(always)]
pub(super) fn with_caps<T: Rounding<Mask = bool>>(
    record: &CylinderRecord<T>,
    ray: &Ray<T>,
    caps: &impl CapFormulas<T>,
    leaving: Decision<Hit<T>>,
) -> Decision<Hit<T>> {
    // Here `facing` is the centre of the cap that faces the ray. A branch that chooses it would be mispredicted, and a
    // selection would become a branch. So it is computed by the formula of `record.top` and `record.bottom`.
    let slope = ray.direction.dot(record.axis);
    let along = record.axis * record.half_height.flipped_by(slope);
    let (facing, other) = (record.center - along, record.center + along);
    let part = |is_top: bool| if is_top { CylinderPart::Top } else { CylinderPart::Bottom };
    let down = slope.less(T::of(0.0));
    match filtered_cap(record, ray, &caps.plane(record, ray, facing, down), part(down)) {
        Decision::Certain(None) => {}
        decision => return decision,
    }
    if let Decision::Certain(Some(_)) = leaving {
        return leaving;
    }
    match filtered_cap(record, ray, &caps.plane(record, ray, other, !down), part(!down)) {
        Decision::Certain(None) => leaving,
        decision => decision,
    }
}
