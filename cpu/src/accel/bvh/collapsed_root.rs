//! The two highest levels of the tree in one row of boxes, for lanes that test 16 boxes at once.
//!
//! A traversal waits for one node after the other: which it goes on to is known at the end of some sixty cycles. With
//! 512 bits a handful of nodes side by side take hardly longer than one, so a level less is worth several nodes more at
//! its beginning. With 256 bits it is not, by measurement (docs/experiments.md).

use crate::accel::bounds::Bounds;
use crate::accel::bvh::node::{Child, Node, WIDTH};
use crate::accel::bvh::slab_ray::SlabRay;
use crate::accel::object::room;
use crate::counters::{Counter, add};
use crate::input::error::Error;
use crate::math::vec3::Vec3;
use crate::simd::SimdF32;

/// Most children of the root's children: a bit each in a word.
pub const MOST: usize = 64;

/// How many children the root's children are to have together for all levels below them to be full, where the root's
/// own children can be full too.
pub fn planned(objects: usize) -> Option<usize> {
    let mut nodes = objects.div_ceil(WIDTH);
    while nodes > MOST {
        nodes = nodes.div_ceil(WIDTH);
    }
    (nodes > WIDTH).then_some(nodes)
}

/// The row: the children of the root's children, and those of the root's children that have objects themselves, sorted
/// along an axis.
#[derive(Debug)]
pub struct CollapsedRoot {
    /// 16 boxes each; none where there would be more than [`MOST`], or one node.
    rows: Vec<Node>,
    /// Where in the tree the nodes stand that they lead to, side by side: so none has to be looked up. Where there is
    /// no row, the root's place.
    begin: usize,
    /// The axis.
    axis: usize,
}

impl CollapsedRoot {
    /// The row of a tree.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`].
    pub fn new(nodes: &mut Vec<Node>) -> Result<Self, Error> {
        let out_of_memory = |_| Error::OutOfMemory { what: "the hierarchy over the objects" };
        let mut boxes = Vec::new();
        boxes.try_reserve(WIDTH * WIDTH).map_err(out_of_memory)?;
        for (bounds, child) in nodes.first().into_iter().flat_map(Node::children) {
            match child.as_object().is_none().then(|| &nodes[child.as_node() as usize]) {
                Some(node) if node.objects == 0 => boxes.extend(node.children()),
                _ => boxes.push((bounds, child)),
            }
        }
        let all = boxes.iter().fold(Bounds::EMPTY, |all, (bounds, _)| all.union(bounds));
        let mut top = Self { rows: Vec::new(), begin: 0, axis: all.longest_axis() };
        if !(WIDTH + 1..=MOST).contains(&boxes.len()) {
            return Ok(top);
        }
        let middle = |(bounds, _): &(Bounds, Child)| bounds.twice_middle(top.axis);
        boxes.sort_unstable_by(|left, right| middle(left).total_cmp(&middle(right)));
        top.rows.try_reserve(MOST / WIDTH).map_err(out_of_memory)?;
        top.rows.resize(boxes.len().div_ceil(WIDTH), Node::EMPTY);
        let mut below = Vec::new();
        below.try_reserve(MOST).map_err(out_of_memory)?;
        top.begin = 1;
        for (place, (bounds, mut child)) in boxes.into_iter().enumerate() {
            if child.as_object().is_some() {
                let mut alone = Node::EMPTY;
                alone.set(0, &bounds, child);
                child = Child::node(nodes.len() as u32);
                nodes.try_reserve(1).map_err(out_of_memory)?;
                nodes.push(alone);
            }
            below.push(child.as_node());
            top.rows[place / WIDTH].set(place % WIDTH, &bounds, Child::node((top.begin + place) as u32));
        }
        bring_forward(nodes, &below)?;
        Ok(top)
    }

    /// The boxes that a ray meets within `farthest`, as bits; one for the root, whose box is not asked, where there is
    /// no row.
    #[inline(always)]
    pub fn met<F: SimdF32>(&self, box_ray: &SlabRay<F>, farthest: f32) -> u64 {
        add(Counter::NodeVisits, self.rows.len() as u64);
        let mut bits = u64::from(self.rows.is_empty());
        for (place, row) in self.rows.iter().enumerate().take(MOST / WIDTH) {
            let (_, met) = box_ray.meets(row, 0, F::splat(farthest));
            bits |= u64::from(met) << (place * WIDTH);
        }
        bits
    }

    /// Whether a ray along `direction` goes along the row from its end.
    #[inline(always)]
    pub fn is_passed_backwards(&self, direction: Vec3) -> bool {
        let along = match self.axis {
            0 => direction.x,
            1 => direction.y,
            _ => direction.z,
        };
        along < 0.0
    }

    /// Takes the first of the boxes met, or the last, out of `bits`, which are not 0: where the node stands that it
    /// leads to.
    #[inline(always)]
    pub fn take(&self, bits: &mut u64, backwards: bool) -> usize {
        let (first, last) = (bits.trailing_zeros(), 63 - bits.leading_zeros());
        let place = if backwards { last } else { first };
        *bits ^= 1 << place;
        self.begin + place as usize
    }

    /// Its boxes.
    #[cfg(test)]
    fn children(&self) -> impl Iterator<Item = (Bounds, Child)> {
        self.rows.iter().flat_map(Node::children)
    }
}

/// Puts the nodes at these places, none of them the root, side by side behind the root, which stays.
fn bring_forward(nodes: &mut [Node], places: &[u32]) -> Result<(), Error> {
    // Which node stands at a place, and at which place a node, by where they stood before.
    let [mut at, mut place_of] = [room(nodes.len())?, room(nodes.len())?];
    for list in [&mut at, &mut place_of] {
        list.extend(0..nodes.len() as u32);
    }
    for (to, &node) in (1..).zip(places) {
        let from = place_of[node as usize] as usize;
        let other = at[to];
        nodes.swap(to, from);
        at.swap(to, from);
        place_of[node as usize] = to as u32;
        place_of[other as usize] = from as u32;
    }
    for node in nodes {
        node.relink(|index| place_of[index as usize]);
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accel::bvh::build::build;
    use crate::sampling::uniform::Uniform;

    /// The objects below a node.
    fn objects(nodes: &[Node], node: &Node) -> Vec<u32> {
        let of_child = |child: Child| match child.as_object() {
            Some(id) => vec![id],
            None => objects(nodes, &nodes[child.as_node() as usize]),
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
            let mut nodes = build(count, bounds).expect("it fits");
            let top = CollapsedRoot::new(&mut nodes).expect("it fits");
            let children = top.children().count();
            if let Some(planned) = planned(count) {
                assert!(
                    (planned / 2..=planned.max(2 * WIDTH)).contains(&children),
                    "{children} children, {planned} planned"
                );
            }
            let in_row = |child: Child| objects(&nodes, &nodes[child.as_node() as usize]);
            let mut found: Vec<_> = top.children().flat_map(|(_, child)| in_row(child)).collect();
            found.sort_unstable();
            // Where there is no plan, there may be too many for a row.
            let expected = if planned(count).is_some() || children > 0 { 0..count as u32 } else { 0..0 };
            let places = top.children().map(|(_, child)| child.as_node() as usize);
            assert!(places.eq(top.begin..top.begin + children));
            assert_eq!(top.begin, usize::from(children > 0));
            assert!(found.into_iter().eq(expected), "{count} objects");
            assert!(count != 20_000 || children == 0);
            assert!(top.rows.iter().all(|row| row.objects == 0));
            let bytes = (nodes.len() + top.rows.len()) * size_of::<Node>();
            assert!(count <= 256 || bytes < 100 * count, "{bytes} bytes for {count} objects");
            let middles = top.children().map(|(bounds, _)| bounds.twice_middle(top.axis));
            assert!(middles.is_sorted());
        }
    }

    #[test]
    fn boxes_are_taken_from_the_end_that_the_ray_comes_from() {
        let top = CollapsedRoot { rows: Vec::new(), begin: 1, axis: 1 };
        let all = |direction: [f64; 3]| {
            let (mut bits, mut taken) = (1 << 63 | 1 << 17 | 1 << 5 | 1, Vec::new());
            while bits != 0 {
                taken.push(top.take(&mut bits, top.is_passed_backwards(direction.into())));
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
        assert!((1..2_000_000).step_by(997).filter_map(planned).all(|planned| (WIDTH + 1..=MOST).contains(&planned)));
    }
}
