//! Builds the hierarchy from the top down, as `cpu/src/accel/bvh/build.rs` does, but with two children in a node.

use cpu::Vec3;
use cpu::internals::accel::bounds::Bounds;

use super::{Growth, NO_OBJECT, Node};

/// Number of bins along the axis of a split.
const BINS: usize = 16;
/// From this depth on, a range is split into halves. This limits the depth.
const MOST_SAH_DEPTH: u32 = 40;

/// An object with its box.
#[derive(Clone, Copy)]
pub struct Item {
    pub bounds: Bounds,
    pub growth: Growth,
    /// The number of the object, as in [`Node::object`].
    pub object: u32,
}

/// Returns a leaf for each of the `first` items, and then the nodes of a tree over `items` in depth-first order. Of two
/// children, the one whose box is nearer to `camera` comes first. The items are reordered.
pub fn build(first: &[Item], items: &mut [Item], camera: Vec3) -> Vec<Node> {
    let mut nodes = Vec::with_capacity(first.len() + 2 * items.len());
    for (&Item { bounds, growth, object }, next) in first.iter().zip(1..) {
        nodes.push(Node { bounds, growth, next, object });
    }
    if !items.is_empty() {
        add(items, camera, 0, &mut nodes);
    }
    nodes
}

/// Appends the node over `items` and all nodes below it.
fn add(items: &mut [Item], camera: Vec3, depth: u32, nodes: &mut Vec<Node>) {
    let place = nodes.len();
    let bounds = items.iter().fold(Bounds::EMPTY, |all, item| all.union(&item.bounds));
    let object = if let [only] = items { only.object } else { NO_OBJECT };
    let growth = items.iter().fold(Growth::default(), |all, item| all.union(&item.growth));
    nodes.push(Node { bounds, growth, next: 0, object });
    if items.len() > 1 {
        let middle = split(items, depth);
        let (left, right) = items.split_at_mut(middle);
        let around = |part: &[Item]| part.iter().fold(Bounds::EMPTY, |all, item| all.union(&item.bounds));
        let distance = |part: &[Item]| around(part).distance(camera);
        let (first, second) = if distance(right) < distance(left) { (right, left) } else { (left, right) };
        add(first, camera, depth + 1, nodes);
        add(second, camera, depth + 1, nodes);
    }
    nodes[place].next = nodes.len() as u32;
}

/// Reorders at least two items, and returns the number of items of the first child, which is neither 0 nor all.
fn split(items: &mut [Item], depth: u32) -> usize {
    let middles = items.iter().fold(Bounds::EMPTY, |all, item| {
        let middle = [0, 1, 2].map(|axis| item.bounds.twice_middle(axis));
        all.union(&Bounds { low: middle, high: middle })
    });
    let axis = middles.longest_axis();
    let scale = BINS as f32 / (middles.high[axis] - middles.low[axis]);
    // A cast to an integer saturates, and turns "not a number" into 0.
    let bin_of = |item: &Item| (((item.bounds.twice_middle(axis) - middles.low[axis]) * scale) as usize).min(BINS - 1);
    let mut middle = 0;
    if depth < MOST_SAH_DEPTH
        && scale.is_finite()
        && let Some(last_left) = cheapest_cut(items, bin_of)
    {
        for at in 0..items.len() {
            if bin_of(&items[at]) <= last_left {
                items.swap(at, middle);
                middle += 1;
            }
        }
    }
    if middle == 0 || middle == items.len() {
        middle = items.len() / 2;
        let key = |item: &Item| item.bounds.twice_middle(axis);
        items.select_nth_unstable_by(middle, |left, right| key(left).total_cmp(&key(right)));
    }
    middle
}

/// Returns the last bin of the first child in the split with the lowest cost, or `None` if all items are in one bin.
fn cheapest_cut(items: &[Item], bin_of: impl Fn(&Item) -> usize) -> Option<usize> {
    let mut bins = [(Bounds::EMPTY, 0_usize); BINS];
    for item in items {
        let (bounds, count) = &mut bins[bin_of(item)];
        *bounds = bounds.union(&item.bounds);
        *count += 1;
    }
    let add = |(bounds, count): (Bounds, usize), bin: usize| (bounds.union(&bins[bin].0), count + bins[bin].1);
    let cost = |(bounds, count): (Bounds, usize)| bounds.half_area() * count as f32;
    let cuts = (0..BINS - 1).filter_map(|last| {
        let left = (0..=last).fold((Bounds::EMPTY, 0), add);
        let right = (last + 1..BINS).fold((Bounds::EMPTY, 0), add);
        (left.1 > 0 && right.1 > 0).then(|| (last, cost(left) + cost(right)))
    });
    cuts.min_by(|one, other| one.1.total_cmp(&other.1)).map(|(last, _)| last)
}
