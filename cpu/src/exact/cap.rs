//! The rule of a hit on a cylinder's cap, with an error bound. This is the exact counterpart of
//! [`crate::geometry::cap`], and the programs decide by it.
//!
//! There are three results: a ray certainly hits a cap, certainly misses it, or the decision is uncertain. [`Plane`]
//! serves one ray and lanes, in `f64` and in double-double. [`filtered`] calls it for one ray. If double-double is
//! uncertain too, `Inputs::cap` of `exact/cylinder_exact.rs` decides without rounding. When a cap is tested, and which
//! of the two first, is decided in `exact/cylinder.rs` for one ray and in `exact/cylinder_lanes.rs` for lanes. The
//! reference has a literal copy of the rule in `cap` of `reference/nearest.rs`, and WGSL has one in `cylinder_cap` of
//! `cylinder.wgsl`.

use crate::exact::{
    cylinder_side::LIMITS, cylinder_side::extent, cylinder_side::magnitude, cylinder_side::margin,
    error_bound::Decision, error_bound::Outcome,
};
use crate::geometry::{cap::PARALLEL, cylinder::CylinderPart, cylinder::CylinderRecord, ray::Ray, ray::least_lambda};
use crate::math::{rounding::Rounding, vec3::Vec3};

/// Intersects the ray with the cap around `center`. Returns `Certain(Some((lambda, part)))` if the ray certainly hits
/// the cap, and `Certain(None)` if it certainly misses the cap. The result is `Uncertain` if rounding may have changed
/// this decision, or if lambda may be inaccurate. `part` is the name of this cap, top or bottom.
#[inline(always)]
pub(super) fn filtered<T: Rounding<Mask = bool>>(
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

/// The plane of a cap and one ray, with what is certain before lambda is computed.
pub(super) struct Plane<T: Rounding> {
    center: Vec3<T>,
    /// The distance from the ray's origin to the plane, measured along the axis. It is positive if the plane lies in
    /// the direction of the axis.
    to_plane: T,
    /// The dot product of the ray's direction and the axis.
    slope: T,
    /// The plane is certainly not hit. It is parallel to the ray, it is behind the ray's origin, or lambda is below
    /// [`least_lambda`].
    pub fails: T::Mask,
    /// The ray is certainly not parallel to the plane.
    steep: T::Mask,
    /// The plain formula gives a lambda that is accurate enough to be accepted.
    accurate: T::Mask,
}

impl<T: Rounding> Plane<T> {
    /// Returns the plane of the cap around `center`.
    #[inline(always)]
    pub fn new(record: &CylinderRecord<T>, ray: &Ray<T>, center: Vec3<T>) -> Self {
        let condition = LIMITS.condition_limit::<T>();
        let to_center = center - ray.origin;
        let (to_plane, slope) = (to_center.dot(record.axis), ray.direction.dot(record.axis));
        let (steepness, size_of_direction) = (slope.abs(), magnitude(ray.direction));
        let slope_error = size_of_direction * T::of(8.0 * T::UNIT_ROUNDOFF);
        let parallel = (steepness + slope_error).less(T::of(PARALLEL));
        let steep = (T::of(PARALLEL) + slope_error).less(steepness);
        // The distance is positive if the plane is in front of the ray.
        let distance = to_plane.flipped_by(slope);
        let size = extent(record) + magnitude(to_center);
        let distance_error = size * T::of(16.0 * T::UNIT_ROUNDOFF);
        let too_near = (distance + distance_error).less((steepness - slope_error) * least_lambda());
        let accurate =
            size.less(distance * T::of(4.0 * condition)) & size_of_direction.less(steepness * T::of(8.0 * condition));
        Self { center, to_plane, slope, fails: parallel | (steep & too_near), steep, accurate }
    }

    /// Returns lambda, and whether the ray certainly hits the cap or certainly misses it.
    #[inline(always)]
    pub fn disc(&self, record: &CylinderRecord<T>, ray: &Ray<T>) -> Outcome<T> {
        let lambda = self.to_plane / self.slope;
        let in_range = self.accurate & LIMITS.in_range(lambda);
        let from_center = (ray.at(lambda) - self.center).length();
        let margin = margin(record, ray, lambda);
        let (within, beyond) = (from_center.less(record.radius - margin), (record.radius + margin).less(from_center));
        Outcome { lambda, hits: self.steep & in_range & within, fails: self.fails | (self.steep & in_range & beyond) }
    }
}
