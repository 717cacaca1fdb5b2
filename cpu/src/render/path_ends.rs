//! Where paths leave the scene: the background, several at once, attenuated by all that the paths have met.

use crate::counters::{Counter, add};
use crate::input::error::Error;
use crate::input::scene::MaterialId;
use crate::layout::Layout;
use crate::math::vec3::Vec3;
use crate::render::arrays::{CAPACITY, Vectors};
use crate::render::lane_by_lane::LaneByLane;
use crate::render::path_vertex::PathVertex;
use crate::render::prepared::Prepared;
use crate::render::queue::PathQueue;
use crate::render::samples::Batch;
use crate::simd::{Kernel, Simd, SimdF64};

/// The ends of the queue's paths, by place in the queue.
#[derive(Debug)]
pub struct PathEnds {
    /// The last direction of each path.
    pub direction: Vectors,
    /// What paths met after the surface that they stand on in the queue, path after path; room behind the last.
    met: Vec<Attenuation>,
    /// How many these are.
    count: usize,
    /// How many they were when the present path began.
    begin: usize,
    /// There was no room for one of them: colours are of no meaning.
    is_incomplete: bool,
}

/// A surface that attenuates, met by a path.
#[derive(Clone, Copy, Debug)]
struct Attenuation {
    path: u32,
    material: MaterialId,
}

impl Attenuation {
    const NOTHING: Self = Self { path: 0, material: 0 };
}

impl PathEnds {
    /// No path yet.
    pub fn new() -> Self {
        let met = vec![Attenuation::NOTHING; 8 * CAPACITY];
        Self { direction: Vectors::ZERO, met, count: 0, begin: 0, is_incomplete: false }
    }

    /// Whether all that paths met could be kept.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`]: a path between mirrors may meet as many surfaces as `max_depth` says.
    pub fn check(&self) -> Result<(), Error> {
        if self.is_incomplete { Err(Error::OutOfMemory { what: "the surfaces that a ray meets" }) } else { Ok(()) }
    }

    /// A path begins; those before it are done.
    #[inline(always)]
    pub const fn begin(&mut self) {
        self.begin = self.count;
    }

    /// Path `at`, the present one, has met a material that attenuates. Says whether it could be kept; see
    /// [`PathEnds::check`].
    #[inline(always)]
    pub fn push_attenuation(&mut self, at: usize, material: MaterialId) -> bool {
        if self.count == self.met.len() && !self.grow() {
            return false;
        }
        self.met[self.count] = Attenuation { path: at as u32, material };
        self.count += 1;
        true
    }

    /// Makes room for as many materials again, and says whether there was any.
    #[cold]
    #[inline(never)]
    fn grow(&mut self) -> bool {
        let more = self.met.len();
        let fits = self.met.try_reserve_exact(more).is_ok();
        if fits {
            self.met.resize(2 * more, Attenuation::NOTHING);
        }
        self.is_incomplete |= !fits;
        fits
    }

    /// Path `at`, the present one, has reached the maximum depth: it contributes black.
    #[inline(always)]
    pub fn terminate(&mut self, at: usize, queue: &mut PathQueue) {
        self.count = self.begin;
        self.direction.set(at, Vec3::ONE);
        for array in &mut queue.arrays[PathVertex::REFLECTANCE] {
            array[at] = 0.0;
        }
        add(Counter::DepthReached, 1);
    }

    /// Path `at`, the present one, leaves the scene.
    #[inline(always)]
    pub fn escape(&mut self, at: usize, direction: Vec3) {
        self.direction.set(at, direction);
    }

    /// The paths before `at` are done; it and those after it escape with their first rays. A later call for one of them
    /// replaces this.
    #[inline(always)]
    pub fn escape_several<V: SimdF64>(&mut self, at: usize, directions: Vec3<V>) {
        self.direction.store(at, directions);
        self.begin();
    }
}

/// Gives every path of the queue its colour, and forgets it.
pub struct Color<'a, L: Layout> {
    pub prepared: &'a Prepared<L>,
    pub queue: &'a PathQueue,
    pub ends: &'a mut PathEnds,
    pub batch: &'a mut Batch,
}

impl<L: Layout> Kernel for Color<'_, L> {
    type Output = ();

    #[inline(always)]
    fn call<S: Simd>(self, _: S) {
        color::<S, L>(self);
    }
}

#[inline(always)]
fn color<S: Simd, L: Layout>(Color { prepared, queue, ends, batch }: Color<'_, L>) {
    let background = prepared.background.lanes::<S::F64>();
    let colors = &mut ends.direction;
    for at in (0..queue.count).step_by(S::F64::LANES) {
        let color = background.color(colors.load::<S::F64>(at));
        colors.store(at, color);
    }
    // From the last surface back to the first, in the order in which the recursion returns; all paths in one loop, for
    // no processor guesses how long each is.
    for &Attenuation { path, material } in ends.met[..ends.count].iter().rev() {
        let reflectance = prepared.materials[material as usize].reflectance;
        colors.set(path as usize, colors.get(path as usize).attenuate(reflectance));
    }
    ends.count = 0;
    for at in (0..queue.count).step_by(S::F64::LANES) {
        let PathVertex { reflectance, .. } = PathVertex::of(queue.load::<S::F64>(at));
        let color = colors.load::<S::F64>(at).attenuate(reflectance);
        let sample = |place: usize| queue.arrays[PathVertex::SAMPLE][place].to_bits() as usize;
        let last = at + S::F64::LANES - 1;
        // Mostly all samples of the span are in the queue. Their numbers are in order, so these are consecutive.
        if last < queue.count && sample(last) - sample(at) == S::F64::LANES - 1 {
            batch.color.store(sample(at), color);
        } else {
            let color = LaneByLane::new(color.to_array());
            for place in at..queue.count.min(last + 1) {
                batch.color.set(sample(place), color.of(place - at).into());
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::config::Config;
    use crate::input::scene::Scene;
    use crate::layout::aos::Aos;
    use crate::materials::prepared::PreparedMaterial;
    use crate::sampling::scatter_vectors::Scatter;
    use crate::simd::instruction_set::InstructionSet;

    #[test]
    fn paths_that_left_are_coloured_and_attenuated_from_the_last_surface_back() {
        let scene = Scene::parse(&b"matte: a .1 .2 .3\nmatte: b .7 .9 .11\n"[..]).expect("the scene is valid");
        let prepared: Prepared<Aos> =
            Prepared::new(&Config::default(), &scene, Scatter::Statement).expect("it can be rendered");
        let reflectance = |material: usize| scene.materials[material].reflectance();
        let direction = Vec3::new(0.3, -0.7, 0.2);
        let background = prepared.background.color(direction);
        for set in InstructionSet::ALL.into_iter().filter(|set| set.is_available()) {
            let (mut queue, mut ends, mut batch) = (PathQueue::EMPTY, PathEnds::new(), Batch::new());
            batch.count = 11;
            for sample in 0..batch.count {
                batch.color.set(sample, Vec3::splat(sample as f64));
            }
            for (sample, material) in [(2, 0), (3, 0), (9, 1)] {
                let black = PathVertex::new(Vec3::ZERO, Vec3::ZERO, 0.0, &PreparedMaterial::BLACK);
                let (sample, reflectance) = (f64::from_bits(sample), reflectance(material));
                queue.push_one(PathVertex { sample, reflectance, ..black }.numbers());
            }
            ends.begin();
            assert!(ends.push_attenuation(0, 1) && ends.push_attenuation(0, 0));
            ends.escape(0, direction);
            ends.begin();
            assert!(ends.push_attenuation(1, 0));
            ends.terminate(1, &mut queue);
            ends.begin();
            ends.escape(2, direction);
            set.run(Color { prepared: &prepared, queue: &queue, ends: &mut ends, batch: &mut batch });
            let expected = background.attenuate(reflectance(0)).attenuate(reflectance(1)).attenuate(reflectance(0));
            assert_eq!(batch.color.get(2), expected);
            assert_eq!(batch.color.get(3), Vec3::ZERO, "a path without an end is black");
            assert_eq!(batch.color.get(9), background.attenuate(reflectance(1)));
            for sample in [0, 1, 4, 5, 6, 7, 8, 10] {
                assert_eq!(batch.color.get(sample), Vec3::splat(sample as f64), "it was not in the queue");
            }
            assert_eq!(ends.count, 0, "they are forgotten");
        }
    }

    #[test]
    fn a_path_longer_than_the_room_for_it_makes_more() {
        let mut ends = PathEnds::new();
        let room = ends.met.len();
        ends.begin();
        for number in 0..3 * room {
            assert!(ends.push_attenuation(1, number as MaterialId));
        }
        let material = ends.met[room].material;
        assert_eq!((ends.count, material, ends.check().is_ok()), (3 * room, room as MaterialId, true));
        assert!(ends.met.len() >= 3 * room);
    }
}
