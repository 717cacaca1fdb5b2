//! Decides which part of a cylinder one ray hits. A crossing or a cap is computed only if the decision needs it.
//!
//! The cylinder is convex, so the ray's line crosses its surface only where it enters and where it leaves. If the ray
//! enters through the side, no cap is nearer. If it leaves through the side, only the cap that faces the ray can be
//! nearer. The other cap counts only if nothing else is hit. For rays that start inside, or go inward from the surface,
//! the exit through the side mostly decides alone.

use crate::exact::cylinder_parts::{Crossing, Plane, Side, filtered_cap};
use crate::exact::{error_bound::Decision, error_bound::in_scale};
use crate::geometry::{cylinder::CylinderPart, cylinder::CylinderRecord, cylinder::CylinderView, ray::Ray};
use crate::math::{real::Real, rounding::Rounding, vec3::Vec3};

/// The lambda and the part of a hit, or `None` for a miss.
pub(super) type Hit<T> = Option<(T, CylinderPart)>;

/// What is certain about a ray and an infinite cylinder before a crossing is computed.
pub(super) struct SideFacts<T: Real> {
    /// The ray's line misses the infinite cylinder.
    pub misses: T::Mask,
    /// The crossings can be accurate. Elsewhere no crossing is certain.
    pub is_accurate: T::Mask,
    /// The ray starts inside the infinite cylinder.
    pub inside: T::Mask,
}

/// A way to compute where a ray crosses an infinite cylinder.
pub(super) trait SideFormulas<T: Rounding> {
    /// Returns what is certain before a crossing is computed.
    fn facts(&self) -> SideFacts<T>;
    /// Whether lambda certainly is below the least lambda where the line enters. This is cheaper than the crossing.
    fn enters_behind(&self) -> bool
    where
        T: Rounding<Mask = bool>;
    /// Returns the point where the line leaves the infinite cylinder if `leaves` holds, and where it enters otherwise.
    fn crossing(&self, leaves: bool) -> Crossing<T>;
}

/// The side by the plain formulas. `root` is the square root of the discriminant.
pub(super) struct PlainSide<'a, T: Real> {
    record: &'a CylinderRecord<T>,
    ray: &'a Ray<T>,
    side: Side<T>,
    root: T,
}

impl<'a, T: Rounding> PlainSide<'a, T> {
    /// Computes the quadratic. `view` has the cylinder's terms for the ray's origin.
    #[inline(always)]
    pub(super) fn new(record: &'a CylinderRecord<T>, view: &CylinderView<T>, ray: &'a Ray<T>, is_long: bool) -> Self {
        let side = Side::new(record, view, ray.direction, is_long);
        let root = side.discriminant.sqrt();
        Self { record, ray, side, root }
    }
}

impl<T: Rounding> SideFormulas<T> for PlainSide<'_, T> {
    #[inline(always)]
    fn facts(&self) -> SideFacts<T> {
        let Side { a_is_accurate, inside, .. } = self.side;
        SideFacts { misses: self.side.bound.misses(self.side.discriminant), is_accurate: a_is_accurate, inside }
    }

    #[inline(always)]
    fn enters_behind(&self) -> bool
    where
        T: Rounding<Mask = bool>,
    {
        self.side.is_behind(-self.side.h - self.root, self.root)
    }

    #[inline(always)]
    fn crossing(&self, leaves: bool) -> Crossing<T> {
        let Self { record, ray, side, root } = self;
        let numerator = if leaves { -side.h + *root } else { -side.h - *root };
        side.crossing(record, ray, numerator, *root)
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
    let SideFacts { misses, is_accurate, inside } = side.facts();
    if misses {
        return Decision::Certain(None);
    }
    if !is_accurate {
        return caps_alone(record, ray, inside, caps);
    }
    let exit = if side.enters_behind() {
        let exit = side.crossing(true);
        if exit.straight {
            return Decision::Certain(Some((exit.lambda, CylinderPart::Side)));
        }
        if exit.behind {
            return Decision::Certain(None);
        }
        exit
    } else {
        let entry = side.crossing(false);
        if entry.hits {
            return Decision::Certain(Some((entry.lambda, CylinderPart::Side)));
        }
        if !entry.fails() {
            return caps_alone(record, ray, inside, caps);
        }
        let exit = side.crossing(true);
        if entry.passes_by(&exit) {
            return Decision::Certain(None);
        }
        exit
    };
    if !(exit.hits || exit.fails()) {
        return caps_alone(record, ray, inside, caps);
    }
    with_caps(record, ray, caps, Decision::Certain(exit.hits.then_some((exit.lambda, CylinderPart::Side))))
}

/// Returns the hit if the caps decide it alone, although it is uncertain where the ray crosses the side. They can if
/// the ray certainly starts inside the infinite cylinder.
#[inline(always)]
fn caps_alone<T: Rounding<Mask = bool>>(
    record: &CylinderRecord<T>,
    ray: &Ray<T>,
    inside: bool,
    caps: &impl CapFormulas<T>,
) -> Decision<Hit<T>> {
    if inside { with_caps(record, ray, caps, Decision::Uncertain) } else { Decision::Uncertain }
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
