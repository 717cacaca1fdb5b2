//! The samples of a batch that wait for a random vector, side by side and in order: what their ways on begin with.
//!
//! The stages before the walk put them here as lanes, the selected ones of each group packed together. Samples in glass
//! have their places among them and are taken out where they leave the scene.

use super::batch::{CAPACITY, SLACK, Values, Vectors};
use super::hits::MOST_LANES;
use super::primary::valid_lanes;
use super::sample_set::SampleSet;
use super::shade::select;
use crate::layout::Objects;
use crate::prepare::{Finish, Spread};
use crate::ray::Ray;
use crate::real::Real;
use crate::scene::MaterialId;
use crate::search::ObjectId;
use crate::simd::Lanes;
use crate::vec3::Vec3;

/// Numbers that the queue keeps of a sample, besides its rays.
const NUMBERS: usize = 13;

/// A sample on a surface, or a lane of them.
#[derive(Clone, Copy, Debug)]
pub struct Standing<T = f64> {
    /// Where.
    pub point: Vec3<T>,
    /// What is known of the way on before a random vector is added: a matte surface's normal, a metal one's mirror
    /// direction; the whole direction at a refractive one.
    pub base: Vec3<T>,
    /// How its way on is scattered around `base`.
    pub spread: Spread<T>,
    /// What the colour of the way on is multiplied by.
    pub reflectance: Vec3<T>,
    /// The [object](crate::search::ObjectId) that it stands on, a whole number.
    pub object: T,
}

impl<T: Real> Standing<T> {
    /// On a surface with this finish.
    #[inline(always)]
    pub fn new(point: Vec3<T>, base: Vec3<T>, object: T, finish: &Finish) -> Self {
        Self { point, base, spread: finish.spread.lanes(), reflectance: finish.reflectance.map(T::of), object }
    }

    /// These where `mask` holds, `others` elsewhere: but for point and object, which are the same in both.
    #[inline(always)]
    pub fn where_else(&self, mask: T::Mask, others: &Self) -> Self {
        let (these, those) = (&self.spread, &others.spread);
        let spread = Spread {
            scale: T::select(mask, these.scale, those.scale),
            shift: T::select(mask, these.shift, those.shift),
            negligible: T::select(mask, these.negligible, those.negligible),
        };
        let reflectance = select(mask, self.reflectance, others.reflectance);
        Self { base: select(mask, self.base, others.base), spread, reflectance, ..*self }
    }

    /// The numbers, in the order of [`Queue::arrays`].
    #[inline(always)]
    fn numbers(&self) -> [T; NUMBERS] {
        let Self { point: p, base: b, spread: s, reflectance: r, object } = *self;
        [p.x, p.y, p.z, b.x, b.y, b.z, s.scale, s.shift, s.negligible, r.x, r.y, r.z, object]
    }
}

/// The numbers of samples in lanes, lane by lane.
pub struct LaneByLane([[f64; MOST_LANES]; NUMBERS]);

impl<V: Lanes> Standing<V> {
    /// The numbers lane by lane.
    #[inline(always)]
    pub fn lane_by_lane(&self) -> LaneByLane {
        let mut apart = [[0.0; MOST_LANES]; NUMBERS];
        for (place, lanes) in apart.iter_mut().zip(self.numbers()) {
            lanes.store(place);
        }
        LaneByLane(apart)
    }
}

/// Waiting samples in order. What lies behind the last is of no meaning.
#[derive(Debug)]
pub struct Queue {
    /// Their number.
    pub count: usize,
    /// Where each stands; for this and what follows see [`Standing`].
    pub point: Vectors,
    pub base: Vectors,
    scale: Values,
    shift: Values,
    negligible: Values,
    pub reflectance: Vectors,
    pub object: Values,
    /// Rays that each may still send.
    pub rays: [u64; CAPACITY + SLACK],
    /// None may send fewer.
    pub fewest_rays: u64,
}

impl Queue {
    /// Nobody waits.
    pub fn new() -> Self {
        Self {
            count: 0,
            point: Vectors::ZERO,
            base: Vectors::ZERO,
            scale: [0.0; CAPACITY + SLACK],
            shift: [0.0; CAPACITY + SLACK],
            negligible: [0.0; CAPACITY + SLACK],
            reflectance: Vectors::ZERO,
            object: [0.0; CAPACITY + SLACK],
            rays: [0; CAPACITY + SLACK],
            fewest_rays: u64::MAX,
        }
    }

    #[inline(always)]
    const fn arrays(&mut self) -> [&mut Values; NUMBERS] {
        let Self { point: p, base: b, reflectance: r, .. } = self;
        [
            &mut p.x,
            &mut p.y,
            &mut p.z,
            &mut b.x,
            &mut b.y,
            &mut b.z,
            &mut self.scale,
            &mut self.shift,
            &mut self.negligible,
            &mut r.x,
            &mut r.y,
            &mut r.z,
            &mut self.object,
        ]
    }

    /// Nobody waits any more.
    pub const fn clear(&mut self) {
        self.count = 0;
        self.fewest_rays = u64::MAX;
    }

    /// Adds the samples that `bits` selects, each of which may send `rays` rays.
    #[inline(always)]
    pub fn push<V: Lanes>(&mut self, standing: &Standing<V>, bits: u32, rays: u64) {
        let at = self.count;
        for (array, lanes) in self.arrays().into_iter().zip(standing.numbers()) {
            lanes.compress(bits).store(&mut array[at..]);
        }
        self.rays[at..at + V::LANES].fill(rays);
        self.fewest_rays = self.fewest_rays.min(rays);
        self.count += bits.count_ones() as usize;
    }

    /// Replaces the sample at `at`.
    #[inline(always)]
    pub fn set(&mut self, at: usize, standing: &Standing, rays: u64) {
        for (array, number) in self.arrays().into_iter().zip(standing.numbers()) {
            array[at] = number;
        }
        self.rays[at] = rays;
        self.fewest_rays = self.fewest_rays.min(rays);
    }

    /// Replaces the sample at `at` by one of several.
    #[inline(always)]
    pub fn set_from(&mut self, at: usize, LaneByLane(numbers): &LaneByLane, lane: usize, rays: u64) {
        for (array, number) in self.arrays().into_iter().zip(numbers) {
            array[at] = number[lane];
        }
        self.rays[at] = rays;
        self.fewest_rays = self.fewest_rays.min(rays);
    }

    /// Takes out the samples at the places in `gone`.
    #[inline(always)]
    pub fn take_out<V: Lanes>(&mut self, gone: &SampleSet) {
        let (mut to, count) = (0, self.count);
        for from in (0..count).step_by(V::LANES) {
            let bits = !gone.bits(from, V::LANES) & valid_lanes::<V>(count - from);
            for array in self.arrays() {
                // What is overwritten has been read: `to` is not beyond `from`.
                V::load(&array[from..]).compress(bits).store(&mut array[to..]);
            }
            for lane in 0..V::LANES {
                self.rays[to] = self.rays[from + lane];
                to += (bits >> lane & 1) as usize;
            }
        }
        self.count = to;
    }

    /// How the ways on of the samples from `at` on are scattered.
    #[inline(always)]
    pub fn spread<V: Lanes>(&self, at: usize) -> Spread<V> {
        let Self { scale, shift, negligible, .. } = self;
        Spread { scale: V::load(&scale[at..]), shift: V::load(&shift[at..]), negligible: V::load(&negligible[at..]) }
    }

    /// The first ray of the sample at `at`, with the stream's next triple.
    #[inline(always)]
    pub fn ray(&self, at: usize, triple: Vec3) -> Ray {
        let spread = Spread { scale: self.scale[at], shift: self.shift[at], negligible: self.negligible[at] };
        Ray { origin: self.point.get(at), direction: spread.around(self.base.get(at), triple) }
    }
}

/// The material of the object at `object`.
#[inline(always)]
pub fn material_of<O: Objects>(objects: &O, object: ObjectId) -> MaterialId {
    match (object as usize).checked_sub(objects.sphere_count()) {
        None => objects.sphere(object as usize).material,
        Some(index) => objects.cylinder(index).material,
    }
}
