//! The hits of several rays with cylinders, found at once and without a branch. `decide` in
//! `exact/cylinder_decision.rs` is the form for one ray, which has branches. Both use the same facts about the side and
//! the caps.

use crate::exact::cylinder_decision::{CapFormulas, Crossing, SideFacts, SideFormulas};
use crate::geometry::{cylinder::CylinderPart, cylinder::CylinderRecord, ray::Ray};
use crate::math::{real::Real, rounding::Rounding, vec3::Vec3};
use crate::simd::SimdF64;

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
    /// The lanes whose result is certain. The other lanes need the next step: the compensated formulas, or after them
    /// dyadic arithmetic.
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
    /// The lanes whose ray certainly starts inside the infinite cylinder.
    inside: T::Mask,
    /// The lanes that the side alone does not decide.
    pub open: T::Mask,
}

impl<V: SimdF64> CylinderHits<V> {
    /// Returns the number of the part of each hit.
    #[inline(always)]
    pub(crate) fn part(&self) -> V {
        let over = V::select(self.top, CylinderPart::Top.number(), CylinderPart::Side.number());
        V::select(self.bottom, CylinderPart::Bottom.number(), over)
    }
}

impl<V: SimdF64> SideLanes<V> {
    /// Returns the hits of all lanes. The caps are tested only if a lane in `bits` is [open](Self::open), because for
    /// most groups of rays the side alone decides. So an open lane that is not in `bits` may stay uncertain.
    #[inline(always)]
    pub(crate) fn with_needed_caps(
        &self,
        record: &CylinderRecord<V>,
        ray: &Ray<V>,
        caps: &impl CapFormulas<V>,
        bits: u32,
    ) -> CylinderHits<V> {
        if V::bits(self.open) & bits != 0 { self.with_caps(record, ray, caps) } else { self.without_caps() }
    }
}

impl<T: Rounding> SideLanes<T> {
    /// Intersects the rays with the side, by its plain or its compensated formulas.
    #[inline(always)]
    pub fn new(side: &impl SideFormulas<T>) -> Self {
        let (entry, exit) = (side.crossing(false), side.crossing(true));
        let SideFacts { misses, inside, .. } = side.facts();
        let nothing = misses | (entry.fails() & entry.passes_by(&exit));
        let through = entry.behind & exit.straight & !nothing;
        Self { entry, exit, nothing, through, inside, open: !(nothing | entry.hits | through) }
    }

    /// The lanes in which it certainly is decided where the ray crosses the side. Caps may still be open.
    #[inline(always)]
    fn is_certain(&self) -> T::Mask {
        !self.open | (self.entry.fails() & (self.exit.hits | self.exit.fails()))
    }

    /// Returns the hits by the side alone. Lanes that are [open](Self::open) are not `certain`.
    #[inline(always)]
    pub(crate) fn without_caps(&self) -> CylinderHits<T> {
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
    pub fn with_caps(&self, record: &CylinderRecord<T>, ray: &Ray<T>, caps: &impl CapFormulas<T>) -> CylinderHits<T> {
        let Self { entry, exit, nothing, through, inside, open } = *self;
        let down = ray.direction.dot(record.axis).less(T::of(0.0));
        let (facing_center, other_center) =
            (Vec3::select(down, record.top, record.bottom), Vec3::select(down, record.bottom, record.top));
        let facing = caps.plane(record, ray, facing_center, down).disc(record, ray);
        let other = caps.plane(record, ray, other_center, !down).disc(record, ray);
        let by_facing = open & facing.hits;
        let by_exit = through | (open & !facing.hits & exit.hits);
        let by_other = open & !facing.hits & !exit.hits & other.hits;
        let mut lambda = T::select(by_other, other.lambda, T::of(f64::INFINITY));
        lambda = T::select(by_exit, exit.lambda, lambda);
        lambda = T::select(by_facing, facing.lambda, lambda);
        lambda = T::select(entry.hits & !nothing, entry.lambda, lambda);
        let side_is_certain = self.is_certain();
        let by_cap = facing.hits | (facing.fails & other.hits);
        let by_side = facing.fails & (exit.hits | other.fails);
        CylinderHits {
            lambda,
            top: (by_facing & down) | (by_other & !down),
            bottom: (by_facing & !down) | (by_other & down),
            certain: !open | (by_cap & (side_is_certain | inside)) | (by_side & side_is_certain),
        }
    }
}
