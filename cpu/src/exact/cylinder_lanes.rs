//! Intersects several rays or cylinders at once, without a branch. [`crate::exact::cylinder`] has the form for one ray.

use crate::exact::{cap::Plane, cylinder_side::Crossing, cylinder_side::Side};
use crate::geometry::{cylinder::CylinderRecord, cylinder::CylinderView, ray::Ray};
use crate::math::{real::Real, rounding::Rounding, vec3::Vec3};

/// The hits of several rays or cylinders at once, one in each lane.
#[derive(Clone, Copy, Debug)]
pub struct CylinderHits<T: Real> {
    /// The lambda of the hit, or infinity if the ray misses the cylinder. It has no meaning in a lane that is not
    /// `certain`.
    pub lambda: T,
    /// The lanes whose hit is on the top cap, if there is a hit.
    pub top: T::Mask,
    /// The lanes whose hit is on the bottom cap, if there is a hit.
    pub bottom: T::Mask,
    /// The lanes whose result is certain. The other lanes need [`precise`](crate::exact::cylinder::precise).
    pub certain: T::Mask,
}

/// The hits of several rays or cylinders as far as the side alone decides them. Most rays need no test of the caps.
pub struct SideLanes<T: Real> {
    entry: Crossing<T>,
    exit: Crossing<T>,
    /// The lanes whose ray certainly misses the cylinder.
    nothing: T::Mask,
    /// The lanes whose ray certainly starts between the caps' planes and hits the side from inside.
    through: T::Mask,
    /// The lanes that the side alone does not decide.
    pub open: T::Mask,
}

impl<T: Rounding> SideLanes<T> {
    /// Intersects the rays with the side. `view` has the cylinder's terms for the rays' origin.
    #[inline(always)]
    pub fn new(record: &CylinderRecord<T>, view: &CylinderView<T>, ray: &Ray<T>) -> Self {
        let side = Side::new(record, view, ray.direction);
        let root = side.discriminant.sqrt();
        let entry = side.crossing(record, ray, -side.h - root, root);
        let exit = side.crossing(record, ray, -side.h + root, root);
        let nothing = side.bound.misses(side.discriminant) | (entry.fails() & entry.passes_by(&exit));
        let through = entry.behind & exit.straight & !nothing;
        Self { entry, exit, nothing, through, open: !(nothing | entry.hits | through) }
    }

    /// Returns the hits by the side alone. Lanes that are [open](Self::open) are not `certain`.
    #[inline(always)]
    pub fn without_caps(&self) -> CylinderHits<T> {
        let none = T::empty_mask();
        let lambda = T::select(self.through, self.exit.lambda, self.entry.lambda);
        CylinderHits {
            lambda: T::select(self.nothing, T::of(f64::INFINITY), lambda),
            top: none,
            bottom: none,
            certain: self.nothing | self.entry.hits | self.through,
        }
    }

    /// Intersects the rays with the caps too, and returns the hits.
    #[inline(always)]
    pub fn with_caps(&self, record: &CylinderRecord<T>, ray: &Ray<T>) -> CylinderHits<T> {
        let Self { entry, exit, nothing, through, open } = *self;
        let down = ray.direction.dot(record.axis).less(T::of(0.0));
        let facing = Plane::new(record, ray, Vec3::select(down, record.top, record.bottom)).disc(record, ray);
        let other = Plane::new(record, ray, Vec3::select(down, record.bottom, record.top)).disc(record, ray);
        let by_facing = open & facing.hits;
        let by_exit = through | (open & !facing.hits & exit.hits);
        let by_other = open & !facing.hits & !exit.hits & other.hits;
        let mut lambda = T::select(by_other, other.lambda, T::of(f64::INFINITY));
        lambda = T::select(by_exit, exit.lambda, lambda);
        lambda = T::select(by_facing, facing.lambda, lambda);
        lambda = T::select(entry.hits & !nothing, entry.lambda, lambda);
        let facing_fails = facing.fails & (exit.hits | other.hits | other.fails);
        CylinderHits {
            lambda,
            top: (by_facing & down) | (by_other & !down),
            bottom: (by_facing & !down) | (by_other & down),
            certain: !open | (entry.fails() & (exit.hits | exit.fails()) & (facing.hits | facing_fails)),
        }
    }
}
