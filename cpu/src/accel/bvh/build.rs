//! Builds the tree from the top down. The surface area heuristic (SAH) over bins chooses binary splits (Wald, "On fast
//! construction of SAH-based bounding volume hierarchies", 2007). A node gathers up to 16 children.

mod item;
mod split;

use crate::accel::bvh::build::item::{Item, ItemRange};
use crate::accel::bvh::build::split::{dissolve_small_children, split_into_children};
use crate::accel::bvh::{
    boxes::Boxes, collapsed_root, node::HIERARCHY, node::Kind, node::Node, planes::WIDTH, sphere_leaf,
};
use crate::accel::{bounds::Bounds, object::ObjectId, object::ObjectRef};
use crate::{input::error::Error, input::error::push, layout::with_room};

/// The tree over the objects of a scene.
#[derive(Debug)]
pub struct Tree<B> {
    /// The nodes, the root first.
    pub nodes: Vec<Node<B>>,
    /// The old number of each sphere of the tree. The sphere's new number is its index in this list.
    pub spheres: Vec<ObjectId>,
    /// The old number of each cylinder. The cylinder's new number is its index in this list plus the number of all
    /// spheres of the scene.
    pub cylinders: Vec<ObjectId>,
    /// Whether nodes with only spheres are sphere leaves.
    pub has_sphere_leaves: bool,
}

/// Builds the tree over `objects`, which are at most `most` pairs of a box and an object's number. The first
/// `sphere_count` numbers belong to spheres. Objects get new numbers, so that those in one node follow one another.
/// `sphere_leaves` says whether the tree has sphere leaves; `None` leaves this to [`sphere_leaf::save_time`].
///
/// # Errors
/// [`Error::OutOfMemory`] if memory is short.
pub(crate) fn build<B: Boxes>(
    most: usize,
    sphere_count: usize,
    objects: impl Iterator<Item = (Bounds, ObjectId)>,
    sphere_leaves: Option<bool>,
) -> Result<Tree<B>, Error> {
    let mut items = with_room(most, HIERARCHY)?;
    items.extend(objects.map(|(bounds, id)| Item::new(&bounds, id)));
    debug_assert!(items.len() <= most);
    let (spheres, cylinders) = (with_room(sphere_count, HIERARCHY)?, with_room(most - sphere_count, HIERARCHY)?);
    // A node has about eight objects, by measurement (bench/src/bin/nearest.rs). The list grows if there are more.
    let nodes = with_room(most / 8 + 1, HIERARCHY)?;
    let all = ItemRange::new(&items, 0, items.len());
    let half_areas = items.iter().map(|item| f64::from(item.bounds().unpacked().half_area()));
    let only_spheres = items.iter().all(|item| (item.id() as usize) < sphere_count);
    let has_sphere_leaves = sphere_leaves
        .unwrap_or_else(|| sphere_leaf::save_time(only_spheres, half_areas.sum(), all.bounds.unpacked().half_area()));
    let mut tree = Tree { nodes, spheres, cylinders, has_sphere_leaves };
    push(&mut tree.nodes, Node::EMPTY, HIERARCHY)?;
    if items.is_empty() {
        return Ok(tree);
    }
    // If there will be a collapsed root, the nodes of the two highest levels keep their children. Below them, small
    // children are dissolved to fill free lanes.
    let planned = collapsed_root::planned(items.len());
    // The nodes that are not filled yet: index, range of items and depth.
    let mut pending = Vec::new();
    push(&mut pending, (0, all, 0), HIERARCHY)?;
    while let Some((index, range, depth)) = pending.pop() {
        let most = match planned {
            Some(planned) if depth == 1 => {
                // Each child of the root gets a share of the planned number, by its number of items.
                let part = |end: usize| planned * end / items.len();
                (part(range.to) - part(range.from)).clamp(2, WIDTH)
            }
            _ => WIDTH,
        };
        let mut children = [range; WIDTH];
        let count = if range.count() <= WIDTH {
            for (child, at) in children.iter_mut().zip(range.from..range.to) {
                *child = ItemRange::new(&items, at, at + 1);
            }
            range.count()
        } else {
            let count = split_into_children(&mut items, &mut children[..most], depth);
            if planned.is_some() && depth < 2 { count } else { dissolve_small_children(&items, &mut children, count) }
        };
        let kind_of = |child: &ItemRange| match child.only_item(&items) {
            None => Kind::Node,
            Some(item) => Kind::of(ObjectRef::of_number(item.id(), sphere_count)),
        };
        let first = [tree.nodes.len(), tree.spheres.len(), sphere_count + tree.cylinders.len()];
        let (mut boxes, mut end, mut counts) = ([Bounds::EMPTY; WIDTH], 0, [0; 3]);
        for kind in Kind::ALL {
            for child in children[..count].iter().filter(|child| kind_of(child) == kind) {
                boxes[end] = child.bounds.unpacked();
                end += 1;
                counts[kind as usize] += 1;
                match (kind, child.only_item(&items)) {
                    (Kind::Sphere, Some(item)) => push(&mut tree.spheres, item.id(), HIERARCHY)?,
                    (Kind::Cylinder, Some(item)) => push(&mut tree.cylinders, item.id(), HIERARCHY)?,
                    _ => {
                        push(&mut pending, (tree.nodes.len(), *child, depth + 1), HIERARCHY)?;
                        push(&mut tree.nodes, Node::EMPTY, HIERARCHY)?;
                    }
                }
            }
        }
        let (boxes, first) = (&boxes[..count], first.map(|number| number as u32));
        tree.nodes[index] = if has_sphere_leaves && counts[Kind::Sphere as usize] == count {
            Node::of_spheres(boxes, first[Kind::Sphere as usize])
        } else {
            Node::new(boxes, counts, first)
        };
    }
    Ok(tree)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accel::bvh::byte_boxes::ByteBoxes;
    use crate::sampling::uniform::Uniform;

    /// Checks that every object is in the tree once, inside all boxes above it. Two thirds of the objects are spheres.
    /// Returns the depth of the tree.
    fn check(tree: &Tree<ByteBoxes>, bounds: &[Bounds]) -> u32 {
        let mut seen = vec![false; bounds.len()];
        let mut deepest = 0;
        let everything = Bounds { low: [f32::MIN; 3], high: [f32::MAX; 3] };
        let mut pending = vec![(0_usize, vec![everything], 1)];
        while let Some((node, outer, depth)) = pending.pop() {
            deepest = deepest.max(depth);
            for (inner, child) in tree.nodes[node].children() {
                let within = |bounds: &Bounds| {
                    for outer in outer.iter().chain([&inner]) {
                        for axis in 0..3 {
                            assert!(bounds.low[axis] >= outer.low[axis] && bounds.high[axis] <= outer.high[axis]);
                        }
                    }
                };
                let number = child.number as usize;
                let id = match child.kind {
                    Kind::Node => {
                        pending.push((number, outer.iter().copied().chain([inner]).collect(), depth + 1));
                        continue;
                    }
                    Kind::Sphere => tree.spheres[number],
                    Kind::Cylinder => tree.cylinders[number - spheres(bounds.len())],
                };
                assert_eq!((id as usize) < spheres(bounds.len()), child.kind == Kind::Sphere);
                within(&bounds[id as usize]);
                assert!(!std::mem::replace(&mut seen[id as usize], true), "object {id} is there twice");
            }
        }
        assert!(seen.iter().all(|&seen| seen), "an object is lost");
        deepest
    }

    /// Returns the number of spheres among `count` objects.
    const fn spheres(count: usize) -> usize {
        count * 2 / 3
    }

    fn random(count: usize, size: f64) -> Vec<Bounds> {
        let mut draws = Uniform::new(count as u64 + 1);
        let mut one = || {
            let low = [(); 3].map(|()| draws.draw(-10.0, 10.0) as f32);
            Bounds { low, high: low.map(|value| value + size as f32) }
        };
        (0..count).map(|_| one()).collect()
    }

    fn build_all(bounds: &[Bounds]) -> Tree<ByteBoxes> {
        build(bounds.len(), spheres(bounds.len()), bounds.iter().copied().zip(0..), Some(false)).expect("it fits")
    }

    #[test]
    fn every_object_is_found_once_inside_its_boxes() {
        for count in [0, 1, 2, 15, 16, 17, 33, 100, 1000, 20_000] {
            let bounds = random(count, 0.1);
            let depth = check(&build_all(&bounds), &bounds);
            assert!(depth <= 6, "{count} objects, depth {depth}");
        }
    }

    #[test]
    fn objects_at_one_place_are_split_all_the_same() {
        let bounds = vec![Bounds { low: [1.0; 3], high: [2.0; 3] }; 1000];
        assert!(check(&build_all(&bounds), &bounds) <= 4);
    }

    #[test]
    fn objects_that_shrink_towards_a_point_keep_the_depth_bounded() {
        let at = |step: i32| 2.0_f32.powi(-step);
        let bounds: Vec<_> =
            (0..2000).map(|step| Bounds { low: [at(step % 100); 3], high: [at(step % 100) * 1.01; 3] }).collect();
        assert!(check(&build_all(&bounds), &bounds) <= 20);
    }
}
