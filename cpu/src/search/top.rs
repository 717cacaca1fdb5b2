//! The two highest levels of the tree in one row of boxes, for lanes that test 16 boxes at once.
//!
//! A traversal waits for one node after the other: which it goes on to is known at the end of some sixty cycles. With 512
//! bits a handful of nodes side by side take hardly longer than one, so a level less is worth several nodes more at its
//! beginning. With 256 bits it is not, by measurement (docs/performance.md).

use super::node::{Child, Node, WIDTH};
use crate::error::Error;

/// Most children of the root's children: a bit each in a word.
pub const MOST: usize = 64;

/// How many children the root's children are to have together for all levels below them to be full, where the root's own
/// children can be full too.
pub fn planned(objects: usize) -> Option<usize> {
    let mut nodes = objects.div_ceil(WIDTH);
    while nodes > MOST {
        nodes = nodes.div_ceil(WIDTH);
    }
    (nodes > WIDTH).then_some(nodes)
}

/// The row: the children of the root's children, and those of the root's children that have objects themselves, 16 a
/// node; each leads to a node. Empty where there are more than [`MOST`].
///
/// # Errors
/// [`Error::OutOfMemory`].
pub fn row(nodes: &mut Vec<Node>) -> Result<Vec<Node>, Error> {
    let out_of_memory = |_| Error::OutOfMemory { what: "the hierarchy over the objects" };
    let mut boxes = Vec::new();
    boxes.try_reserve(WIDTH * WIDTH).map_err(out_of_memory)?;
    for (bounds, child) in nodes.first().into_iter().flat_map(Node::children) {
        match child.as_object().is_none().then(|| &nodes[child.as_node() as usize]) {
            Some(node) if node.objects == 0 => boxes.extend(node.children()),
            _ => boxes.push((bounds, child)),
        }
    }
    let mut row = Vec::new();
    if boxes.len() > MOST {
        return Ok(row);
    }
    row.try_reserve(MOST / WIDTH).map_err(out_of_memory)?;
    row.resize(boxes.len().div_ceil(WIDTH), Node::EMPTY);
    for (place, (bounds, mut child)) in boxes.into_iter().enumerate() {
        if child.as_object().is_some() {
            let mut alone = Node::EMPTY;
            alone.set(0, &bounds, child);
            child = Child::node(nodes.len() as u32);
            nodes.try_reserve(1).map_err(out_of_memory)?;
            nodes.push(alone);
        }
        row[place / WIDTH].set(place % WIDTH, &bounds, child);
    }
    Ok(row)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rng::Uniform;
    use crate::search::bounds::Bounds;
    use crate::search::build::build;

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
            let row = row(&mut nodes).expect("it fits");
            let children: usize = row.iter().map(|node| node.children().count()).sum();
            if let Some(planned) = planned(count) {
                assert!(
                    (planned / 2..=planned.max(2 * WIDTH)).contains(&children),
                    "{children} children, {planned} planned"
                );
            }
            let mut found: Vec<_> = row.iter().flat_map(|node| objects(&nodes, node)).collect();
            found.sort_unstable();
            // Where there is no plan, there may be too many for a row.
            let expected = if planned(count).is_some() || children > 0 { 0..count as u32 } else { 0..0 };
            assert!(found.into_iter().eq(expected), "{count} objects");
            assert!(count != 20_000 || children == 0);
            assert!(row.iter().all(|node| node.objects == 0));
        }
    }

    #[test]
    fn as_many_are_planned_as_leave_no_level_below_half_empty() {
        assert_eq!([0, 256, 257, 1000, 1024].map(planned), [None, None, Some(17), Some(63), Some(64)]);
        assert_eq!([1025, 4096, 4097, 10_000].map(planned), [None, None, Some(17), Some(40)]);
        assert!((1..2_000_000).step_by(997).filter_map(planned).all(|planned| (WIDTH + 1..=MOST).contains(&planned)));
    }
}
