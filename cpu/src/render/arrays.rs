//! Arrays with a place for each sample of a span.

use crate::math::vec3::Vec3;
use crate::simd::SimdF64;

/// Most samples of a batch.
pub const CAPACITY: usize = 1024;

/// Room beyond the last sample for lanes that no sample fills.
pub const SLACK: usize = 16;

/// Room for a value of each sample.
pub type Values = [f64; CAPACITY + SLACK];

/// All null.
pub const ZEROS: Values = [0.0; CAPACITY + SLACK];

/// The number of each sample as bits, which lanes only move.
pub const SAMPLES: Values = {
    let mut samples = ZEROS;
    let mut at = 0;
    while at < samples.len() {
        samples[at] = f64::from_bits(at as u64);
        at += 1;
    }
    samples
};

/// Three arrays: points, directions or colours.
#[derive(Clone, Debug)]
pub struct Vectors {
    /// First components.
    pub x: Values,
    /// Second components.
    pub y: Values,
    /// Third components.
    pub z: Values,
}

impl Vectors {
    /// All null.
    pub const ZERO: Self = Self { x: ZEROS, y: ZEROS, z: ZEROS };

    /// The vector of a sample.
    #[inline(always)]
    pub fn get(&self, sample: usize) -> Vec3 {
        Vec3::new(self.x[sample], self.y[sample], self.z[sample])
    }

    /// Replaces the vector of a sample.
    #[inline(always)]
    pub fn set(&mut self, sample: usize, vector: Vec3) {
        self.x[sample] = vector.x;
        self.y[sample] = vector.y;
        self.z[sample] = vector.z;
    }

    /// The lanes of the samples from `at` on.
    #[inline(always)]
    pub fn load<V: SimdF64>(&self, at: usize) -> Vec3<V> {
        Vec3::new(V::load(&self.x[at..]), V::load(&self.y[at..]), V::load(&self.z[at..]))
    }

    /// Replaces the samples from `at` on, as many as there are lanes.
    #[inline(always)]
    pub fn store<V: SimdF64>(&mut self, at: usize, vectors: Vec3<V>) {
        vectors.x.store(&mut self.x[at..]);
        vectors.y.store(&mut self.y[at..]);
        vectors.z.store(&mut self.z[at..]);
    }
}
