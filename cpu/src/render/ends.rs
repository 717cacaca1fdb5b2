//! Where paths leave the scene: the background, several at once, attenuated by all that the paths have met.

use super::batch::{Batch, CAPACITY, SLACK, Vectors};
use super::shade::{load, store};
use crate::certified::Intersect;
use crate::layout::Layout;
use crate::prepare::Prepared;
use crate::scene::MaterialId;
use crate::simd::{Kernel, Lanes, Simd};
use crate::vec3::Vec3;

/// Paths that have left the scene, in the order in which they did.
#[derive(Debug)]
pub struct Ended {
    count: usize,
    direction: Vectors,
    /// Each path's sample, and where its materials begin in `met`.
    path: [(u32, u32); CAPACITY + SLACK],
    /// Materials met, path after path, first hit first.
    met: Vec<MaterialId>,
    /// Where the present path's materials begin.
    present: usize,
}

impl Ended {
    /// No path yet.
    pub fn new() -> Self {
        let path = [(0, 0); CAPACITY + SLACK];
        Self { count: 0, direction: Vectors::ZERO, path, met: Vec::with_capacity(8 * CAPACITY), present: 0 }
    }

    /// Begins a path.
    #[inline(always)]
    pub fn begin(&mut self) {
        self.present = self.met.len();
    }

    /// The present path has met a material that attenuates.
    #[inline(always)]
    pub fn meet(&mut self, material: MaterialId) {
        self.met.push(material);
    }

    /// The present path has used up its depth: it is black.
    #[inline(always)]
    pub fn forget(&mut self) {
        self.met.truncate(self.present);
    }

    /// The present path leaves the scene.
    ///
    /// # Panics
    /// When more paths leave than a batch has samples.
    #[inline(always)]
    pub fn leave(&mut self, sample: usize, direction: Vec3) {
        let at = self.count;
        self.path[at] = (sample as u32, self.present as u32);
        self.direction.set(at, direction);
        self.count = at + 1;
    }
}

/// Gives every path that has left the scene its colour, and forgets it.
pub struct Color<'a, L: Layout, P> {
    pub prepared: &'a Prepared<L, P>,
    pub ended: &'a mut Ended,
    pub batch: &'a mut Batch,
}

impl<L: Layout, P: Intersect> Kernel for Color<'_, L, P> {
    type Output = ();

    #[inline(always)]
    fn call<S: Simd>(self, _: S) {
        color::<S, L, P>(self.prepared, self.ended, self.batch);
    }
}

#[inline(always)]
fn color<S: Simd, L: Layout, P: Intersect>(prepared: &Prepared<L, P>, ended: &mut Ended, batch: &mut Batch) {
    let background = prepared.background.lanes::<S::F64>();
    for at in (0..ended.count).step_by(S::F64::LANES) {
        let color = background.color(load::<S::F64>(&ended.direction, at));
        store(color, &mut ended.direction, at);
    }
    let mut end = ended.met.len();
    for at in (0..ended.count).rev() {
        let (sample, begin) = ended.path[at];
        let mut color = ended.direction.get(at);
        // From the last surface back to the first, in the order in which the recursion returns.
        for &material in ended.met[begin as usize..end].iter().rev() {
            color = color.attenuate(prepared.finishes[material as usize].reflectance);
        }
        end = begin as usize;
        batch.color.set(sample as usize, color);
    }
    ended.count = 0;
    ended.met.clear();
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
            let (mut ended, mut batch) = (Ended::new(), Batch::new());
            ended.begin();
            ended.meet(0);
            ended.meet(1);
            ended.leave(5, direction);
            ended.begin();
            ended.meet(0);
            ended.forget();
            ended.begin();
            ended.meet(1);
            ended.leave(2, direction);
            set.run(Color { prepared: &prepared, ended: &mut ended, batch: &mut batch });
            let expected = background.attenuate(reflectance(1)).attenuate(reflectance(0));
            assert_eq!(batch.color.get(5), expected);
            assert_eq!(batch.color.get(2), background.attenuate(reflectance(1)));
            assert_eq!((ended.count, ended.met.len()), (0, 0), "they are forgotten");
        }
    }
}
