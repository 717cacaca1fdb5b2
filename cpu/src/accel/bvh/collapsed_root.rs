//! The collapsed root: one list of up to 64 boxes, which a ray tests instead of the root and its children. Most of them
//! are the boxes of the children's children.
//!
//! A traversal is bound by latency: the next node is known only after the test of the one before. Testing up to four
//! nodes together takes hardly longer than testing one, with at least [`LEAST_LANES`] lanes. So the collapsed root
//! saves the time of a level (docs/experiments.md, row "collapsed root").

use crate::accel::{
    bounds::Bounds, bvh::boxes::Boxes, bvh::boxes::FloatBoxes, bvh::node::Child, bvh::node::HIERARCHY, bvh::node::Kind,
    bvh::node::Node, bvh::planes::WIDTH, bvh::slab_ray::SlabRay,
};
use crate::{
    counters::Counter, counters::add, input::error::Error, input::error::push, layout::with_room, math::vec3::Vec3,
    simd::SimdF32,
};

/// Maximum number of boxes in the collapsed root. The test of the boxes returns a `u64` with one bit for each of them.
pub const MOST_BOXES: usize = 64;

/// The least number of `f32` lanes with which the collapsed root saves time: with four lanes its test of all boxes
/// takes longer than the visits that it saves.
pub const LEAST_LANES: usize = 8;

/// Returns the number of boxes that the collapsed root over `objects` objects should have, so that all nodes below it
/// can be full. The builder gives the children of the root about this number of children in total. The result is `None`
/// if a single node can hold all these boxes.
pub(crate) fn planned(objects: usize) -> Option<usize> {
    let mut nodes = objects.div_ceil(WIDTH);
    while nodes > MOST_BOXES {
        nodes = nodes.div_ceil(WIDTH);
    }
    (nodes > WIDTH).then_some(nodes)
}

/// The boxes of the tree's second level in one list, sorted along an axis. For each child of the root, the list has the
/// boxes of that child's children. The list has the box of the child itself if the child is an object, if it has an
/// object among its children, or if the list would have more than [`MOST_BOXES`] boxes.
#[derive(Debug)]
pub struct CollapsedRoot {
    /// The boxes, 16 in each entry. The list is empty if no collapsed root is [`planned`]. The traversal then begins at
    /// the root.
    rows: Vec<FloatBoxes>,
    /// Bit `i` is 1 if there is a box `i`.
    occupied: u64,
    /// The index of the node to which each box leads.
    nodes: [u32; MOST_BOXES],
    /// The axis along which the boxes are sorted: 0 for x, 1 for y, 2 for z.
    axis: usize,
}

impl CollapsedRoot {
    /// Returns the collapsed root of a tree over `objects` objects. Adds a node for each object that is a child of the
    /// root.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`] if memory is short.
    pub(crate) fn new<B: Boxes>(nodes: &mut Vec<Node<B>>, objects: usize) -> Result<Self, Error> {
        let mut root = Self { rows: Vec::new(), occupied: 0, nodes: [0; MOST_BOXES], axis: 0 };
        if planned(objects).is_none() {
            return Ok(root);
        }
        let mut boxes = with_room(MOST_BOXES, HIERARCHY)?;
        // The length of the list if each child that is still to come adds its own box.
        let mut count = nodes.first().map_or(0, |root| root.children().count());
        for (bounds, child) in nodes.first().into_iter().flat_map(Node::children) {
            let node = (child.kind == Kind::Node).then(|| &nodes[child.number as usize]);
            // The number of boxes that the list has more if a node's children replace it.
            let added = |node: &Node<B>| node.children().count() - 1;
            match node.filter(|node| node.has_only_nodes() && count + added(node) <= MOST_BOXES) {
                Some(node) => {
                    count += added(node);
                    boxes.extend(node.children());
                }
                None => boxes.push((bounds, child)),
            }
        }
        let all = boxes.iter().fold(Bounds::EMPTY, |all, (bounds, _)| all.union(bounds));
        root.axis = all.longest_axis();
        let middle = |(bounds, _): &(Bounds, Child)| bounds.twice_middle(root.axis);
        boxes.sort_unstable_by(|left, right| middle(left).total_cmp(&middle(right)));
        root.occupied = u64::MAX >> (MOST_BOXES - boxes.len());
        root.rows = with_room(MOST_BOXES / WIDTH, HIERARCHY)?;
        for row in boxes.chunks(WIDTH) {
            let mut bounds = [Bounds::EMPTY; WIDTH];
            for (to, (from, _)) in bounds.iter_mut().zip(row) {
                *to = *from;
            }
            root.rows.push(FloatBoxes::new(&bounds[..row.len()]));
        }
        for (&(bounds, child), index) in boxes.iter().zip(&mut root.nodes) {
            *index = child.number;
            if child.kind != Kind::Node {
                *index = nodes.len() as u32;
                push(nodes, Node::of_child(bounds, child), HIERARCHY)?;
            }
        }
        Ok(root)
    }

    /// Whether there are no boxes. A traversal then begins at the root of the tree.
    #[inline(always)]
    pub(crate) const fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// Removes all boxes. Returns false if there were none.
    #[cfg(feature = "internals")]
    pub(crate) fn clear(&mut self) -> bool {
        !std::mem::take(&mut self.rows).is_empty()
    }

    /// Returns a bit for each box, which is 1 if the ray hits the box at a lambda of at most `farthest`.
    #[inline(always)]
    pub(crate) fn intersect<F: SimdF32>(&self, slab_ray: &SlabRay<F>, farthest: f32) -> u64 {
        add(Counter::NodeVisits, self.rows.len() as u64);
        let mut bits = 0;
        for (place, row) in self.rows.iter().enumerate().take(MOST_BOXES / WIDTH) {
            let hit = row.intersect(slab_ray, farthest, &mut [0.0; WIDTH]);
            bits |= u64::from(hit) << (place * WIDTH);
        }
        bits & self.occupied
    }

    /// Whether a ray along `direction` passes the sorted boxes from the last to the first.
    #[inline(always)]
    pub(crate) fn is_passed_backwards(&self, direction: Vec3) -> bool {
        direction.to_array()[self.axis] < 0.0
    }

    /// Removes one box from `bits` and returns the index of the node to which it leads. This is the last box if
    /// `backwards` is set, and else the first. `bits` must not be 0.
    #[inline(always)]
    pub(crate) fn take_nearest(&self, bits: &mut u64, backwards: bool) -> usize {
        debug_assert!(*bits != 0);
        let (first, last) = (bits.trailing_zeros(), 63 - bits.leading_zeros());
        let place = if backwards { last } else { first };
        *bits ^= 1 << place;
        self.nodes[place as usize] as usize
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accel::bvh::{build::build, byte_boxes::ByteBoxes};
    use crate::sampling::uniform::Uniform;

    /// Returns the boxes of the collapsed root, in order.
    fn boxes_of(row: &CollapsedRoot) -> impl Iterator<Item = Bounds> {
        let count = if row.rows.is_empty() { 0 } else { row.occupied.count_ones() as usize };
        (0..count).map(|place| row.rows[place / WIDTH].bounds(place % WIDTH))
    }

    /// Returns the objects below a node.
    fn objects<B: Boxes>(nodes: &[Node<B>], node: &Node<B>) -> Vec<u32> {
        let of_child = |child: Child| match child.kind {
            Kind::Node => objects(nodes, &nodes[child.number as usize]),
            _ => vec![child.number],
        };
        node.children().flat_map(|(_, child)| of_child(child)).collect()
    }

    #[test]
    fn the_row_leads_to_every_object_once_and_the_levels_below_it_are_full() {
        for count in [0, 1, 16, 17, 250, 1000, 1100, 5000, 20_000] {
            let mut draws = Uniform::new(count as u64 + 7);
            let bounds = (0..count as u32).map(|id| {
                let low = [(); 3].map(|()| draws.draw(-10.0, 10.0) as f32);
                (Bounds { low, high: low.map(|value| value + 0.1) }, id)
            });
            let mut nodes = build::<ByteBoxes>(count, count, bounds, Some(false)).expect("it fits").nodes;
            let row = CollapsedRoot::new(&mut nodes, count).expect("it fits");
            let children = boxes_of(&row).count();
            if let Some(planned) = planned(count) {
                // A child of the root with few objects gets two children, even if one was planned. If they exceed the
                // room, some children of the root stay in the list.
                let most = (planned + 4).clamp(2 * WIDTH, MOST_BOXES);
                assert!((planned / 2..=most).contains(&children), "{children} children, {planned} planned");
            }
            let below = |&index: &u32| objects(&nodes, &nodes[index as usize]);
            let mut actual: Vec<_> = row.nodes[..children].iter().flat_map(below).collect();
            actual.sort_unstable();
            let expected = if planned(count).is_some() { 0..count as u32 } else { 0..0 };
            assert!(actual.into_iter().eq(expected), "{count} objects");
            let bytes = nodes.len() * size_of::<Node<ByteBoxes>>() + size_of_val(&row.rows[..]);
            assert!(count <= 256 || bytes < 20 * count, "{bytes} bytes for {count} objects");
            let middles = boxes_of(&row).map(|bounds| bounds.twice_middle(row.axis));
            assert!(middles.is_sorted());
        }
    }

    #[test]
    fn children_of_the_root_stay_in_a_list_that_their_children_would_overfill() {
        // Eight clusters of 18 objects and eight of 110, far apart, become the children of the root. Each small one
        // gets two children, although its share of the 64 planned ones is little more than one.
        let mut draws = Uniform::new(1);
        let clusters = (0..16).flat_map(|at| vec![at; if at % 2 == 0 { 18 } else { 110 }]);
        let bounds: Vec<_> = clusters
            .map(|at| {
                let low = [100.0 * f64::from(at), 0.0, 0.0].map(|middle| (middle + draws.draw(0.0, 1.0)) as f32);
                Bounds { low, high: low.map(|value| value + 0.1) }
            })
            .collect();
        let items = bounds.iter().copied().zip(0..);
        let mut nodes = build::<ByteBoxes>(bounds.len(), bounds.len(), items, Some(true)).expect("it fits").nodes;
        let grandchildren = |(_, child): (Bounds, Child)| nodes[child.number as usize].children().count();
        let all: usize = nodes[0].children().map(grandchildren).sum();
        assert_eq!((bounds.len(), planned(bounds.len())), (1024, Some(MOST_BOXES)));
        assert!(all > MOST_BOXES, "{all} grandchildren would fit");
        let row = CollapsedRoot::new(&mut nodes, bounds.len()).expect("it fits");
        let count = boxes_of(&row).count();
        assert!((MOST_BOXES - 6..=MOST_BOXES).contains(&count), "{count} boxes");
        let mut reached: Vec<_> =
            row.nodes[..count].iter().flat_map(|&index| objects(&nodes, &nodes[index as usize])).collect();
        reached.sort_unstable();
        assert!(reached.into_iter().eq(0..1024));
    }

    #[test]
    fn boxes_are_taken_from_the_end_that_the_ray_passes_first() {
        let nodes = std::array::from_fn(|place| place as u32 + 1);
        let row = CollapsedRoot { rows: Vec::new(), occupied: 0, nodes, axis: 1 };
        let all = |direction: [f64; 3]| {
            let (mut bits, mut taken) = (1 << 63 | 1 << 17 | 1 << 5 | 1, Vec::new());
            while bits != 0 {
                taken.push(row.take_nearest(&mut bits, row.is_passed_backwards(direction.into())));
            }
            taken
        };
        assert_eq!(all([-1.0, 0.5, -1.0]), [1, 6, 18, 64]);
        assert_eq!(all([1.0, -0.5, 1.0]), [64, 18, 6, 1]);
    }

    #[test]
    fn as_many_are_planned_as_leave_no_level_below_half_empty() {
        assert_eq!([0, 256, 257, 1000, 1024].map(planned), [None, None, Some(17), Some(63), Some(64)]);
        assert_eq!([1025, 4096, 4097, 10_000].map(planned), [None, None, Some(17), Some(40)]);
        assert!(
            (1..2_000_000).step_by(997).filter_map(planned).all(|planned| (WIDTH + 1..=MOST_BOXES).contains(&planned))
        );
    }
}
