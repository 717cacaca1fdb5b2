//! The closest hits of several rays, which are found at once.

use crate::exact::cylinder_lanes::SideLanes;
use crate::exact::cylinder_plain::{PlainCaps, PlainSide, is_long};
use crate::render::compensated_lanes::{CylinderAndFileAxis, uncertain_cylinder};
use crate::render::{lane_by_lane::closer_of_near, lane_by_lane::lane_by_lane, lane_numbers::ObjectNumber};
use crate::{
    accel::closest_hit::is_exactly_closer, accel::object::ObjectId, counters::Counter, counters::add, exact,
    exact::error_bound::in_scale, exact::order::is_certainly_closer, exact::sphere_compensated::SphereTerms,
    geometry::cylinder::CylinderPart, geometry::cylinder::CylinderView, geometry::ray::Ray,
    geometry::sphere::SphereRecord, geometry::sphere::SphereView, layout::Objects, simd::SimdF64,
};

/// A bound of the rounding error of a discriminant, relative to `|d|^2 (|O - C|^2 + r^2)`, for the ray `O + lambda d`
/// and an object with centre `C` and radius `r`. It is `1024 u` with `u = EPSILON / 2`, at least five times the error
/// constants of the filters.
pub const DISCRIMINANT_ERROR: f64 = 512.0 * f64::EPSILON;

/// The limit of `|O - C|^2 + r^2`, 2^700. If the sum is smaller, no discriminant overflows for a direction that is [in
/// scale](in_scale).
pub const LARGEST_SQUARES: f64 = f64::from_bits((1023 + 700) << 52);

/// Returns `|O - C|^2 + r^2`, or infinity if a discriminant may overflow. Then no miss is certain.
pub fn limited(squares: f64) -> f64 {
    if squares < LARGEST_SQUARES { squares } else { f64::INFINITY }
}

/// Whether the object of one of the lanes in `bits` is so far away that its squares may have been [`limited`]. Then
/// these lanes take all steps of a single ray, since the plain formula may be certain with the real squares.
#[inline(always)]
fn is_far<V: SimdF64>(squares: V, bits: u32) -> bool {
    V::bits(!squares.less(V::of(LARGEST_SQUARES))) & bits != 0
}

/// The closest hit of each of several rays, one ray in each lane. The number of the part is stored as a
/// whole number in `f64` lanes.
#[derive(Clone, Copy)]
pub struct HitLanes<V: SimdF64> {
    /// The lambda of each hit. It is infinite in lanes without a hit.
    pub lambda: V,
    /// The object that is hit.
    pub object: ObjectNumber<V>,
    /// The part of a cylinder that is hit, as its [number](CylinderPart::number). It is the side for a sphere.
    pub part: V,
    /// A bit for each lane, which is 1 if the ray hits an object.
    pub bits: u32,
}

/// Several rays, one in each lane, and the objects that they may hit.
pub struct Rays<'a, V: SimdF64, O> {
    objects: &'a O,
    ray: &'a Ray<V>,
    /// The square of each direction's length.
    a: V,
    /// `a` times [`DISCRIMINANT_ERROR`]. It is infinite for directions that are not [in scale](in_scale), because their
    /// discriminants may have underflowed and show no certain miss.
    discriminant_error: V,
    /// A bit for each lane, which is 1 if the lane holds a ray.
    valid: u32,
}

impl<'a, V: SimdF64, O: Objects> Rays<'a, V, O> {
    /// Prepares the rays. `valid` has a bit for each lane that holds a ray.
    #[inline(always)]
    pub(crate) fn new(objects: &'a O, ray: &'a Ray<V>, valid: u32) -> Self {
        let a = ray.direction.dot(ray.direction);
        let discriminant_error = V::select(in_scale(a), a * V::of(DISCRIMINANT_ERROR), V::of(f64::INFINITY));
        Self { objects, ray, a, discriminant_error, valid }
    }

    /// Whether at least one ray may hit an object with this discriminant. `squares` is `|O - C|^2 + r^2`. For most
    /// objects all rays miss, and this test is shorter than the filter.
    #[inline(always)]
    fn may_hit(&self, discriminant: V, squares: V) -> bool {
        V::bits(!discriminant.less(-(self.discriminant_error * squares))) & self.valid != 0
    }

    /// Returns a bit for each lane, which is 1 if the lane holds a ray and its result is uncertain.
    #[inline(always)]
    fn uncertain(&self, certain: V::Mask) -> u32 {
        V::bits(!certain) & self.valid
    }
}

impl<V: SimdF64> HitLanes<V> {
    /// Returns the value before any hit.
    #[inline(always)]
    pub(crate) fn none() -> Self {
        Self { lambda: V::of(f64::INFINITY), object: ObjectNumber(V::of(-1.0)), part: V::of(0.0), bits: 0 }
    }

    /// Replaces the hit of a lane by the hit with `object`, if that hit is closer. In `certain` lanes an infinite
    /// lambda means a miss. In all other lanes NaN means a miss, because a hit's lambda may overflow to infinity there.
    /// Lanes whose lambdas do not decide are [decided one by one](closer_of_near).
    #[inline(always)]
    fn update<O: Objects>(&mut self, object: ObjectId, (lambda, part): (V, V), certain: V::Mask, rays: &Rays<V, O>) {
        let object = ObjectNumber::of(object).0;
        let infinity = V::of(f64::INFINITY);
        let hits = lambda.less(infinity) | (lambda.less_equal(infinity) & !certain);
        let closer = hits & is_certainly_closer(lambda, self.lambda);
        let near = hits & !closer & !is_certainly_closer(self.lambda, lambda);
        self.lambda = V::select(closer, lambda, self.lambda);
        self.object.0 = V::select(closer, object, self.object.0);
        self.part = V::select(closer, part, self.part);
        self.bits |= V::bits(closer) & rays.valid;
        let near = V::bits(near) & rays.valid;
        if near != 0 {
            let (hit, closest) = ([lambda, object, part], [self.lambda, self.object.0, self.part]);
            let (closest, closer) = closer_of_near(rays.ray, (hit, closest), near, &|ray, pair| {
                is_exactly_closer(rays.objects, *ray, pair[0], pair[1])
            });
            [self.lambda, self.object.0, self.part] = closest;
            self.bits |= closer;
        }
    }

    /// Intersects camera rays with a sphere, and updates the hits. `view` has the sphere's terms for the camera's
    /// position, with [`limited`] squares.
    #[inline(always)]
    pub(crate) fn intersect_sphere<O: Objects>(
        &mut self,
        id: ObjectId,
        record: &SphereRecord,
        view: &SphereView<V>,
        rays: &Rays<V, O>,
    ) {
        let (_, discriminant) = view.quadratic(rays.ray.direction, rays.a);
        if rays.may_hit(discriminant, view.squares) {
            self.filtered_sphere(id, record, view, rays);
        }
    }

    /// Intersects rays with a sphere that at least one of them may hit, and updates the hits. Each ray has its own
    /// origin, which must lie inside the scene's extent.
    #[inline(always)]
    pub(crate) fn filtered_sphere<O: Objects>(
        &mut self,
        id: ObjectId,
        record: &SphereRecord,
        view: &SphereView<V>,
        rays: &Rays<V, O>,
    ) {
        let &Rays { ray, a, .. } = rays;
        let lanes = exact::sphere::filtered_from(view, ray.direction, a);
        let mut certain = lanes.certain & in_scale(a);
        let mut hits = (lanes.lambda, V::of(0.0));
        let uncertain = rays.uncertain(certain);
        if uncertain != 0 {
            if is_far(view.squares, uncertain) {
                let intersect = |ray: &Ray| Some((exact::sphere::intersect(record, ray)?, CylinderPart::Side));
                return self.update(id, lane_by_lane(ray, hits, uncertain, &intersect), certain, rays);
            }
            let terms = SphereTerms::new(&record.lanes(), ray);
            let near = terms.hits(terms.quadratic.near());
            hits.0 = V::select(certain, hits.0, near.lambda);
            certain = certain | near.certain;
            if rays.uncertain(certain) != 0 {
                let far = terms.hits(terms.far());
                hits.0 = V::select(certain, hits.0, far.lambda);
                certain = certain | far.certain;
            }
            let still_uncertain = rays.uncertain(certain);
            add(Counter::Compensated, u64::from((uncertain & !still_uncertain).count_ones()));
            if still_uncertain != 0 {
                let intersect = |ray: &Ray| Some((exact::sphere::wide_or_precise(record, ray)?, CylinderPart::Side));
                hits = lane_by_lane(ray, hits, still_uncertain, &intersect);
            }
        }
        self.update(id, hits, certain, rays);
    }

    /// Intersects camera rays with a cylinder, and updates the hits. `cylinder` is the record and the axis of the scene
    /// file. `view` has the cylinder's terms for the camera's position, with [`limited`] squares.
    #[inline(always)]
    pub(crate) fn intersect_cylinder<O: Objects>(
        &mut self,
        id: ObjectId,
        cylinder: CylinderAndFileAxis,
        view: &CylinderView<V>,
        rays: &Rays<V, O>,
    ) {
        let (.., discriminant) = cylinder.0.lanes::<V>().quadratic(view, rays.ray.direction);
        if rays.may_hit(discriminant, view.squares) {
            self.filtered_cylinder(id, cylinder, view, rays);
        }
    }

    /// Intersects rays with a cylinder that at least one of them may hit, and updates the hits. Each ray has its own
    /// origin, which must lie inside the scene's extent. `cylinder` is the record and the axis of the scene file.
    #[inline(always)]
    pub(crate) fn filtered_cylinder<O: Objects>(
        &mut self,
        id: ObjectId,
        cylinder: CylinderAndFileAxis,
        view: &CylinderView<V>,
        rays: &Rays<V, O>,
    ) {
        let (record, file_axis) = cylinder;
        let &Rays { ray, a, valid, .. } = rays;
        let lanes_record = record.lanes::<V>();
        let side = SideLanes::new(&PlainSide::new(&lanes_record, view, ray, is_long(record)));
        let lanes = side.with_needed_caps(&lanes_record, ray, &PlainCaps, valid);
        let mut hits = (lanes.lambda, lanes.part());
        let certain = lanes.certain & in_scale(a);
        let uncertain = rays.uncertain(certain);
        if uncertain != 0 {
            hits = if is_far(view.squares, uncertain) {
                lane_by_lane(ray, hits, uncertain, &|ray| exact::cylinder::intersect(record, file_axis, ray))
            } else {
                uncertain_cylinder(ray, hits, uncertain, cylinder)
            };
        }
        self.update(id, hits, certain, rays);
    }
}

#[cfg(test)]
mod tests;
