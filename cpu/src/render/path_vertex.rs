//! A path vertex: the last hit of a sample on a surface, with all numbers from which its path continues.

use std::ops::Range;

use crate::materials::{prepared::PreparedMaterial, scatter::ScatterParams};
use crate::math::{real::Real, vec3::Vec3};
use crate::render::{lane_numbers::ObjectNumber, lane_numbers::SampleIndex, max_depth::RaysLane};

/// The last hit of a sample, with all numbers from which its path continues. These are the hit point, the scattered
/// direction before the random vector is added, the [`ScatterParams`] of that vector, the reflectance of the surface,
/// the index of the object and of the sample, and the number of rays that the path may still send. With lanes, each
/// lane has its own sample.
#[derive(Clone, Copy, Debug)]
pub struct PathVertex<T = f64> {
    /// The hit point, in scene units. The next ray starts there.
    pub point: Vec3<T>,
    /// The scattered direction before the random vector is added; see [`PreparedMaterial::unperturbed_direction`].
    pub unperturbed: Vec3<T>,
    /// The constants with which the next ray is scattered around `unperturbed`.
    pub scatter_params: ScatterParams<T>,
    /// The factor that the surface applies to the colour of the next ray.
    pub reflectance: Vec3<T>,
    /// The object that is hit.
    pub object: ObjectNumber<T>,
    /// The index of the sample in its span.
    pub sample: SampleIndex<T>,
    /// The number of rays that the path may still send.
    pub rays: RaysLane<T>,
}

impl PathVertex {
    /// Number of numbers in a vertex.
    pub const NUMBERS: usize = 15;
    /// The indices of the direction, the scatter parameters and the reflectance in [`PathVertex::numbers`].
    const SELECTED: Range<usize> = 3..12;
    /// The indices of `reflectance` in [`PathVertex::numbers`].
    pub const REFLECTANCE: Range<usize> = 9..12;
    /// The index of `sample` in [`PathVertex::numbers`].
    pub const SAMPLE: usize = 13;
    /// The index of `rays` in [`PathVertex::numbers`].
    pub const RAYS: usize = 14;
}

impl<T: Real> PathVertex<T> {
    /// Returns a vertex on a surface of this prepared material. `sample` and `rays` are 0, and the caller replaces
    /// them.
    #[inline(always)]
    pub(crate) fn new(
        point: Vec3<T>,
        unperturbed: Vec3<T>,
        object: ObjectNumber<T>,
        material: &PreparedMaterial,
    ) -> Self {
        let (scatter_params, reflectance) = (material.scatter_params.lanes(), material.reflectance.map(T::of));
        let (sample, rays) = (SampleIndex(T::of(0.0)), RaysLane(T::of(0.0)));
        Self { point, unperturbed, scatter_params, reflectance, object, sample, rays }
    }

    /// Returns a vertex whose direction, scatter parameters and reflectance come from this vertex where `mask` holds,
    /// and from `other` elsewhere. The point, the object, the sample and the number of rays always come from this
    /// vertex.
    #[inline(always)]
    pub(crate) fn where_else(&self, mask: T::Mask, other: &Self) -> Self {
        let (mut numbers, others) = (self.numbers(), other.numbers());
        for index in PathVertex::SELECTED {
            numbers[index] = T::select(mask, numbers[index], others[index]);
        }
        Self::of(numbers)
    }

    /// Returns the numbers of the vertex, in the order of the [path queue](crate::render::queue::PathQueue).
    #[inline(always)]
    pub(crate) fn numbers(&self) -> [T; PathVertex::NUMBERS] {
        let Self { point: p, unperturbed: u, scatter_params: s, reflectance: r, object, sample, rays } = *self;
        [p.x, p.y, p.z, u.x, u.y, u.z, s.scale, s.shift, s.negligible, r.x, r.y, r.z, object.0, sample.0, rays.0]
    }

    /// Returns the numbers of a vertex on a refractive surface, in the order of the
    /// [specular queue](crate::render::queue::SpecularQueue): point, direction, object and sample.
    #[inline(always)]
    pub(crate) fn specular_numbers(&self) -> [T; 8] {
        let Self { point: p, unperturbed: u, object, sample, .. } = *self;
        [p.x, p.y, p.z, u.x, u.y, u.z, object.0, sample.0]
    }

    /// Returns the vertex with these [numbers](PathVertex::numbers).
    #[inline(always)]
    pub(crate) fn of(numbers: [T; PathVertex::NUMBERS]) -> Self {
        let [px, py, pz, ux, uy, uz, scale, shift, negligible, rx, ry, rz, object, sample, rays] = numbers;
        Self {
            point: Vec3::new(px, py, pz),
            unperturbed: Vec3::new(ux, uy, uz),
            scatter_params: ScatterParams { scale, shift, negligible },
            reflectance: Vec3::new(rx, ry, rz),
            object: ObjectNumber(object),
            sample: SampleIndex(sample),
            rays: RaysLane(rays),
        }
    }
}
