//! Giants: the few objects that reach much farther than all others, for example a floor that is a disc of radius 10^7.
//! The boxes of a tree are moved outward by a part of its largest coordinate, so a giant in the tree would make every
//! ray hit every box. Coordinates beyond [`Extent::LARGEST`] would even overflow. So giants are not in the tree, and
//! every ray is tested against them.

use crate::accel::{dominant_sphere::DominantSphere, extent::Extent, extent::reach, object::ObjectId, object::count};
use crate::layout::Objects;

/// Maximum number of giants among the objects that do not reach beyond [`Extent::LARGEST`].
const MOST_GIANTS: usize = 8;

/// Giants reach at least this many times as far as all other objects. With this ratio, boxes are moved by a hundredth
/// of the other objects' extent.
const GAP: f64 = 1e4;

/// Returns the reach beyond which an object is a giant, or `None` if the scene has no giants. The dominant sphere is no
/// giant, because it is not in the tree anyway.
pub(crate) fn giants_beyond(objects: &impl Objects, dominant: DominantSphere, extent: &Extent) -> Option<f64> {
    // The largest numbers, in descending order.
    let mut farthest = [0.0; MOST_GIANTS + 1];
    for id in (0..count(objects) as ObjectId).filter(|&id| !dominant.is(id)) {
        let reach = reach(objects, id);
        if reach > farthest[MOST_GIANTS] {
            farthest[MOST_GIANTS] = reach;
            farthest.sort_unstable_by(|left, right| right.total_cmp(left));
        }
    }
    let mut gaps = farthest.windows(2).filter(|pair| pair[1] > 0.0 && pair[0] >= GAP * pair[1]);
    let limit = gaps.next_back().map_or(Extent::LARGEST, |pair| pair[1].min(Extent::LARGEST));
    (extent.max_coordinate > Extent::LARGEST || farthest[0] > limit).then_some(limit)
}
