//! The samples of a batch that wait for a random vector, side by side and in order: what their ways on begin with.
//!
//! The stages before the walk put them here as lanes, the selected ones of each group packed together. Samples in glass
//! have their places among them and are taken out where they leave the scene.

use crate::geometry::ray::Ray;
use crate::materials::prepared::ScatterParams;
use crate::math::vec3::Vec3;
use crate::render::arrays::{CAPACITY, SLACK, Values, Vectors};
use crate::render::lane_by_lane::LaneByLane;
use crate::render::path_vertex::{NUMBERS, PathVertex};
use crate::render::sample_set::SampleSet;
use crate::simd::{SimdF64, valid_lanes};

/// Waiting samples in order. What lies behind the last is of no meaning.
#[derive(Debug)]
pub struct PathQueue {
    /// Their number.
    pub count: usize,
    /// Where each stands; for this and what follows see [`PathVertex`].
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

impl PathQueue {
    /// An empty queue.
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

    /// The arrays of [`PathVertex::numbers`].
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

    /// Empties the queue.
    pub const fn clear(&mut self) {
        self.count = 0;
        self.fewest_rays = u64::MAX;
    }

    /// Adds the samples that `bits` selects, each of which may send `rays` rays.
    #[inline(always)]
    pub fn push<V: SimdF64>(&mut self, vertex: &PathVertex<V>, bits: u32, rays: u64) {
        let at = self.count;
        // Neighbours mostly meet something all together.
        if bits == valid_lanes::<V>(V::LANES) {
            for (array, lanes) in self.arrays().into_iter().zip(vertex.numbers()) {
                lanes.store(&mut array[at..]);
            }
        } else {
            for (array, lanes) in self.arrays().into_iter().zip(vertex.numbers()) {
                lanes.compress(bits).store(&mut array[at..]);
            }
        }
        self.rays[at..at + V::LANES].fill(rays);
        self.fewest_rays = self.fewest_rays.min(rays);
        self.count += bits.count_ones() as usize;
    }

    /// Replaces the sample at `at`.
    #[inline(always)]
    pub fn set(&mut self, at: usize, vertex: &PathVertex, rays: u64) {
        for (array, number) in self.arrays().into_iter().zip(vertex.numbers()) {
            array[at] = number;
        }
        self.rays[at] = rays;
        self.fewest_rays = self.fewest_rays.min(rays);
    }

    /// Replaces the sample at `at` by one of several.
    #[inline(always)]
    pub fn set_from(&mut self, at: usize, numbers: &LaneByLane<NUMBERS>, lane: usize, rays: u64) {
        for (array, number) in self.arrays().into_iter().zip(numbers.of(lane)) {
            array[at] = number;
        }
        self.rays[at] = rays;
        self.fewest_rays = self.fewest_rays.min(rays);
    }

    /// Moves the sample at `at`, whose hit was refractive, to its next hit.
    #[inline(always)]
    pub fn pass_on(&mut self, at: usize, numbers: &LaneByLane<NUMBERS>, lane: usize) {
        let [x, y, z, dx, dy, dz, ..] = numbers.of(lane);
        self.point.set(at, Vec3::new(x, y, z));
        self.base.set(at, Vec3::new(dx, dy, dz));
    }

    /// Takes out the samples at the places in `gone`.
    #[inline(always)]
    pub fn take_out<V: SimdF64>(&mut self, gone: &SampleSet) {
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
    pub fn spread<V: SimdF64>(&self, at: usize) -> ScatterParams<V> {
        let Self { scale, shift, negligible, .. } = self;
        ScatterParams {
            scale: V::load(&scale[at..]),
            shift: V::load(&shift[at..]),
            negligible: V::load(&negligible[at..]),
        }
    }

    /// The first ray of the sample at `at`, with the stream's next triple.
    #[inline(always)]
    pub fn ray(&self, at: usize, triple: Vec3) -> Ray {
        let spread = ScatterParams { scale: self.scale[at], shift: self.shift[at], negligible: self.negligible[at] };
        Ray { origin: self.point.get(at), direction: spread.around(self.base.get(at), triple) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::material::Material;
    use crate::materials::prepared::PreparedMaterial;
    use crate::math::real::Real;
    use crate::sampling::scatter_vectors::Scatter;
    use crate::simd::instruction_set::InstructionSet;
    use crate::simd::{Kernel, Simd};

    /// A sample that can be told from others, in lanes numbered from 0 or alone.
    fn numbered<T: Real>(number: T) -> PathVertex<T> {
        let material_data =
            PreparedMaterial::new(&Material::Matte { reflectance: Vec3::new(0.1, 0.2, 0.3) }, Scatter::Statement);
        let tenth = number * T::of(0.1);
        PathVertex::new(Vec3::new(number, tenth, -number), Vec3::new(tenth, number, tenth), number, &material_data)
    }

    /// Puts every third of a number of samples into a queue, replaces two of them and takes out every other.
    struct Fill;

    impl Kernel for Fill {
        type Output = PathQueue;

        #[inline(always)]
        fn call<S: Simd>(self, _: S) -> Self::Output {
            let mut queue = PathQueue::new();
            let each: [f64; 16] = std::array::from_fn(|lane| lane as f64);
            for at in (0..240).step_by(S::F64::LANES) {
                let numbers = S::F64::of(at as f64) + S::F64::load(&each);
                let bits = (0..S::F64::LANES).map(|lane| u32::from((at + lane) % 3 == 0) << lane).sum();
                queue.push(&numbered(numbers), bits, 9);
            }
            queue.set(10, &numbered(1000.0), 5);
            let others = LaneByLane::new(numbered(S::F64::load(&each) + S::F64::of(2000.0)).numbers());
            queue.set_from(12, &others, 1, 7);
            let mut gone = SampleSet::EMPTY;
            (1..queue.count).step_by(2).for_each(|place| gone.add(place, 1));
            queue.take_out::<S::F64>(&gone);
            queue
        }
    }

    #[test]
    fn selected_lanes_stand_side_by_side_and_what_is_taken_out_leaves_no_gap() {
        for set in InstructionSet::ALL.into_iter().filter(|set| set.is_available()) {
            let mut queue = set.run(Fill);
            assert_eq!((queue.count, queue.fewest_rays), (40, 5), "{}", set.name());
            for place in 0..queue.count {
                let (number, rays) = match place {
                    5 => (1000.0, 5),
                    6 => (2001.0, 7),
                    _ => (6.0 * place as f64, 9),
                };
                let found = queue.arrays().map(|array| array[place]);
                assert_eq!(found, numbered(number).numbers(), "{}, {place}", set.name());
                assert_eq!(queue.rays[place], rays);
            }
            let triple = Vec3::new(0.5, 0.25, 0.75);
            let ray = Ray { origin: numbered(6.0).point, direction: numbered(6.0).base + triple * 2.0 - Vec3::ONE };
            assert_eq!(queue.ray(1, triple), ray);
            queue.clear();
            assert_eq!((queue.count, queue.fewest_rays), (0, u64::MAX));
        }
    }
}
