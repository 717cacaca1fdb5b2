//! Decides which part of a cylinder one ray hits. A crossing or a cap is computed only if the decision needs it.
//!
//! The cylinder is convex, so the ray's line crosses its surface only where it enters and where it leaves. If the ray
//! enters through the side, no cap is nearer. If it leaves through the side, only the cap that faces the ray can be
//! nearer. The other cap counts only if nothing else is hit. For rays that start inside, or go inward from the surface,
//! the exit through the side mostly decides alone.

use crate::exact::cylinder_parts::{Crossing, Plane, Side, filtered_cap};
use crate::exact::{error_bound::Decision, error_bound::in_scale};
use crate::geometry::{cylinder::CylinderPart, cylinder::CylinderRecord, ray::Ray};
use crate::math::{real::Real, rounding::Rounding, vec3::Vec3};

/// The lambda and the part of a hit, or `None` for a miss.
pub(super) type Hit<T> = Option<(T, CylinderPart)>;

/// A way to compute where a ray crosses an infinite cylinder.
pub(super) trait SideFormulas<T: Rounding> {
    /// Whether the ray's line certainly misses the infinite cylinder.
    fn misses(&self) -> bool;
    /// Whether the crossings can be accurate. If not, no crossing is certain.
    fn is_accurate(&self) -> bool;
    /// Whether the ray certainly starts inside the infinite cylinder.
    fn inside(&self) -> bool;
    /// Whether lambda at the [entry](Self::entry) certainly is below the least lambda. This is cheaper than the entry.
    fn enters_behind(&self) -> bool;
    /// Returns the point where the line enters the infinite cylinder.
    fn entry(&self) -> Crossing<T>;
    /// Returns the point where it leaves the infinite cylinder.
    fn exit(&self) -> Crossing<T>;
}

/// The side by the plain formulas. `root` is the square root of the discriminant.
pub(super) struct PlainSide<'a, T: Real> {
    record: &'a CylinderRecord<T>,
    ray: &'a Ray<T>,
    side: Side<T>,
    root: T,
}

impl<'a, T: Rounding> PlainSide<'a, T> {
    #[inline(always)]
    pub(super) fn new(record: &'a CylinderRecord<T>, ray: &'a Ray<T>, is_long: bool) -> Self {
        let side = Side::new(record, &record.seen_from(ray.origin), ray.direction, is_long);
        let root = side.discriminant.sqrt();
        Self { record, ray, side, root }
    }
}

impl<T: Rounding<Mask = bool>> SideFormulas<T> for PlainSide<'_, T> {
    #[inline(always)]
    fn misses(&self) -> bool {
        self.side.bound.misses(self.side.discriminant)
    }

    #[inline(always)]
    fn is_accurate(&self) -> bool {
        self.side.a_is_accurate
    }

    #[inline(always)]
    fn inside(&self) -> bool {
        self.side.inside
    }

    #[inline(always)]
    fn enters_behind(&self) -> bool {
        self.side.is_behind(-self.side.h - self.root, self.root)
    }

    #[inline(always)]
    fn entry(&self) -> Crossing<T> {
        self.side.crossing(self.record, self.ray, -self.side.h - self.root, self.root)
    }

    #[inline(always)]
    fn exit(&self) -> Crossing<T> {
        self.side.crossing(self.record, self.ray, -self.side.h + self.root, self.root)
    }
}

/// A way to compute the plane of a cap. It is a trait and no closure; see [`crate::simd::Kernel::call`].
pub trait CapFormulas<T: Rounding> {
    /// Returns the plane of the cap around `center`.
    fn plane(&self, record: &CylinderRecord<T>, ray: &Ray<T>, center: Vec3<T>, is_top: T::Mask) -> Plane<T>;
}

/// Planes by the plain formula.
pub struct PlainCaps;

impl<T: Rounding> CapFormulas<T> for PlainCaps {
    #[inline(always)]
    fn plane(&self, record: &CylinderRecord<T>, ray: &Ray<T>, center: Vec3<T>, _: T::Mask) -> Plane<T> {
        Plane::new(record, ray, center)
    }
}

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
    if side.misses() {
        return Decision::Certain(None);
    }
    if !side.is_accurate() {
        return caps_alone(record, ray, side, caps);
    }
    let exit = if side.enters_behind() {
        let exit = side.exit();
        if exit.straight {
            return Decision::Certain(Some((exit.lambda, CylinderPart::Side)));
        }
        if exit.behind {
            return Decision::Certain(None);
        }
        exit
    } else {
        let entry = side.entry();
        if entry.hits {
            return Decision::Certain(Some((entry.lambda, CylinderPart::Side)));
        }
        if !entry.fails() {
            return caps_alone(record, ray, side, caps);
        }
        let exit = side.exit();
        if entry.passes_by(&exit) {
            return Decision::Certain(None);
        }
        exit
    };
    if !(exit.hits || exit.fails()) {
        return caps_alone(record, ray, side, caps);
    }
    with_caps(record, ray, caps, Decision::Certain(exit.hits.then_some((exit.lambda, CylinderPart::Side))))
}

/// Returns the hit if the caps decide it alone, although it is uncertain where the ray crosses the side.
#[inline(always)]
fn caps_alone<T: Rounding<Mask = bool>>(
    record: &CylinderRecord<T>,
    ray: &Ray<T>,
    side: &impl SideFormulas<T>,
    caps: &impl CapFormulas<T>,
) -> Decision<Hit<T>> {
    if side.inside() { with_caps(record, ray, caps, Decision::Uncertain) } else { Decision::Uncertain }
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
