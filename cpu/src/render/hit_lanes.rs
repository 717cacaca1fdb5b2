//! The nearest hits of several rays at once.

use crate::accel::object::ObjectId;
use crate::counters::{Counter, add};
use crate::exact;
use crate::exact::error_bound::in_scale;
use crate::geometry::cylinder::{CylinderPart, CylinderRecord, CylinderView};
use crate::geometry::ray::Ray;
use crate::geometry::sphere::{SphereRecord, SphereView};
use crate::math::vec3::Vec3;
use crate::render::fallback::{precise_cylinders, precise_spheres};
use crate::simd::{LaneMask, SimdF64};

/// Relative bound of what rounding does to a discriminant, several times what the certificates prove.
const NOISE: f64 = 512.0 * f64::EPSILON;

/// The hits of as many rays as there are lanes; object and part are whole numbers.
#[derive(Clone, Copy)]
pub struct HitLanes<V: SimdF64> {
    /// Where on the ray; infinite in lanes that meet nothing.
    pub lambda: V,
    /// The object met.
    pub object: V,
    /// The part of a cylinder, as [`CylinderPart`]'s number.
    pub part: V,
    /// Lanes that meet something, as bits.
    pub bits: u32,
}

/// As many rays as there are lanes.
pub struct Rays<'a, V: SimdF64> {
    ray: &'a Ray<V>,
    /// The squared lengths of their directions.
    a: V,
    /// `a` times the relative bound of what rounding does to a discriminant; infinite for directions that are not
    /// [in scale](in_scale), so that no discriminant, which may have underflowed, is taken for a certain miss.
    noise: V,
    /// The lanes whose rays count, as bits.
    valid: u32,
}

impl<'a, V: SimdF64> Rays<'a, V> {
    /// The rays of the valid lanes.
    #[inline(always)]
    pub fn new(ray: &'a Ray<V>, valid: u32) -> Self {
        let a = ray.direction.dot(ray.direction);
        Self { ray, a, noise: V::select(in_scale(a), a * V::of(NOISE), V::of(f64::INFINITY)), valid }
    }
}

impl<V: SimdF64> HitLanes<V> {
    /// No hits.
    #[inline(always)]
    pub fn none() -> Self {
        Self { lambda: V::of(f64::INFINITY), object: V::of(0.0), part: V::of(0.0), bits: 0 }
    }

    /// Takes hits with an object later in the file into account, in the `valid` lanes: of equals the later counts.
    #[inline(always)]
    fn update(&mut self, object: ObjectId, lambda: V, met: V::Mask, part: V, valid: u32) {
        let closer = met & lambda.less_equal(self.lambda);
        self.lambda = V::select(closer, lambda, self.lambda);
        self.object = V::select(closer, V::of(f64::from(object)), self.object);
        self.part = V::select(closer, part, self.part);
        self.bits |= closer.bits() & valid;
    }

    /// Takes the hits with a sphere into account, given its view and the directions' squares.
    #[inline(always)]
    pub fn intersect_sphere(&mut self, id: ObjectId, record: &SphereRecord, view: &SphereView<V>, rays: &Rays<V>) {
        let &Rays { ray, a, noise, valid } = rays;
        let (_, discriminant) = view.quadratic(ray.direction, a);
        // Most spheres are missed by all lanes: the whole certificate is for the others.
        let certainly_missed = discriminant.less(-(noise * view.squares));
        if (!certainly_missed).bits() & valid == 0 {
            return;
        }
        self.filtered_sphere(id, record, view, rays);
    }

    /// The same for a sphere that the valid lanes, which start within the scene's reach, may meet.
    #[inline(always)]
    pub fn intersect_candidate_sphere(&mut self, id: ObjectId, record: &SphereRecord, rays: &Rays<V>) {
        let view = record.lanes().seen_from(rays.ray.origin);
        self.filtered_sphere(id, record, &view, rays);
    }

    #[inline(always)]
    fn filtered_sphere(&mut self, id: ObjectId, record: &SphereRecord, view: &SphereView<V>, rays: &Rays<V>) {
        let &Rays { ray, a, valid, .. } = rays;
        let lanes = exact::sphere::filtered_from(view, ray.direction, a);
        let certain = lanes.certain & in_scale(a);
        let mut lambda = lanes.lambda;
        if (!certain).bits() & valid != 0 {
            let compensated = exact::sphere_compensated::compensated(&record.lanes(), ray);
            lambda = V::select(certain, lambda, compensated.lambda);
            let doubtful = (!(certain | compensated.certain)).bits() & valid;
            add(Counter::Compensated, u64::from(((!certain).bits() & valid & !doubtful).count_ones()));
            if doubtful != 0 {
                lambda = precise_spheres(record, ray, lambda, doubtful);
            }
        }
        self.update(id, lambda, lambda.less(V::of(f64::INFINITY)), V::of(0.0), valid);
    }

    /// Takes the hits with a cylinder into account, given its view and the file's axis.
    #[inline(always)]
    pub fn intersect_cylinder(
        &mut self,
        id: ObjectId,
        (record, axis): (&CylinderRecord, &Vec3),
        view: &CylinderView<V>,
        rays: &Rays<V>,
    ) {
        let &Rays { ray, noise, valid, .. } = rays;
        let lanes_record = record.lanes::<V>();
        let quadratic = lanes_record.quadratic(view, ray.direction);
        let certainly_missed = quadratic.2.less(-(noise * view.squares));
        if (!certainly_missed).bits() & valid == 0 {
            return;
        }
        self.filtered_cylinder(id, (record, axis), view, rays);
    }

    /// The same for a cylinder that the valid lanes, which start within the scene's reach, may meet.
    #[inline(always)]
    pub fn intersect_candidate_cylinder(
        &mut self,
        id: ObjectId,
        (record, axis): (&CylinderRecord, &Vec3),
        rays: &Rays<V>,
    ) {
        let view = record.lanes().seen_from(rays.ray.origin);
        self.filtered_cylinder(id, (record, axis), &view, rays);
    }

    #[inline(always)]
    fn filtered_cylinder(
        &mut self,
        id: ObjectId,
        (record, axis): (&CylinderRecord, &Vec3),
        view: &CylinderView<V>,
        rays: &Rays<V>,
    ) {
        let &Rays { ray, a, valid, .. } = rays;
        let lanes_record = record.lanes::<V>();
        let side = exact::cylinder::SideLanes::new(&lanes_record, view, ray);
        // Most rays do not come near the bases.
        let needs_bases = side.open.bits() & valid != 0;
        let lanes = if needs_bases { side.with_bases(&lanes_record, ray) } else { side.without_bases() };
        let number = |part: CylinderPart| V::of(f64::from(part as u32));
        let over = V::select(lanes.top, number(CylinderPart::Top), number(CylinderPart::Side));
        let mut part = V::select(lanes.bottom, number(CylinderPart::Bottom), over);
        let mut lambda = lanes.lambda;
        let doubtful = (!(lanes.certain & in_scale(a))).bits() & valid;
        if doubtful != 0 {
            (lambda, part) = precise_cylinders((record, axis), ray, (lambda, part), doubtful);
        }
        self.update(id, lambda, lambda.less(V::of(f64::INFINITY)), part, valid);
    }
}
