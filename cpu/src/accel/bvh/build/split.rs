//! Splits ranges of items by the surface area heuristic: the number of rays that hit a box is proportional to its
//! surface area.

use crate::accel::bvh::build::item::{Item, ItemRange, PackedBounds};
use crate::accel::bvh::planes::WIDTH;

/// Number of bins along the axis of a split.
const BINS: usize = 16;

/// The cost of visiting a node, where testing an object costs 1. With 16, nearest hits take less time
/// than if only visits counted. With 4 or 64 there is no gain (bench/src/bin/nearest.rs).
const VISIT_COST: usize = 16;

/// From this depth on, a range is split into two halves with equal numbers of objects, and not by the surface area
/// heuristic. This limits the depth of the tree, and so the size of the traversal stack.
const MOST_SAH_DEPTH: u32 = 16;

/// The items whose middles lie in one part of the axis of a split.
#[derive(Clone, Copy)]
struct Bin {
    bounds: PackedBounds,
    middles: PackedBounds,
    count: usize,
}

impl Bin {
    const EMPTY: Self = Self { bounds: PackedBounds::EMPTY, middles: PackedBounds::EMPTY, count: 0 };

    /// Returns the bin that holds the items of both.
    fn union(&self, other: &Self) -> Self {
        let (bounds, middles) = (self.bounds.union(other.bounds), self.middles.union(other.middles));
        Self { bounds, middles, count: self.count + other.count }
    }

    /// Returns the cost: the surface area times the time for the items. The time is one test for each item, and
    /// [`VISIT_COST`] tests for each node that is needed to hold the items. A visit tests all boxes of a node at once.
    fn cost(&self) -> f32 {
        self.bounds.unpacked().half_area() * (self.count + VISIT_COST * self.count.div_ceil(WIDTH)) as f32
    }

    /// Returns the range of the bin's items, which begin at the index `from`.
    const fn range(&self, from: usize) -> ItemRange {
        ItemRange { from, to: from + self.count, bounds: self.bounds, middles: self.middles }
    }
}

/// Splits the range in `children[0]` into several ranges. It always splits the child whose surface area times its
/// number of objects is the largest, until all of `children` are used or every child has at most [`WIDTH`] objects.
/// Returns the number of children.
pub(crate) fn split_into_children(items: &mut [Item], children: &mut [ItemRange], depth: u32) -> usize {
    let mut count = 1;
    while count < children.len() {
        let priority = |range: &ItemRange| range.bounds.unpacked().half_area() * range.count() as f32;
        let splittable = children[..count].iter().enumerate().filter(|(_, range)| range.count() > WIDTH);
        let Some((worst, _)) = splittable.max_by(|left, right| priority(left.1).total_cmp(&priority(right.1))) else {
            break;
        };
        let [left, right] = split(items, &children[worst], depth);
        children[worst] = left;
        children[count] = right;
        count += 1;
    }
    count
}

/// Replaces the smallest of the first `count` children by their objects, as long as there are free lanes. This saves
/// nodes, and visits of nodes. Returns the number of children.
pub(crate) fn dissolve_small_children(items: &[Item], children: &mut [ItemRange; WIDTH], mut count: usize) -> usize {
    loop {
        let small = (0..count).filter(|&at| children[at].count() > 1);
        let Some(smallest) = small.min_by_key(|&at| children[at].count()) else { return count };
        let ItemRange { from, to, .. } = children[smallest];
        if count - 1 + to - from > WIDTH {
            return count;
        }
        children[smallest] = ItemRange::new(items, from, from + 1);
        for at in from + 1..to {
            children[count] = ItemRange::new(items, at, at + 1);
            count += 1;
        }
    }
}

/// Splits a range of at least two items into two ranges that are not empty, by the surface area heuristic. From the
/// depth [`MOST_SAH_DEPTH`] on, or if all items are in one bin, it splits into halves. The items are reordered.
fn split(items: &mut [Item], range: &ItemRange, depth: u32) -> [ItemRange; 2] {
    let part = &mut items[range.from..range.to];
    let axis = range.middles.unpacked().longest_axis();
    let (low, high) = (range.middles.low[axis], -range.middles.minus_high[axis]);
    let scale = BINS as f32 / (high - low);
    // A float-to-integer cast saturates, and turns "not a number" into 0.
    let bin_of = |item: &Item| (((item.twice_middle(axis) - low) * scale) as usize).min(BINS - 1);
    if depth < MOST_SAH_DEPTH
        && scale.is_finite()
        && let Some((last_left, [left, right])) = cheapest_cut(part, bin_of)
    {
        let mut middle = 0;
        for at in 0..part.len() {
            // The item is swapped even if it stays on the right, because a branch would often be mispredicted.
            let is_left = bin_of(&part[at]) <= last_left;
            part.swap(at, middle);
            middle += usize::from(is_left);
        }
        let left = left.range(range.from);
        return [left, right.range(left.to)];
    }
    let middle = part.len() / 2;
    let key = |item: &Item| item.twice_middle(axis);
    part.select_nth_unstable_by(middle, |left, right| key(left).total_cmp(&key(right)));
    let middle = range.from + middle;
    [ItemRange::new(items, range.from, middle), ItemRange::new(items, middle, range.to)]
}

/// Returns the split with the lowest cost: the last bin of the left part, and both parts. Returns `None` if all items
/// are in the same bin.
fn cheapest_cut(part: &[Item], bin_of: impl Fn(&Item) -> usize) -> Option<(usize, [Bin; 2])> {
    let mut bins = [Bin::EMPTY; BINS];
    for item in part {
        let bin = &mut bins[bin_of(item)];
        bin.bounds = bin.bounds.union(item.bounds());
        bin.middles = bin.middles.union(item.middle());
        bin.count += 1;
    }
    let mut right = [Bin::EMPTY; BINS + 1];
    for bin in (0..BINS).rev() {
        right[bin] = right[bin + 1].union(&bins[bin]);
    }
    let mut left = Bin::EMPTY;
    let mut best = None;
    let mut best_cost = f32::INFINITY;
    for bin in 0..BINS - 1 {
        left = left.union(&bins[bin]);
        let right = &right[bin + 1];
        let cost = left.cost() + right.cost();
        if left.count > 0 && right.count > 0 && cost < best_cost {
            (best, best_cost) = (Some((bin, [left, *right])), cost);
        }
    }
    best
}
