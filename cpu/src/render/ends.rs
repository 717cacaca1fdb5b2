//! Where paths leave the scene: the background, several at once, attenuated by all that the paths have met.

use super::batch::Batch;
use crate::layout::Layout;
use crate::prepare::Prepared;
use crate::scene::MaterialId;
use crate::simd::{Lanes, Simd};
use crate::vec3::Vec3;

/// Paths that have left the scene, in the order in which they did.
#[derive(Debug, Default)]
pub struct Ended {
    direction: [Vec<f64>; 3],
    sample: Vec<u32>,
    /// Where each path's materials begin in `met`.
    begins: Vec<usize>,
    /// Materials met, path after path, first hit first.
    met: Vec<MaterialId>,
    /// Where the present path's materials begin.
    present: usize,
}

impl Ended {
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
    #[inline(always)]
    pub fn leave(&mut self, sample: usize, direction: Vec3) {
        for (list, component) in self.direction.iter_mut().zip(direction.to_array()) {
            list.push(component);
        }
        self.sample.push(sample as u32);
        self.begins.push(self.present);
    }
}

/// Gives every path that has left the scene its colour, and forgets it.
#[inline(always)]
pub fn color<S: Simd, L: Layout>(prepared: &Prepared<L>, ended: &mut Ended, batch: &mut Batch) {
    let background = prepared.background.lanes::<S::F64>();
    let count = ended.sample.len();
    let padded = count.next_multiple_of(S::F64::LANES);
    for list in &mut ended.direction {
        list.resize(padded, 1.0);
    }
    let [x, y, z] = &mut ended.direction;
    for at in (0..count).step_by(S::F64::LANES) {
        let direction = Vec3::new(S::F64::load(&x[at..]), S::F64::load(&y[at..]), S::F64::load(&z[at..]));
        let color = background.color(direction);
        color.x.store(&mut x[at..]);
        color.y.store(&mut y[at..]);
        color.z.store(&mut z[at..]);
    }
    let mut end = ended.met.len();
    for path in (0..count).rev() {
        let begin = ended.begins[path];
        let mut color = Vec3::new(x[path], y[path], z[path]);
        // From the last surface back to the first, in the order in which the recursion returns.
        for &material in ended.met[begin..end].iter().rev() {
            color = color.attenuate(prepared.finishes[material as usize].reflectance);
        }
        end = begin;
        batch.color.set(ended.sample[path] as usize, color);
    }
    x.clear();
    y.clear();
    z.clear();
    ended.sample.clear();
    ended.begins.clear();
    ended.met.clear();
}
