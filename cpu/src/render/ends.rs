//! Where paths leave the scene: the background, several at once, attenuated by all that the paths have met.

use super::batch::{Batch, CAPACITY, SLACK, Vectors};
use super::queue::Queue;
use super::shade::{load, store};
use crate::certified::Intersect;
use crate::counters::{Counter, add};
use crate::error::Error;
use crate::layout::Layout;
use crate::prepare::Prepared;
use crate::scene::MaterialId;
use crate::simd::{Kernel, Lanes, Simd};
use crate::vec3::Vec3;

/// Instead of where a path's materials begin: it has used up its depth and is black.
const BLACK: u32 = u32::MAX;

/// The ends of the queue's paths, by place in the queue.
#[derive(Debug)]
pub struct Ended {
    /// The last direction of each path.
    pub direction: Vectors,
    /// Where each path's materials begin in `met`, or [`BLACK`].
    begin: [u32; CAPACITY + SLACK],
    /// Materials met after the one that the path stands on in the queue, path after path; room behind the last.
    met: Vec<MaterialId>,
    /// How many these are.
    count: usize,
    /// There was no room for one of them: colours are of no meaning.
    is_incomplete: bool,
}

impl Ended {
    /// No path yet.
    pub fn new() -> Self {
        let begin = [0; CAPACITY + SLACK];
        Self { direction: Vectors::ZERO, begin, met: vec![0; 8 * CAPACITY], count: 0, is_incomplete: false }
    }

    /// Whether all that paths met could be kept.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`]: a path between mirrors may meet as many surfaces as `max_depth` says.
    pub fn check(&self) -> Result<(), Error> {
        if self.is_incomplete { Err(Error::OutOfMemory { what: "the surfaces that a ray meets" }) } else { Ok(()) }
    }

    /// Begins path `at`; those before it are done.
    #[inline(always)]
    pub fn begin(&mut self, at: usize) {
        self.begin[at] = self.count as u32;
    }

    /// The present path has met a material that attenuates. Says whether it could be kept; see [`Ended::check`].
    #[inline(always)]
    pub fn meet(&mut self, material: MaterialId) -> bool {
        if self.count == self.met.len() && !self.grow() {
            return false;
        }
        self.met[self.count] = material;
        self.count += 1;
        true
    }

    /// Makes room for as many materials again, and says whether there was any. A place must fit `begin`.
    #[cold]
    #[inline(never)]
    fn grow(&mut self) -> bool {
        let more = self.met.len();
        let fits = more < (BLACK / 2) as usize && self.met.try_reserve_exact(more).is_ok();
        if fits {
            self.met.resize(2 * more, 0);
        }
        self.is_incomplete |= !fits;
        fits
    }

    /// Path `at`, the present one, has used up its depth: it is black.
    #[inline(always)]
    pub fn forget(&mut self, at: usize) {
        self.count = self.begin[at] as usize;
        self.begin[at] = BLACK;
        add(Counter::DepthReached, 1);
    }

    /// Path `at`, the present one, leaves the scene.
    #[inline(always)]
    pub fn leave(&mut self, at: usize, direction: Vec3) {
        self.direction.set(at, direction);
    }

    /// Path `at` and those after it begin, and leave the scene with their first rays. What is said later of one
    /// of them replaces this.
    #[inline(always)]
    pub fn leave_several<V: Lanes>(&mut self, at: usize, directions: Vec3<V>) {
        store(directions, &mut self.direction, at);
        let begin = self.count as u32;
        self.begin[at..at + V::LANES].fill(begin);
    }
}

/// Gives every path of the queue its colour, and forgets it.
pub struct Color<'a, L: Layout, P> {
    pub prepared: &'a Prepared<L, P>,
    pub queue: &'a Queue,
    pub ended: &'a mut Ended,
    pub batch: &'a mut Batch,
}

impl<L: Layout, P: Intersect> Kernel for Color<'_, L, P> {
    type Output = ();

    #[inline(always)]
    fn call<S: Simd>(self, _: S) {
        color::<S, L, P>(self);
    }
}

#[inline(always)]
fn color<S: Simd, L: Layout, P: Intersect>(Color { prepared, queue, ended, batch }: Color<'_, L, P>) {
    let background = prepared.background.lanes::<S::F64>();
    for at in (0..queue.count).step_by(S::F64::LANES) {
        let color = background.color(load::<S::F64>(&ended.direction, at));
        store(color, &mut ended.direction, at);
    }
    let mut end = ended.count;
    for at in (0..queue.count).rev() {
        let begin = ended.begin[at];
        if begin == BLACK {
            continue;
        }
        let begin = begin as usize;
        let mut color = ended.direction.get(at);
        // From the last surface back to the first, in the order in which the recursion returns.
        for &material in ended.met[begin..end].iter().rev() {
            color = color.attenuate(prepared.finishes[material as usize].reflectance);
        }
        color = color.attenuate(prepared.finishes[queue.material[at] as usize].reflectance);
        end = begin;
        batch.color.set(batch.waiting[at] as usize, color);
    }
    ended.count = 0;
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::config::Config;
    use crate::layout::Aos;
    use crate::scatter::Scatter;
    use crate::scene::Scene;
    use crate::simd::InstructionSet;

    #[test]
    fn paths_that_left_are_coloured_and_attenuated_from_the_last_surface_back() {
        let scene = Scene::parse(&b"matte: a .1 .2 .3\nmatte: b .7 .9 .11\n"[..]).expect("the scene is valid");
        let prepared: Prepared<Aos> =
            Prepared::new(&Config::default(), &scene, Scatter::Statement).expect("it can be rendered");
        let reflectance = |material: usize| scene.materials[material].reflectance();
        let direction = Vec3::new(0.3, -0.7, 0.2);
        let background = prepared.background.color(direction);
        for set in InstructionSet::ALL.into_iter().filter(|set| set.is_available()) {
            let (mut queue, mut ended, mut batch) = (Queue::new(), Ended::new(), Batch::new());
            batch.waiting.extend([5, 3, 2]);
            queue.count = 3;
            queue.material[..3].copy_from_slice(&[0, 0, 1]);
            ended.begin(0);
            assert!(ended.meet(1));
            ended.leave(0, direction);
            ended.begin(1);
            assert!(ended.meet(0));
            ended.forget(1);
            ended.begin(2);
            ended.leave(2, direction);
            set.run(Color { prepared: &prepared, queue: &queue, ended: &mut ended, batch: &mut batch });
            let expected = background.attenuate(reflectance(1)).attenuate(reflectance(0));
            assert_eq!(batch.color.get(5), expected);
            assert_eq!(batch.color.get(3), Vec3::ZERO, "a path without an end keeps the black it had");
            assert_eq!(batch.color.get(2), background.attenuate(reflectance(1)));
            assert_eq!(ended.count, 0, "they are forgotten");
        }
    }

    #[test]
    fn a_path_longer_than_the_room_for_it_makes_more() {
        let mut ended = Ended::new();
        let room = ended.met.len();
        ended.begin(0);
        for at in 0..3 * room {
            assert!(ended.meet(at as MaterialId));
        }
        assert_eq!((ended.count, ended.met[room], ended.check().is_ok()), (3 * room, room as MaterialId, true));
        assert!(ended.met.len() >= 3 * room);
    }
}
