//! The rule for two hits at the same lambda: the later one counts (specification, section 8.2).
//!
//! "Later" means later in the order of the scene file, with spheres and cylinders together. Within a cylinder the order
//! is side, top cap, bottom cap. All comparisons of the hits on two objects call the functions of this module. In lanes
//! the objects are intersected in the order of the scene file (`object::in_order` and `render/frustum.rs` sort them by
//! the places that `layout.rs` gives). Before the first hit lambda is infinite (`accel/closest_hit.rs`,
//! `render/hit_lanes.rs`). The order of a cylinder's parts stands in `intersect` of `geometry/cylinder.rs`. Two parts
//! of a cylinder have the same lambda only on its edge, and `closest_part` in `exact/cylinder_exact.rs` decides there.
//! Elsewhere there is no tie, so `exact/cylinder.rs` and `exact/cylinder_lanes.rs` find the part without this rule. The
//! reference has a literal copy of this rule in `update` of `reference/nearest.rs`, and WGSL has one in `tie.wgsl`.

use crate::math::real::Real;

/// Returns `lambda <= closest`: whether a later hit, at `lambda`, replaces the closest hit so far, which is at
/// `closest`. Of two hits at the same lambda the later one counts. So the caller must take the objects in the order of
/// the scene file, and the parts of a cylinder in the order side, top, bottom. Without a hit so far, `closest` is
/// infinite.
#[inline(always)]
pub fn later_is_closer<T: Real>(lambda: T, closest: T) -> T::Mask {
    lambda.less_equal(closest)
}

/// Whether the first hit replaces the second, which is the closest hit so far: its lambda is smaller, or the lambdas
/// are equal and its object is later in the scene file. Each hit is a pair of lambda and the object's place in the
/// scene file. The objects may come in any order. It serves one ray; lanes call [`later_is_closer`].
#[inline(always)]
pub fn is_closer<T: Real<Mask = bool>>((lambda, order): (T, u32), (closest, closest_order): (T, u32)) -> bool {
    later_is_closer(lambda, closest) && (lambda.less(closest) || order >= closest_order)
}
