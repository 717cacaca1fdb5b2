//! The rule for two hits at the same lambda (specification, section 8.2): a sphere or the side of a cylinder replaces
//! what was found before, and a cap does not.
//!
//! "Before" means earlier in the order of the scene file, with spheres and cylinders together. Within a cylinder the
//! order is side, top cap, bottom cap. So of surfaces at the same lambda the last sphere or side counts. If all of them
//! are caps, the first one counts.
//!
//! Hits on several objects are found in any order, so their [ranks](rank) are compared, by `accel/closest_hit.rs`. Two
//! parts of a cylinder have the same lambda only on its edge, and `closest_part` in `exact/cylinder.rs` decides there.
//! Elsewhere there is no tie, so `exact/cylinder_decision.rs` finds the part without this rule. The reference has a
//! literal copy of this rule in `is_nearer` of `reference/nearest.rs`, and WGSL has one in `tie.wgsl`. The plain
//! formulas in WGSL and their twins compare computed lambdas (`is_closer`).

use crate::math::real::Real;

/// Returns the rank of a hit among the hits at the same lambda: the hit with the highest rank counts. `file_index` is
/// the object's place in the scene file.
#[inline(always)]
pub fn rank(file_index: u32, on_cap: bool) -> i64 {
    let file_index = i64::from(file_index);
    if on_cap { -1 - file_index } else { file_index }
}

/// Returns `lambda < closest`: whether a later hit at `lambda`, on a cap, replaces the closest hit so far, which is at
/// `closest`. Without a hit so far the result has no meaning. Only the plain formulas compare so.
#[inline(always)]
pub fn later_cap_is_closer<T: Real>(lambda: T, closest: T) -> T::Mask {
    lambda.less(closest)
}

/// Whether the first hit replaces the second, which is the closest hit so far: its lambda is smaller, or the lambdas
/// are equal and its [rank] is not lower. Each hit is a pair of computed lambda and rank. The objects may come in any
/// order. Only tests and the twins of shaders compare so.
#[cfg(any(test, feature = "internals"))]
#[inline(always)]
pub fn is_closer<T: Real<Mask = bool>>((lambda, rank): (T, i64), (closest, closest_rank): (T, i64)) -> bool {
    lambda.less_equal(closest) && (lambda.less(closest) || rank >= closest_rank)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the index of the hit that counts, by the statement's rule, of hits at one lambda in the order of the
    /// scene file. Each hit says whether it is on a cap.
    fn counts(on_cap: [bool; 3]) -> usize {
        (0..3).fold(0, |best, later| if on_cap[later] { best } else { later })
    }

    #[test]
    fn in_any_order_of_search_the_hit_of_the_statement_counts() {
        for bits in 0..8 {
            let on_cap = [0, 1, 2].map(|index| bits >> index & 1 == 1);
            for search in [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]] {
                let (mut found, mut closest) = (usize::MAX, (f64::INFINITY, rank(0, false)));
                for index in search {
                    let hit = (2.0, rank(index as u32, on_cap[index]));
                    if is_closer(hit, closest) {
                        (found, closest) = (index, hit);
                    }
                }
                assert_eq!(found, counts(on_cap), "{on_cap:?} in the order {search:?}");
            }
        }
    }

    #[test]
    fn a_smaller_lambda_wins_whatever_the_rank() {
        assert!(is_closer((1.0, rank(5, true)), (2.0, rank(9, false))));
        assert!(!is_closer((2.0, rank(9, false)), (1.0, rank(5, true))));
        assert!(!later_cap_is_closer(2.0_f64, 2.0) && later_cap_is_closer(1.0_f64, 2.0));
        assert!(rank(0, false) > rank(0, true));
    }
}
