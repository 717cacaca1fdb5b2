//! Several rays or cylinders at once, without a branch; see [`super::cylinder`] for one.

use super::certificate::Rounding;
use super::cylinder::{LIMITS, Side, disc};
use crate::cylinder::CylinderRecord;
use crate::ray::Ray;
use crate::real::Real;

/// The answers of several rays or cylinders at once.
#[derive(Clone, Copy, Debug)]
pub struct Lanes<T: Real> {
    /// What the textbook says; infinite where it finds no hit. Of no meaning in a lane that is not certain.
    pub lambda: T,
    /// Lanes that meet the upper base, if they meet anything.
    pub top: T::Mask,
    /// Lanes that meet the lower base rather than anything else, if they meet anything. It comes before `top`.
    pub bottom: T::Mask,
    /// Lanes whose answer is right. The others are for [`resolve`](super::cylinder::resolve).
    pub certain: T::Mask,
}

/// [`judge`](super::cylinder::judge) without a branch, for several lanes at once: the same bits in every lane. That directions are
/// [in scale](super::certificate::in_scale) the caller sees to, once a ray.
#[inline(always)]
#[must_use]
pub fn judge_lanes<T: Rounding>(record: &CylinderRecord<T>, ray: &Ray<T>) -> Lanes<T> {
    let nowhere = T::of(f64::INFINITY);
    let side = Side::new(record, ray);
    let misses = side.certificate.misses(side.discriminant);
    let root = side.discriminant.sqrt();
    let entry = side.crossing(record, ray, -side.h - root, root);
    let exit = side.crossing(record, ray, -side.h + root, root);
    let (top, bottom) = (disc(record, ray, record.top), disc(record, ray, record.bottom));
    let exit_lambda = T::select(exit.hits, exit.lambda, nowhere);
    let top_lambda = T::select(top.hits, top.lambda, nowhere);
    let bottom_lambda = T::select(bottom.hits, bottom.lambda, nowhere);
    let over_top = T::select(top_lambda.less(exit_lambda), top_lambda, exit_lambda);
    let over_all = T::select(bottom_lambda.less(over_top), bottom_lambda, over_top);
    // The larger of two must exceed the smaller by more than both may be wrong; nowhere exceeds all.
    let apart = |one: T, other: T| {
        let (low, high) = (T::select(one.less(other), one, other), T::select(one.less(other), other, one));
        (low + low * T::of(2.0 * LIMITS.lambda_error::<T>())).less(high) | nowhere.less_equal(low)
    };
    let known = entry.fails & (exit.hits | exit.fails) & (top.hits | top.fails) & (bottom.hits | bottom.fails);
    let ordered = apart(exit_lambda, top_lambda) & apart(over_top, bottom_lambda);
    // Where the side is entered no base can be nearer, so that none may be named.
    let not_entered = |mask: T::Mask| entry.fails & mask;
    Lanes {
        lambda: T::select(misses, nowhere, T::select(entry.hits, entry.lambda, over_all)),
        top: not_entered(top_lambda.less(exit_lambda)),
        bottom: not_entered(bottom_lambda.less(over_top)),
        certain: misses | entry.hits | (known & ordered),
    }
}
