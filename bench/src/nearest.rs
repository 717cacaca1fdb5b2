//! Compares the time of a nearest hit with Embree's: one ray after the other, each at another place of a scene of
//! spheres. The program `nearest` prints the table.
//!
//! [`scene`] makes spheres and rays from a fixed seed, [`ours`] is this project's side, [`embree`] is Embree's, and
//! [`agreement`] compares their hits. [`measure`](mod@measure) takes the times, and [`table`] writes them.

pub mod agreement;
pub mod embree;
pub mod measure;
pub mod ours;
pub mod scene;
pub mod table;

use cpu::Ray;

/// The place that stands for no object: the start object of a free ray, or the object of a ray without a hit.
pub const NO_PLACE: u32 = u32::MAX;

/// A ray, and the place of the object on which it starts.
#[derive(Clone, Copy, Debug)]
pub struct Start {
    /// The ray.
    pub ray: Ray,
    /// The place of the object on which the ray starts, or [`NO_PLACE`].
    pub from: u32,
}

/// The nearest hit of a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NearestHit {
    /// The object that is hit, by its place in the scene file, where the first object has the place 0. Without a hit
    /// this is [`NO_PLACE`].
    pub place: u32,
    /// The lambda of the hit, in lengths of the ray's direction. It is infinite without a hit.
    pub lambda: f64,
}

impl NearestHit {
    /// The value of a ray without a hit.
    pub const NOTHING: Self = Self { place: NO_PLACE, lambda: f64::INFINITY };
}
