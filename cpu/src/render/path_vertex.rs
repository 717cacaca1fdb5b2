//! What is known of a sample on a surface: all that its way on begins with.

use crate::materials::prepared::{PreparedMaterial, ScatterParams};
use crate::math::real::Real;
use crate::math::vec3::Vec3;

/// Numbers that the queue keeps of a sample, besides its rays.
pub const NUMBERS: usize = 13;

/// A sample on a surface, or a lane of them.
#[derive(Clone, Copy, Debug)]
pub struct PathVertex<T = f64> {
    /// Where.
    pub point: Vec3<T>,
    /// The scattered direction before the random vector is added: the normal of a matte surface, the mirror direction
    /// of a metal one; the whole direction at a refractive one.
    pub base: Vec3<T>,
    /// How its way on is scattered around `base`.
    pub spread: ScatterParams<T>,
    /// What the colour of the way on is multiplied by.
    pub reflectance: Vec3<T>,
    /// The [object](crate::accel::object::ObjectId) that it stands on, a whole number.
    pub object: T,
}

impl<T: Real> PathVertex<T> {
    /// A vertex on a surface of this prepared material.
    #[inline(always)]
    pub fn new(point: Vec3<T>, base: Vec3<T>, object: T, material_data: &PreparedMaterial) -> Self {
        Self {
            point,
            base,
            spread: material_data.spread.lanes(),
            reflectance: material_data.reflectance.map(T::of),
            object,
        }
    }

    /// These where `mask` holds, `others` elsewhere: but for point and object, which are the same in both.
    #[inline(always)]
    pub fn where_else(&self, mask: T::Mask, others: &Self) -> Self {
        let (these, those) = (&self.spread, &others.spread);
        let spread = ScatterParams {
            scale: T::select(mask, these.scale, those.scale),
            shift: T::select(mask, these.shift, those.shift),
            negligible: T::select(mask, these.negligible, those.negligible),
        };
        let reflectance = Vec3::select(mask, self.reflectance, others.reflectance);
        Self { base: Vec3::select(mask, self.base, others.base), spread, reflectance, ..*self }
    }

    /// The numbers, in the order of the [queue's](crate::render::path_queue::PathQueue) arrays.
    #[inline(always)]
    pub fn numbers(&self) -> [T; NUMBERS] {
        let Self { point: p, base: b, spread: s, reflectance: r, object } = *self;
        [p.x, p.y, p.z, b.x, b.y, b.z, s.scale, s.shift, s.negligible, r.x, r.y, r.z, object]
    }
}
