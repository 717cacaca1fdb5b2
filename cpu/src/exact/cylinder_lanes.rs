//! Several rays or cylinders at once, without a branch; see [`crate::exact::cylinder`] for one.

use crate::exact::{cap::Plane, cylinder_side::Crossing, cylinder_side::Side};
use crate::geometry::{cylinder::CylinderRecord, cylinder::CylinderView, ray::Ray};
use crate::math::{real::Real, rounding::Rounding, vec3::Vec3};

/// The hits of several rays or cylinders at once.
#[derive(Clone, Copy, Debug)]
pub struct CylinderHits<T: Real> {
    /// The result of the plain formula; infinite where it finds no hit. Undefined in a lane that is not certain.
    pub lambda: T,
    /// Lanes whose hit, if there is one, is on the top cap.
    pub top: T::Mask,
    /// Lanes whose hit, if there is one, is on the bottom cap.
    pub bottom: T::Mask,
    /// Lanes whose result is right. The others need [`precise`](crate::exact::cylinder::precise).
    pub certain: T::Mask,
}

/// The decisions that need only the side.
pub struct SideLanes<T: Real> {
    entry: Crossing<T>,
    exit: Crossing<T>,
    /// Lanes that certainly miss the cylinder.
    nothing: T::Mask,
    /// Lanes that certainly hit the side from inside.
    through: T::Mask,
    /// Lanes whose result needs the caps.
    pub open: T::Mask,
}

impl<T: Rounding> SideLanes<T> {
    /// Intersects the side, and leaves the other lanes [open](Self::open).
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

    /// The hits if no lane is [open](Self::open).
    #[inline(always)]
    pub fn without_caps(&self) -> CylinderHits<T> {
        let none = T::of(1.0).less(T::of(0.0));
        let lambda = T::select(self.through, self.exit.lambda, self.entry.lambda);
        CylinderHits {
            lambda: T::select(self.nothing, T::of(f64::INFINITY), lambda),
            top: none,
            bottom: none,
            certain: self.nothing | self.entry.hits | self.through,
        }
    }

    /// The hits with the caps.
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
