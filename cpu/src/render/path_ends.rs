//! The ends of paths. A path that escapes takes the background's colour, multiplied by the reflectances of the surfaces
//! on the path. The background is computed for several paths at once. A path that is terminated is black.

use crate::counters::{Counter, add};
use crate::input::{error::Error, scene::MaterialId};
use crate::layout::Layout;
use crate::math::vec3::Vec3;
use crate::render::arrays::{CAPACITY, ROOM};
use crate::render::{lane_numbers::SampleIndex, limits::Ended, queue::PathQueue, samples::Batch};
use crate::render::{path_vertex::PathVertex, prepared::Prepared};
use crate::simd::{MOST_LANES, SimdF64, columns::Columns};

/// For each path of the queue, by its index in the queue: the direction of its last ray and the materials that
/// attenuate its colour. [`PathEnds::color`] computes the colours of all paths from these. The paths are traced one
/// after the other, and the present path is the one that is being traced.
#[derive(Debug)]
pub struct PathEnds {
    /// The direction of the last ray of each path.
    pub direction: Columns<3, ROOM>,
    /// The surfaces that each path hits after its first surface, path after path. The reflectance of the first surface
    /// is in the queue.
    attenuations: Vec<Attenuation>,
    /// Number of attenuations that belong to the paths before the present one.
    begin: usize,
    /// Largest number of attenuations.
    most: usize,
    /// What [`PathEnds::check`] returns: the reason why an attenuation could not be stored, if there is one. Colours
    /// are then wrong.
    shortage: Result<Option<Ended>, Error>,
}

/// A hit of a path, by its index in the queue, on a surface of this material, which attenuates the path's colour.
#[derive(Clone, Copy, Debug)]
struct Attenuation {
    path: u32,
    material: MaterialId,
}

impl PathEnds {
    /// Returns the state before the first path. The paths of a span may hit at most `most` surfaces together, after
    /// their first ones.
    pub(super) fn new(most: usize) -> Self {
        let attenuations = Vec::with_capacity(8 * CAPACITY);
        Self { direction: Columns::ZERO, attenuations, begin: 0, most, shortage: Ok(None) }
    }

    /// Checks that all attenuations could be stored, so that all colours are right. Returns the reason if there were
    /// more of them than allowed.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`] if memory was short. A path between mirrors may hit up to `max_depth` surfaces.
    pub(crate) const fn check(&mut self) -> Result<Option<Ended>, Error> {
        std::mem::replace(&mut self.shortage, Ok(None))
    }

    /// Begins a path. All paths before it must have ended.
    #[inline(always)]
    pub(crate) const fn begin(&mut self) {
        self.begin = self.attenuations.len();
    }

    /// Attenuates the present path, at index `at` of the queue, by a material. Returns false if it cannot be
    /// stored. [`PathEnds::check`] then tells the reason.
    #[inline(always)]
    pub(crate) fn push_attenuation(&mut self, at: usize, material: MaterialId) -> bool {
        if self.attenuations.len() == self.attenuations.capacity() && !self.grow() {
            return false;
        }
        self.attenuations.push(Attenuation { path: at as u32, material });
        true
    }

    /// Doubles the room for attenuations, up to their largest number. Returns false if that fails.
    #[cold]
    fn grow(&mut self) -> bool {
        let count = self.attenuations.len();
        let more = count.min(self.most.saturating_sub(count));
        if more == 0 {
            self.shortage = Ok(Some(Ended::TooManySurfaces));
        } else if self.attenuations.try_reserve_exact(more).is_err() {
            self.shortage = Err(Error::OutOfMemory { what: "the surfaces that a ray meets" });
        }
        matches!(self.shortage, Ok(None))
    }

    /// Ends the present path, at index `at` of `queue`, at the maximum depth, so that it is black.
    #[inline(always)]
    pub(crate) fn terminate(&mut self, at: usize, queue: &mut PathQueue) {
        self.attenuations.truncate(self.begin);
        self.direction.set(at, [1.0; 3]);
        for column in &mut queue.entries.0[PathVertex::REFLECTANCE] {
            column[at] = 0.0;
        }
        add(Counter::MaxDepthReached, 1);
    }

    /// Ends the present path, at index `at` of the queue, with a ray along `direction` that leaves the scene.
    #[inline(always)]
    pub(crate) fn escape(&mut self, at: usize, direction: Vec3) {
        self.direction.set(at, direction.to_array());
    }

    /// Ends the paths from index `at` on, one in each lane, with their first rays, which leave the scene. All paths
    /// before `at` must have ended. A later call may end one of these paths again. It then replaces the direction.
    #[inline(always)]
    pub(crate) fn escape_several<V: SimdF64>(&mut self, at: usize, directions: Vec3<V>) {
        self.direction.store(at, directions.to_array());
        self.begin();
    }

    /// Computes the colours of all paths of the queue, stores them in `batch`, and removes the attenuations.
    #[inline(always)]
    pub(crate) fn color<V: SimdF64, L: Layout>(
        &mut self,
        prepared: &Prepared<L>,
        queue: &PathQueue,
        batch: &mut Batch,
    ) {
        let colors = &mut self.direction;
        let background = prepared.background.lanes::<V>();
        for at in (0..queue.count).step_by(V::LANES) {
            let color = background.color(colors.load::<V>(at).into());
            colors.store(at, color.to_array());
        }
        // The factors are applied from the last surface back to the first, in the order in which the recursion returns.
        // There is one loop for all paths. A loop for each path would end in a branch that is mispredicted once for
        // each path.
        for &Attenuation { path, material } in self.attenuations.iter().rev() {
            let color = Vec3::from(colors.get(path as usize));
            let reflectance = prepared.materials[material as usize].reflectance;
            colors.set(path as usize, color.attenuate(reflectance).to_array());
        }
        self.attenuations.clear();
        for at in (0..queue.count).step_by(V::LANES) {
            let PathVertex { reflectance, .. } = PathVertex::of(queue.entries.load::<V>(at));
            let color = Vec3::from(colors.load::<V>(at)).attenuate(reflectance).to_array();
            let sample = |index: usize| SampleIndex(queue.entries.0[PathVertex::SAMPLE][index]).get();
            let last = at + V::LANES - 1;
            // Mostly all samples of the span are in the queue. They are in order, so the samples of the lanes are
            // consecutive.
            if last < queue.count && sample(last) - sample(at) == V::LANES - 1 {
                batch.color.store(sample(at), color);
            } else {
                let color = Columns::<3, MOST_LANES>::of_lanes(color);
                for index in at..queue.count.min(last + 1) {
                    batch.color.set(sample(index), color.get(index - at));
                }
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
    use crate::render::lane_numbers::ObjectNumber;
    use crate::render::{limits::Limits, path::PathTracer, span_state::SpanState, stages::ColorPaths};
    use crate::sampling::scatter_vectors::Scatter;
    use crate::simd::instruction_set::InstructionSet;

    #[test]
    fn paths_that_escape_are_coloured_and_attenuated_from_the_last_surface_back() {
        let scene = Scene::parse(&b"matte: a .1 .2 .3\nmatte: b .7 .9 .11\n"[..]).expect("the scene is valid");
        let prepared: Prepared<Aos> =
            Prepared::new(&Config::default(), &scene, Scatter::Statement).expect("it can be rendered");
        let reflectance = |material: usize| scene.materials[material].reflectance();
        let direction = Vec3::new(0.3, -0.7, 0.2);
        let background = prepared.background.color(direction);
        for set in InstructionSet::available() {
            let mut state = SpanState::new(&prepared, set, &Limits::default()).expect("it fits");
            let (PathTracer { queue, ends, .. }, batch) = (&mut *state.tracer, &mut *state.batch);
            batch.count = 11;
            for sample in 0..batch.count {
                batch.color.set(sample, [sample as f64; 3]);
            }
            for (sample, material) in [(2, 0), (3, 0), (9, 1)] {
                let black = PathVertex::new(Vec3::ZERO, Vec3::ZERO, ObjectNumber(0.0), &PreparedMaterial::BLACK);
                let (sample, reflectance) = (SampleIndex::new(sample), reflectance(material));
                queue.push_one(PathVertex { sample, reflectance, ..black }.numbers());
            }
            ends.begin();
            assert!(ends.push_attenuation(0, 1) && ends.push_attenuation(0, 0));
            ends.escape(0, direction);
            ends.begin();
            assert!(ends.push_attenuation(1, 0));
            ends.terminate(1, queue);
            ends.begin();
            ends.escape(2, direction);
            set.run(ColorPaths(&mut state));
            let color = |sample| Vec3::from(state.batch.color.get(sample));
            let expected = background.attenuate(reflectance(0)).attenuate(reflectance(1)).attenuate(reflectance(0));
            assert_eq!(color(2), expected);
            assert_eq!(color(3), Vec3::ZERO, "a path without an end is black");
            assert_eq!(color(9), background.attenuate(reflectance(1)));
            for sample in [0, 1, 4, 5, 6, 7, 8, 10] {
                assert_eq!(color(sample), Vec3::splat(sample as f64), "it was not in the queue");
            }
            assert_eq!(state.tracer.ends.attenuations.len(), 0);
        }
    }

    #[test]
    fn a_path_longer_than_the_room_for_it_makes_more() {
        let mut ends = PathEnds::new(usize::MAX);
        let room = ends.attenuations.capacity();
        ends.begin();
        for number in 0..3 * room {
            assert!(ends.push_attenuation(1, number as MaterialId));
        }
        let material = ends.attenuations[room].material;
        assert_eq!((ends.attenuations.len(), material, ends.check().is_ok()), (3 * room, room as MaterialId, true));
    }

    #[test]
    fn attenuations_up_to_the_limit_are_stored_and_one_more_ends_the_picture() {
        let most = 24 * CAPACITY + 1;
        let mut ends = PathEnds::new(most);
        ends.begin();
        assert!((0..most).all(|_| ends.push_attenuation(0, 0)));
        assert_eq!(ends.check().expect("memory is enough"), None);
        assert!(!ends.push_attenuation(0, 0));
        assert_eq!(ends.check().expect("memory is enough"), Some(Ended::TooManySurfaces));
        assert_eq!((ends.attenuations.len(), ends.attenuations.capacity()), (most, most));
    }
}
