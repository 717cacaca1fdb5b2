//! The closest hit found so far, for one ray. `render/hit_lanes.rs` has the closest hits of several rays at once.
//!
//! Which of two hits is closer? Read three files, in this order, each from top to bottom:
//!
//! 1. `accel/closest_hit.rs`, the first half of this file: [`ClosestHit::update`] decides by the computed lambdas. If
//!    they are near to each other, [`is_exactly_closer`] decides by the exact ones.
//! 2. `exact/order.rs`: compares near lambdas, in four steps.
//! 3. `geometry/tie.rs`: the rule for equal lambdas.
//!
//! The second half of this file intersects objects.

use std::cmp::Ordering;

use crate::accel::object::{NO_OBJECT, ObjectId, ObjectRef, file_index_of};
use crate::counters::{Counter, add};
use crate::exact::order::{self, Surface, is_certainly_closer};
use crate::exact::{self, error_bound::Decision};
use crate::geometry::{cylinder::CylinderPart, ray::Ray, tie};
use crate::layout::Objects;

/// The closest hit among the objects intersected so far.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClosestHit {
    /// The lambda of the hit. It is infinite if there is no hit.
    pub lambda: f64,
    /// The object that is hit, or [`NO_OBJECT`] if there is no hit.
    pub object: ObjectId,
    /// The part of a cylinder that is hit. It is the side for a sphere.
    pub part: CylinderPart,
}

impl ClosestHit {
    /// The value before any hit. Every hit replaces it, even one whose lambda is infinite.
    pub const NOTHING: Self = Self { lambda: f64::INFINITY, object: NO_OBJECT, part: CylinderPart::Side };

    /// Whether any object is hit.
    #[inline(always)]
    pub const fn is_hit(&self) -> bool {
        self.object != NO_OBJECT
    }

    /// Replaces the hit by `other`, which must be a hit of the same ray, if that one is closer.
    #[inline(always)]
    pub(crate) fn update<O: Objects>(&mut self, objects: &O, ray: &Ray, other: Self) {
        debug_assert!(other.is_hit());
        if is_certainly_closer(other.lambda, self.lambda)
            || !is_certainly_closer(self.lambda, other.lambda) && is_exactly_closer(objects, *ray, other, *self)
        {
            *self = other;
        }
    }

    /// Returns the surface that is hit, as the exact comparison of two hits needs it.
    fn surface<O: Objects>(&self, objects: &O) -> Surface {
        match ObjectRef::of(objects, self.object) {
            ObjectRef::Sphere(index) => Surface::Sphere(objects.sphere(index).record),
            ObjectRef::Cylinder(index) => {
                Surface::Cylinder(objects.cylinder(index).record, objects.file_axis(index), self.part)
            }
        }
    }
}

/// Whether a hit of a ray is closer than another one, by their exact lambdas and the [rule for
/// ties](crate::geometry::tie). The other one may be [`ClosestHit::NOTHING`]. This is called if [`is_certainly_closer`]
/// is false in both orders. The parameters are values and no references, so that most rays keep them in registers.
#[cold]
#[inline(never)]
pub(crate) fn is_exactly_closer<O: Objects>(objects: &O, ray: Ray, hit: ClosestHit, closest: ClosestHit) -> bool {
    if !closest.is_hit() {
        return true;
    }
    let rank = |hit: &ClosestHit| tie::rank(file_index_of(objects, hit.object), hit.part != CylinderPart::Side);
    // If a number is not finite, there are no exact lambdas, and the computed ones are compared.
    let surfaces = [&hit.surface(objects), &closest.surface(objects)];
    let compared = order::compare(&ray, surfaces, [hit.lambda, closest.lambda]);
    match compared.or(hit.lambda.partial_cmp(&closest.lambda)) {
        Some(Ordering::Equal) => rank(&hit) >= rank(&closest),
        compared => compared == Some(Ordering::Less),
    }
}

impl ClosestHit {
    /// Intersects the object with the number `id`, and updates the closest hit.
    #[inline(always)]
    pub(crate) fn intersect<O: Objects>(&mut self, objects: &O, id: ObjectId, ray: &Ray) {
        match ObjectRef::of(objects, id) {
            ObjectRef::Sphere(index) => self.intersect_sphere(objects, index, ray),
            ObjectRef::Cylinder(index) => self.intersect_cylinder(objects, index, ray),
        }
    }

    /// Intersects the sphere at `index` among the spheres, and updates the closest hit.
    #[inline(always)]
    pub(crate) fn intersect_sphere<O: Objects>(&mut self, objects: &O, index: usize, ray: &Ray) {
        add(Counter::SphereTests, 1);
        let lambda = match exact::sphere::filtered_or_lower_bound(&objects.sphere(index).record, ray) {
            Ok(lambda) => lambda,
            Err(lower_bound) if is_certainly_closer(self.lambda, lower_bound) => None,
            Err(_) => resolve_sphere(objects, index, *ray),
        };
        self.update_by_lambda(objects, index, ray, lambda);
    }

    /// Intersects the sphere at `index` among the spheres, and updates the closest hit. The compensated formula is
    /// inlined into this function. This serves spheres about which the filter is often uncertain, such as the dominant
    /// sphere for rays that start near it.
    #[inline(always)]
    pub(crate) fn intersect_uncertain_sphere<O: Objects>(&mut self, objects: &O, index: usize, ray: &Ray) {
        add(Counter::SphereTests, 1);
        let lambda = match exact::sphere::filtered_or_compensated(&objects.sphere(index).record, ray) {
            Decision::Certain(lambda) => lambda,
            Decision::Uncertain => resolve_sphere(objects, index, *ray),
        };
        self.update_by_lambda(objects, index, ray, lambda);
    }

    /// Takes the hit of the sphere `index` at `lambda`, if there is one and it is closer.
    #[inline(always)]
    fn update_by_lambda<O: Objects>(&mut self, objects: &O, index: usize, ray: &Ray, lambda: Option<f64>) {
        if let Some(lambda) = lambda {
            let object = ObjectRef::Sphere(index).number(objects.sphere_count());
            self.update(objects, ray, Self { lambda, object, part: CylinderPart::Side });
        }
    }

    /// Intersects the spheres whose bits are set in `spheres`, and updates the closest hit.
    #[inline(always)]
    pub(crate) fn intersect_spheres<O: Objects>(&mut self, objects: &O, mut spheres: u64, ray: &Ray) {
        while spheres != 0 {
            let index = spheres.trailing_zeros() as usize;
            match exact::sphere::filtered(&objects.sphere(index).record, ray) {
                Decision::Certain(lambda) => self.update_by_lambda(objects, index, ray, lambda),
                Decision::Uncertain => return *self = with_uncertain_spheres(objects, spheres, *ray, *self),
            }
            add(Counter::SphereTests, 1);
            spheres &= spheres - 1;
        }
    }

    /// Intersects the cylinder at `index` among the cylinders, and updates the closest hit.
    #[inline(always)]
    pub(crate) fn intersect_cylinder<O: Objects>(&mut self, objects: &O, index: usize, ray: &Ray) {
        add(Counter::CylinderTests, 1);
        let hit = match exact::cylinder::filtered(&objects.cylinder(index).record, ray) {
            Decision::Certain(hit) => hit,
            Decision::Uncertain => resolve_cylinder(objects, index, *ray),
        };
        if let Some((lambda, part)) = hit {
            let object = ObjectRef::Cylinder(index).number(objects.sphere_count());
            self.update(objects, ray, Self { lambda, object, part });
        }
    }
}

/// Returns the lambda by the compensated or precise formulas, or `None` for a miss. The function reads the object
/// again, and `ray` is no reference. So rays that do not need this function keep both in registers.
#[cold]
#[inline(never)]
fn resolve_sphere<O: Objects>(objects: &O, index: usize, ray: Ray) -> Option<f64> {
    exact::sphere::compensated_or_precise(&objects.sphere(index).record, &ray)
}

/// Does what [`ClosestHit::intersect_spheres`] does, and returns the closest hit. The plain formula may be uncertain
/// about these spheres, as it is about most of the thin shells between which a ray starts. Such spheres are put off,
/// and the one with the smallest lower bound of lambda is intersected first. It mostly hides the others.
#[cold]
#[inline(never)]
fn with_uncertain_spheres<O: Objects>(objects: &O, spheres: u64, ray: Ray, mut closest: ClosestHit) -> ClosestHit {
    let (mut left, mut put_off, mut first) = (spheres, 0_u64, 0);
    // The lower bound of the first sphere's lambda, and that of all other spheres.
    let [mut lower_bound, mut second] = [f64::INFINITY; 2];
    while left != 0 {
        let index = left.trailing_zeros() as usize;
        add(Counter::SphereTests, 1);
        match exact::sphere::filtered_or_lower_bound(&objects.sphere(index).record, &ray) {
            Ok(lambda) => closest.update_by_lambda(objects, index, &ray, lambda),
            Err(bound) => {
                put_off |= 1 << index;
                second = second.min(lower_bound.max(bound));
                if bound < lower_bound {
                    (lower_bound, first) = (bound, index);
                }
            }
        }
        left &= left - 1;
    }
    while put_off != 0 && !is_certainly_closer(closest.lambda, lower_bound) {
        closest.update_by_lambda(objects, first, &ray, resolve_sphere(objects, first, ray));
        put_off &= !(1 << first);
        (first, lower_bound) = (put_off.trailing_zeros() as usize, second);
    }
    closest
}

/// Returns lambda and part by the steps after the filter, or `None` for a miss. See [`resolve_sphere`] for the
/// parameters.
#[cold]
#[inline(never)]
fn resolve_cylinder<O: Objects>(objects: &O, index: usize, ray: Ray) -> Option<(f64, CylinderPart)> {
    exact::cylinder::compensated_or_precise(&objects.cylinder(index).record, &objects.file_axis(index), &ray)
}
