//! The closest hits of several rays at once.

use crate::render::fallback::precise;
use crate::{
    accel::object::ObjectId, counters::Counter, counters::add, exact, exact::error_bound::in_scale,
    geometry::cylinder::CylinderPart, geometry::cylinder::CylinderRecord, geometry::cylinder::CylinderView,
    geometry::ray::Ray, geometry::sphere::SphereRecord, geometry::sphere::SphereView, geometry::tie::later_is_closer,
    math::vec3::Vec3, simd::LaneMask, simd::SimdF64,
};

/// Relative bound of the rounding error of a discriminant, several times what the filter's error bounds prove.
const DISCRIMINANT_ERROR: f64 = 512.0 * f64::EPSILON;

/// A cylinder and its axis in the scene file.
type Cylinder<'a> = (&'a CylinderRecord, &'a Vec3);

/// The closest hits of several rays, one in each lane. Object and part are whole numbers.
#[derive(Clone, Copy)]
pub struct HitLanes<V: SimdF64> {
    /// Lambda of each hit; infinite in lanes without a hit.
    pub lambda: V,
    /// The object that is hit.
    pub object: V,
    /// The part of a cylinder, as [`CylinderPart`]'s number.
    pub part: V,
    /// Lanes with a hit, as bits.
    pub bits: u32,
}

/// Several rays, one in each lane.
pub struct Rays<'a, V: SimdF64> {
    ray: &'a Ray<V>,
    /// The squared lengths of their directions.
    a: V,
    /// `a` times the relative bound of a discriminant's rounding error; infinite for directions that are not
    /// [in scale](in_scale), so that no discriminant, which may have underflowed, is taken for a certain miss.
    discriminant_error: V,
    /// The lanes that hold a ray, as bits.
    valid: u32,
}

impl<'a, V: SimdF64> Rays<'a, V> {
    /// The rays of the valid lanes.
    #[inline(always)]
    pub fn new(ray: &'a Ray<V>, valid: u32) -> Self {
        let a = ray.direction.dot(ray.direction);
        let discriminant_error = V::select(in_scale(a), a * V::of(DISCRIMINANT_ERROR), V::of(f64::INFINITY));
        Self { ray, a, discriminant_error, valid }
    }

    /// Whether any ray may hit an object, given the discriminant and the sum of the squares in it. All rays miss most
    /// objects, and this test is shorter than the whole filter.
    #[inline(always)]
    fn may_hit(&self, discriminant: V, squares: V) -> bool {
        (!discriminant.less(-(self.discriminant_error * squares))).bits() & self.valid != 0
    }

    /// The lanes whose answer is uncertain, as bits.
    #[inline(always)]
    fn uncertain(&self, certain: V::Mask) -> u32 {
        (!certain).bits() & self.valid
    }
}

impl<V: SimdF64> HitLanes<V> {
    /// No hits.
    #[inline(always)]
    pub fn none() -> Self {
        Self { lambda: V::of(f64::INFINITY), object: V::of(0.0), part: V::of(0.0), bits: 0 }
    }

    /// Replaces hits by those with `object` that are at most as far, in the `valid` lanes. `object` must come later in
    /// the file than all objects before, because the later of two equally distant hits counts. The lambda of a miss is
    /// infinite in `certain` lanes, and NaN in the others, because a hit's lambda may overflow to infinity there.
    #[inline(always)]
    fn update(&mut self, object: ObjectId, (lambda, part): (V, V), certain: V::Mask, valid: u32) {
        let is_hit = lambda.less(V::of(f64::INFINITY)) | !certain;
        let closer = is_hit & later_is_closer(lambda, self.lambda);
        self.lambda = V::select(closer, lambda, self.lambda);
        self.object = V::select(closer, V::of(f64::from(object)), self.object);
        self.part = V::select(closer, part, self.part);
        self.bits |= closer.bits() & valid;
    }

    /// Intersects camera rays with a sphere, given its view.
    #[inline(always)]
    pub fn intersect_sphere(&mut self, id: ObjectId, record: &SphereRecord, view: &SphereView<V>, rays: &Rays<V>) {
        let (_, discriminant) = view.quadratic(rays.ray.direction, rays.a);
        if rays.may_hit(discriminant, view.squares) {
            self.filtered_sphere(id, record, view, rays);
        }
    }

    /// Intersects rays with a sphere that at least one of them may hit. Their origins lie within the scene's extent.
    #[inline(always)]
    pub fn filtered_sphere(&mut self, id: ObjectId, record: &SphereRecord, view: &SphereView<V>, rays: &Rays<V>) {
        let &Rays { ray, a, valid, .. } = rays;
        let lanes = exact::sphere::filtered_from(view, ray.direction, a);
        let mut certain = lanes.certain & in_scale(a);
        let mut hits = (lanes.lambda, V::of(0.0));
        let uncertain = rays.uncertain(certain);
        if uncertain != 0 {
            let compensated = exact::sphere_compensated::compensated(&record.lanes(), ray);
            hits.0 = V::select(certain, hits.0, compensated.lambda);
            certain = certain | compensated.certain;
            let still_uncertain = rays.uncertain(certain);
            add(Counter::Compensated, u64::from((uncertain & !still_uncertain).count_ones()));
            if still_uncertain != 0 {
                let intersect = |ray: &Ray| Some((exact::sphere::precise(record, ray)?, CylinderPart::Side));
                hits = precise(ray, hits, still_uncertain, &intersect);
            }
        }
        self.update(id, hits, certain, valid);
    }

    /// Intersects camera rays with a cylinder, given its view and the file's axis.
    #[inline(always)]
    pub fn intersect_cylinder(&mut self, id: ObjectId, cylinder: Cylinder, view: &CylinderView<V>, rays: &Rays<V>) {
        let (.., discriminant) = cylinder.0.lanes::<V>().quadratic(view, rays.ray.direction);
        if rays.may_hit(discriminant, view.squares) {
            self.filtered_cylinder(id, cylinder, view, rays);
        }
    }

    /// Intersects rays with a cylinder that at least one of them may hit. Their origins lie within the scene's extent.
    #[inline(always)]
    pub fn filtered_cylinder(&mut self, id: ObjectId, cylinder: Cylinder, view: &CylinderView<V>, rays: &Rays<V>) {
        let (record, axis) = cylinder;
        let &Rays { ray, a, valid, .. } = rays;
        let lanes_record = record.lanes::<V>();
        let side = exact::cylinder::SideLanes::new(&lanes_record, view, ray);
        // Most rays do not come near the caps.
        let needs_caps = side.open.bits() & valid != 0;
        let lanes = if needs_caps { side.with_caps(&lanes_record, ray) } else { side.without_caps() };
        let number = |part: CylinderPart| V::of(f64::from(part as u32));
        let over = V::select(lanes.top, number(CylinderPart::Top), number(CylinderPart::Side));
        let mut hits = (lanes.lambda, V::select(lanes.bottom, number(CylinderPart::Bottom), over));
        let certain = lanes.certain & in_scale(a);
        let uncertain = rays.uncertain(certain);
        if uncertain != 0 {
            hits = precise(ray, hits, uncertain, &|ray| exact::cylinder::precise(record, axis, ray));
        }
        self.update(id, hits, certain, valid);
    }
}
