//! The rule for two hits at the same lambda: the later one counts (specification, section 8.2).
//!
//! "Later" is in the order of the file, spheres and cylinders together, and within a cylinder in the order side, top
//! cap, bottom cap. All comparisons of objects call this file. Two parts of a cylinder have the same lambda only on its
//! edge: there the exact twin decides, `closest_part` in `exact/cylinder_exact.rs`; elsewhere `exact/cylinder.rs` knows
//! the part by itself. The reference has its literal copy in `update` of `reference/nearest.rs`, and WGSL in
//! `closest_hit.wgsl`.

use crate::math::real::Real;

/// Whether a hit at `lambda` replaces an earlier hit at `closest`, which is infinite if there is no earlier hit.
#[inline(always)]
pub fn later_is_closer<T: Real>(lambda: T, closest: T) -> T::Mask {
    lambda.less_equal(closest)
}

/// Whether a hit replaces the closest hit so far. Both hits are pairs of lambda and the object's place in the file.
#[inline(always)]
pub fn is_closer((lambda, order): (f64, u32), (closest, closest_order): (f64, u32)) -> bool {
    later_is_closer(lambda, closest) && (lambda < closest || order >= closest_order)
}
