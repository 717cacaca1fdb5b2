//! Builds the tree from the top down. The surface area heuristic (SAH) over bins chooses binary splits (Wald, "On fast
//! construction of SAH-based bounding volume hierarchies", 2007). A node gathers up to 16 children.

use crate::accel::{
    bounds::Bounds, bvh::collapsed_root, bvh::node::Child, bvh::node::HIERARCHY, bvh::node::Node, bvh::node::WIDTH,
    object::ObjectId,
};
use crate::{input::error::Error, input::error::push, layout::with_room};

/// Number of bins along the axis of a split.
const BINS: usize = 16;

/// From this depth on, a range is split into two halves with equal numbers of objects, and not by the surface area
/// heuristic. This limits the depth of the tree, and so the size of the traversal stack.
const MOST_SAH_DEPTH: u32 = 16;

/// An object that the builder places in the tree, with its box.
#[derive(Clone, Copy)]
struct Item {
    bounds: Bounds,
    id: ObjectId,
}

/// A part of the list of items, which becomes one child: from index `from` to before index `to`, with the box around
/// its items.
#[derive(Clone, Copy)]
struct Range {
    from: usize,
    to: usize,
    bounds: Bounds,
}

impl Range {
    fn new(items: &[Item], from: usize, to: usize) -> Self {
        let bounds = items[from..to].iter().fold(Bounds::EMPTY, |all, item| all.union(&item.bounds));
        Self { from, to, bounds }
    }

    const fn count(&self) -> usize {
        self.to - self.from
    }
}

/// Builds the tree over `objects`, which are at most `most` pairs of a box and an object's number. Returns the nodes,
/// the root first. Without objects the list is empty.
///
/// # Errors
/// [`Error::OutOfMemory`] if memory is short.
pub fn build(most: usize, objects: impl Iterator<Item = (Bounds, ObjectId)>) -> Result<Vec<Node>, Error> {
    let mut items = with_room(most)?;
    items.extend(objects.map(|(bounds, id)| Item { bounds, id }));
    let mut nodes = Vec::new();
    if items.is_empty() {
        return Ok(nodes);
    }
    // Only the two highest levels, which may become the collapsed root, may have nodes that are not full.
    let planned = collapsed_root::planned(items.len());
    // The nodes that are not filled yet: index, range of items and depth.
    let mut pending = Vec::new();
    push(&mut pending, (0, Range::new(&items, 0, items.len()), 0), HIERARCHY)?;
    push(&mut nodes, Node::EMPTY, HIERARCHY)?;
    while let Some((node, range, depth)) = pending.pop() {
        let most = match planned {
            Some(planned) if depth == 1 => {
                // The numbers of children of all children of the root add up to the planned number.
                let part = |end: usize| planned * end / items.len();
                (part(range.to) - part(range.from)).clamp(2, WIDTH)
            }
            _ => WIDTH,
        };
        let mut children = [range; WIDTH];
        let count = if range.count() <= WIDTH {
            for (child, at) in children.iter_mut().zip(range.from..range.to) {
                *child = Range::new(&items, at, at + 1);
            }
            range.count()
        } else {
            split_into_children(&mut items, &mut children[..most], depth)
        };
        for (lane, child) in children[..count].iter().enumerate() {
            let target = if child.count() == 1 {
                Child::object(items[child.from].id)
            } else {
                push(&mut pending, (nodes.len(), *child, depth + 1), HIERARCHY)?;
                push(&mut nodes, Node::EMPTY, HIERARCHY)?;
                Child::node((nodes.len() - 1) as u32)
            };
            nodes[node].set(lane, &child.bounds, target);
        }
    }
    Ok(nodes)
}

/// Splits the range in `children[0]` into several ranges. It always splits the child with the highest cost, until all
/// of `children` are used or every child has at most [`WIDTH`] objects. Returns the number of children.
fn split_into_children(items: &mut [Item], children: &mut [Range], depth: u32) -> usize {
    let mut count = 1;
    while count < children.len() {
        let cost = |range: &Range| range.bounds.half_area() * range.count() as f32;
        let splittable = children[..count].iter().enumerate().filter(|(_, range)| range.count() > WIDTH);
        let Some((worst, _)) = splittable.max_by(|left, right| cost(left.1).total_cmp(&cost(right.1))) else {
            break;
        };
        let (left, right) = split(items, &children[worst], depth);
        children[worst] = left;
        children[count] = right;
        count += 1;
    }
    count
}

/// Splits a range of at least two items into two ranges that are not empty. The items are reordered.
fn split(items: &mut [Item], range: &Range, depth: u32) -> (Range, Range) {
    let part = &mut items[range.from..range.to];
    // The box around the middles of the items. All its coordinates are doubled.
    let middles = part.iter().fold(Bounds::EMPTY, |all, item| {
        let middle = [0, 1, 2].map(|axis| item.bounds.twice_middle(axis));
        all.union(&Bounds { low: middle, high: middle })
    });
    let axis = middles.longest_axis();
    let (low, high) = (middles.low[axis], middles.high[axis]);
    let scale = BINS as f32 / (high - low);
    let bin_of = |item: &Item| {
        // A float-to-integer cast saturates, and turns "not a number" into 0.
        (((item.bounds.twice_middle(axis) - low) * scale) as usize).min(BINS - 1)
    };
    let mut middle = 0;
    if depth < MOST_SAH_DEPTH
        && scale.is_finite()
        && let Some(last_left) = cheapest_cut(part, bin_of)
    {
        for at in 0..part.len() {
            if bin_of(&part[at]) <= last_left {
                part.swap(at, middle);
                middle += 1;
            }
        }
    }
    if middle == 0 || middle == part.len() {
        middle = part.len() / 2;
        let key = |item: &Item| item.bounds.twice_middle(axis);
        part.select_nth_unstable_by(middle, |left, right| key(left).total_cmp(&key(right)));
    }
    let middle = range.from + middle;
    (Range::new(items, range.from, middle), Range::new(items, middle, range.to))
}

/// Returns the last bin of the left part in the split with the lowest cost, or `None` if all items are in the same bin.
fn cheapest_cut(part: &[Item], bin_of: impl Fn(&Item) -> usize) -> Option<usize> {
    let mut bins = [(Bounds::EMPTY, 0_usize); BINS];
    for item in part {
        let (bounds, count) = &mut bins[bin_of(item)];
        *bounds = bounds.union(&item.bounds);
        *count += 1;
    }
    let mut right = [(Bounds::EMPTY, 0_usize); BINS + 1];
    for bin in (0..BINS).rev() {
        right[bin] = (right[bin + 1].0.union(&bins[bin].0), right[bin + 1].1 + bins[bin].1);
    }
    let mut left = (Bounds::EMPTY, 0);
    let mut best = None;
    let mut best_cost = f32::INFINITY;
    for bin in 0..BINS - 1 {
        left = (left.0.union(&bins[bin].0), left.1 + bins[bin].1);
        let (right_bounds, right_count) = &right[bin + 1];
        let cost = left.0.half_area() * left.1 as f32 + right_bounds.half_area() * *right_count as f32;
        if left.1 > 0 && *right_count > 0 && cost < best_cost {
            (best, best_cost) = (Some(bin), cost);
        }
    }
    best
}

#[cfg(test)]
mod tests;
