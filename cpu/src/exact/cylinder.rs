//! Ray against closed cylinder, certified; see [`crate::geometry::cylinder`] for the formulas.
//!
//! Besides the quadratic's error bound there are margins for what the plain formula decides afterwards: whether a point
//! of the side is between the caps, whether a point of a cap's plane is on the disc, whether a plane is hit at all, and
//! which of two surfaces is nearer. Each margin holds the error of lambda, as a length, and the rounding of the points,
//! which have the size of the cylinder's coordinates.

use crate::exact::cylinder_surfaces::{Plane, Side};
use crate::exact::double_double::DoubleDouble;
use crate::exact::error_bound::{Decision, in_scale};
use crate::exact::sphere_exact::NotFinite;
use crate::exact::{cylinder_exact, cylinder_lanes};
use crate::geometry::cylinder::{CylinderPart, CylinderRecord};
use crate::geometry::ray::Ray;
use crate::math::real::Real;
use crate::math::rounding::Rounding;
use crate::math::vec3::Vec3;
use crate::simd::instruction_set::InstructionSet;
use crate::simd::{Kernel, Simd};

pub use cylinder_lanes::{CylinderHits, SideLanes};

/// Where the ray meets the cylinder: the contract of [`CylinderRecord::intersect`], and right. `axis` is the file's,
/// as long as the cylinder is high, and `record` was made from it.
///
/// ```
/// use cpu::intersect::{self, CylinderPart, CylinderRecord};
/// use cpu::{Ray, Vec3};
///
/// let axis = Vec3::new(0.0, 4.0, 0.0);
/// let cylinder = CylinderRecord::new(Vec3::ZERO, 1.0, axis);
/// // To the last bit through the rim: side and base are equally near, and the later counts.
/// let ray = Ray { origin: Vec3::new(0.0, 4.0, -3.0), direction: Vec3::new(0.0, -1.0, 1.0) };
/// assert_eq!(intersect::cylinder(&cylinder, &axis, &ray), Some((2.0, CylinderPart::Top)));
/// ```
#[inline(always)]
#[must_use]
pub fn intersect(record: &CylinderRecord, axis: &Vec3, ray: &Ray) -> Option<(f64, CylinderPart)> {
    match filtered(record, ray) {
        Decision::Certain(answer) => answer,
        Decision::Uncertain => precise(record, axis, ray),
    }
}

/// Returns the result of the plain formula in the arithmetic `T`, or that rounding may have changed it.
///
/// The cylinder is convex: the line meets its surface where it enters and where it leaves, and nowhere else. So no base
/// is nearer than the side where that is entered, none but the base that faces the ray is nearer than where the side is
/// left, and the other base counts only where nothing else does. From within, and from the surface inward, the side
/// where it is left mostly decides alone.
#[inline(always)]
#[must_use]
pub fn filtered<T: Rounding<Mask = bool>>(
    record: &CylinderRecord<T>,
    ray: &Ray<T>,
) -> Decision<Option<(T, CylinderPart)>> {
    let side = Side::new(record, &record.seen_from(ray.origin), ray.direction);
    if !in_scale(side.length_squared) {
        return Decision::Uncertain;
    }
    if side.bound.misses(side.discriminant) {
        return Decision::Certain(None);
    }
    let root = side.discriminant.sqrt();
    let (near, far) = (-side.h - root, -side.h + root);
    if side.is_behind(near, root) {
        let exit = side.crossing(record, ray, far, root);
        if exit.straight {
            return Decision::Certain(Some((exit.lambda, CylinderPart::Side)));
        }
    }
    let entry = side.crossing(record, ray, near, root);
    if entry.hits {
        return Decision::Certain(Some((entry.lambda, CylinderPart::Side)));
    }
    let exit = side.crossing(record, ray, far, root);
    if !(entry.fails() && (exit.hits || exit.fails())) {
        return Decision::Uncertain;
    }
    if entry.passes_by(&exit) {
        return Decision::Certain(None);
    }
    // Which base faces the ray cannot be guessed, so its centre is computed, by the formula of `record.top` and
    // `record.bottom`: a selection would become a branch.
    let slope = ray.direction.dot(record.axis);
    let along = record.axis * record.half_height.flipped_by(slope);
    let (facing, other) = (record.center - along, record.center + along);
    let part = |is_top: bool| if is_top { CylinderPart::Top } else { CylinderPart::Bottom };
    let down = slope.less(T::of(0.0));
    match cap(record, ray, facing, part(down)) {
        Decision::Certain(None) if exit.hits => Decision::Certain(Some((exit.lambda, CylinderPart::Side))),
        Decision::Certain(None) => cap(record, ray, other, part(!down)),
        decision => decision,
    }
}

/// The intersection with one cap, the `part` around `center`.
#[inline(always)]
fn cap<T: Rounding<Mask = bool>>(
    record: &CylinderRecord<T>,
    ray: &Ray<T>,
    center: Vec3<T>,
    part: CylinderPart,
) -> Decision<Option<(T, CylinderPart)>> {
    let plane = Plane::new(record, ray, center);
    if plane.fails {
        return Decision::Certain(None);
    }
    let disc = plane.disc(record, ray);
    match (disc.hits, disc.fails) {
        (true, _) => Decision::Certain(Some((disc.lambda, part))),
        (_, true) => Decision::Certain(None),
        _ => Decision::Uncertain,
    }
}

/// The answer of a ray that is in doubt, at the price of some thousand operations.
#[cold]
#[inline(never)]
#[must_use]
pub fn precise(record: &CylinderRecord, axis: &Vec3, ray: &Ray) -> Option<(f64, CylinderPart)> {
    crate::counters::add(crate::counters::Counter::Fallbacks, 1);
    match InstructionSet::fused().run(Precisely { record, axis, ray }) {
        Decision::Certain(answer) => answer.map(|(lambda, part)| (lambda.high, part)),
        Decision::Uncertain => cylinder_exact::intersect(record.center, record.radius, *axis, ray)
            .unwrap_or_else(|NotFinite| record.intersect(ray)),
    }
}

/// [`filtered`] in double-double arithmetic.
struct Precisely<'a> {
    record: &'a CylinderRecord,
    axis: &'a Vec3,
    ray: &'a Ray,
}

impl Kernel for Precisely<'_> {
    type Output = Decision<Option<(DoubleDouble, CylinderPart)>>;

    #[inline(always)]
    fn call<S: Simd>(self, _: S) -> Self::Output {
        let Self { record, axis, ray } = self;
        let of = DoubleDouble::of;
        filtered(&CylinderRecord::new(record.center.map(of), of(record.radius), axis.map(of)), &ray.lanes())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::cylinder::PARALLEL;

    fn ray(origin: [f64; 3], direction: [f64; 3]) -> Ray {
        Ray { origin: origin.into(), direction: direction.into() }
    }

    fn meets(axis: [f64; 3], ray: &Ray) -> Option<(f64, CylinderPart)> {
        let axis = axis.into();
        intersect(&CylinderRecord::new(Vec3::ZERO, 1.0, axis), &axis, ray)
    }

    const UPRIGHT: [f64; 3] = [0.0, 4.0, 0.0];

    #[test]
    fn plain_rays_are_certain_and_the_textbooks() {
        let record = CylinderRecord::new(Vec3::ZERO, 1.0, UPRIGHT.into());
        for (ray, expected) in [
            (ray([0.1, 0.0, -3.0], [0.0, 0.1, 1.0]), Some(CylinderPart::Side)),
            (ray([0.0, 0.1, 0.0], [0.0, 0.1, 1.0]), Some(CylinderPart::Side)),
            (ray([0.5, 5.0, 0.0], [-0.3, -1.0, 0.1]), Some(CylinderPart::Top)),
            (ray([0.5, -5.0, 0.0], [-0.3, 1.0, 0.1]), Some(CylinderPart::Bottom)),
            (ray([0.0, 0.0, 0.0], [0.1, 1.0, 0.0]), Some(CylinderPart::Top)),
            // In the endless cylinder: above the base it is met first, and within it the side.
            (ray([0.0, 3.0, 0.0], [1.0, -1.5, 0.0]), Some(CylinderPart::Top)),
            (ray([0.0, -3.0, 0.0], [1.0, 1.5, 0.0]), Some(CylinderPart::Bottom)),
            (ray([0.0, 1.9, 0.0], [1.0, -1.5, 0.0]), Some(CylinderPart::Side)),
            (ray([1.1, 5.0, 0.0], [0.0, -1.0, 0.1]), None),
            (ray([0.0, 2.1, -3.0], [0.0, 0.1, 1.0]), None),
            (ray([0.0, 0.0, 3.0], [0.0, 0.1, 1.0]), None),
        ] {
            let decision = filtered(&record, &ray);
            assert_eq!(decision, Decision::Certain(record.intersect(&ray)), "{ray:?}");
            let Decision::Certain(answer) = decision else { unreachable!() };
            assert_eq!(answer.map(|(_, part)| part), expected, "{ray:?}");
        }
    }

    #[test]
    fn through_the_rim_the_base_counts() {
        assert_eq!(meets(UPRIGHT, &ray([0.0, 4.0, -3.0], [0.0, -1.0, 1.0])), Some((2.0, CylinderPart::Top)));
        assert_eq!(meets(UPRIGHT, &ray([0.0, -4.0, -3.0], [0.0, 1.0, 1.0])), Some((2.0, CylinderPart::Bottom)));
        // Out of it: the far root is on the rim.
        assert_eq!(meets(UPRIGHT, &ray([0.0, 1.0, 0.0], [0.0, 1.0, 1.0])), Some((1.0, CylinderPart::Top)));
    }

    #[test]
    fn along_the_axis_only_bases_are_met() {
        for axis in [UPRIGHT, [1.0, 2.0, -0.3]] {
            let direction = axis.map(|component| component * 0.25);
            let hit = meets(axis, &ray([0.0; 3], direction));
            assert_eq!(hit, Some((2.0, CylinderPart::Top)), "{axis:?}");
        }
        assert_eq!(
            meets(UPRIGHT, &ray([1.0, 5.0, 0.0], [0.0, -2.0, 0.0])),
            Some((1.5, CylinderPart::Top)),
            "on the rim"
        );
        assert_eq!(meets(UPRIGHT, &ray([1.0_f64.next_up(), 5.0, 0.0], [0.0, -2.0, 0.0])), None);
    }

    #[test]
    fn along_the_bases_only_the_side_is_met() {
        assert_eq!(
            meets(UPRIGHT, &ray([0.0, 2.0, -3.0], [0.0, 0.0, 1.0])),
            Some((2.0, CylinderPart::Side)),
            "in the plane"
        );
        assert_eq!(meets(UPRIGHT, &ray([0.0, 2.0_f64.next_up(), -3.0], [0.0, 0.0, 1.0])), None);
        assert_eq!(meets(UPRIGHT, &ray([0.0, 0.0, -3.0], [0.0, 0.0, 0.5])), Some((4.0, CylinderPart::Side)));
        assert_eq!(meets(UPRIGHT, &ray([1.0, 0.0, -3.0], [0.0, 0.0, 0.5])), Some((6.0, CylinderPart::Side)), "tangent");
        assert_eq!(meets(UPRIGHT, &ray([1.0_f64.next_up(), 0.0, -3.0], [0.0, 0.0, 0.5])), None);
    }

    #[test]
    fn planes_within_the_limit_of_parallel_are_skipped() {
        // Slopes around 1e-8: the one just below meets no base, though its line would.
        let start = [0.0, 1.0 - 1e-9, 0.0];
        let toward = |slope: f64| ray(start, [0.5, slope, 0.0]);
        let flat = [0.0, 2.0, 0.0];
        assert_eq!(meets(flat, &toward(PARALLEL)).map(|(_, part)| part), Some(CylinderPart::Top));
        assert_eq!(meets(flat, &toward(PARALLEL.next_down())), None, "the side is met above the base");
    }

    #[test]
    fn a_null_direction_and_numbers_that_are_none_are_the_textbooks() {
        assert_eq!(meets(UPRIGHT, &ray([0.0; 3], [0.0; 3])), None);
        assert_eq!(meets(UPRIGHT, &ray([0.0, f64::NAN, 0.0], [0.0, 1.0, 0.0])), None);
    }
}
