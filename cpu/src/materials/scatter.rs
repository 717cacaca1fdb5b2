//! Adds a random vector to a direction (specification, sections 10.1 and 10.2). The reference has a copy of this rule
//! in `reference.rs` (`scatter`), and WGSL has one in `scatter.wgsl`.

use crate::math::{real::Real, vec3::Vec3, vec3::broadcast};

/// The constants with which a surface scatters a ray around a direction. Let `s` be the scatter sample. The surface
/// adds the random vector `s * scale + shift` to the direction. With lanes, each lane may have its own surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScatterParams<T = f64> {
    /// The factor by which the scatter sample is multiplied.
    pub scale: T,
    /// The term that is added to each component of the random vector.
    pub shift: T,
    /// If all components of a scattered direction are smaller than this in magnitude, [`scatter_around`] replaces the
    /// direction. It is above 0 only for matte surfaces.
    pub negligible: T,
}

broadcast!(ScatterParams:; scale, shift, negligible);

impl<T: Real> ScatterParams<T> {
    /// Returns the random vector that `scatter_sample` gives.
    #[inline(always)]
    pub(crate) fn vector(&self, scatter_sample: Vec3<T>) -> Vec3<T> {
        scatter_sample * self.scale + Vec3::splat(self.shift)
    }
}

impl ScatterParams {
    /// Returns the direction of a ray that is scattered around `unperturbed` with this scatter sample.
    #[inline(always)]
    pub fn scatter_around(&self, unperturbed: Vec3, scatter_sample: Vec3) -> Vec3 {
        scatter_around(unperturbed, self.vector(scatter_sample), self.negligible)
    }
}

/// Returns the sum of the direction `unperturbed` and a random vector. If every component of the sum is smaller than
/// `negligible` in magnitude, the result is `unperturbed`.
#[inline(always)]
pub fn scatter_around<T: Real<Mask = bool>>(unperturbed: Vec3<T>, vector: Vec3<T>, negligible: T) -> Vec3<T> {
    let direction = unperturbed + vector;
    if direction.x.abs().less(negligible) && are_within(direction.y, direction.z, negligible) {
        return unperturbed;
    }
    direction
}

/// The last two comparisons of [`Vec3::is_negligible`], which rays seldom need. They are out of line, behind a branch.
/// LLVM otherwise turns all three into a selection, and the next steps of the ray depend on its result.
#[cold]
#[inline(never)]
fn are_within<T: Real<Mask = bool>>(y: T, z: T, limit: T) -> bool {
    y.abs().less(limit) && z.abs().less(limit)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::vec3::NEGLIGIBLE;

    #[test]
    fn a_negligible_sum_is_replaced_by_the_direction() {
        let up = Vec3::new(0.0, 1.0, 0.0);
        let around_up = |vector| scatter_around(up, vector, NEGLIGIBLE);
        assert_eq!(around_up(Vec3::new(0.5, 0.0, 0.0)), Vec3::new(0.5, 1.0, 0.0));
        assert_eq!(around_up(-up), up);
        assert_eq!(around_up(Vec3::new(9e-9, -1.0, 0.0)), up);
        assert_eq!(around_up(Vec3::new(2e-8, -1.0, 0.0)), Vec3::new(2e-8, 0.0, 0.0));
        assert_eq!(scatter_around(up, -up, 0.0), Vec3::ZERO);
    }
}
