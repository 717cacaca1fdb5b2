//! A hierarchy of boxes over the objects of a picture, for `shaders/wgsl/hierarchy.wgsl`. With it a device renders
//! large scenes, and every pixel keeps its bits.

mod build;
mod margins;

use cpu::internals::accel::bounds::Bounds;

use crate::packed::Packed;
use crate::{Float, Picture};
use build::{Item, build};
use margins::{Growth, Margins};

/// Number of objects from which on `shader-lab` and the page render in a hierarchy. On lavapipe `scenes/grid`, with
/// 101 objects, is rendered faster in it.
pub const WORTHWHILE: usize = 64;

/// An object is dominant if its box is this many times larger than that of the median object.
const DOMINANT: f32 = 64.0;
/// Largest number of dominant objects.
const MOST_DOMINANT: usize = 8;

/// A plane is moved outward by at least this factor of the tree's farthest plane; see `STEP` in `hierarchy.wgsl`.
const STEP: f32 = 1.907_348_6e-6;
/// The smallest distance by which a plane is moved, in scene units.
const LEAST_STEP: f32 = 1e-10;
/// Size in bytes of the structure `Hierarchy` in `hierarchy.wgsl` without its nodes, and of a node.
const HEAD: usize = 28;
const NODE: usize = 40;
/// The value of [`Node::object`] for a node that is not a leaf.
const NO_OBJECT: u32 = u32::MAX;

/// A node in the form of `hierarchy.wgsl`: a box around one object, or around all objects of the nodes below it.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Node {
    bounds: Bounds,
    /// The largest [`Growth`] of the objects in the box.
    growth: Growth,
    /// The index of the first node that is not below this one.
    next: u32,
    /// [`NO_OBJECT`], or twice the index of a sphere, or twice the index of a cylinder plus one.
    object: u32,
}

/// A hierarchy over the objects of a picture: the dominant objects, and a tree over all others.
///
/// Without the distinction, a huge ground sphere would make the steps of all planes large, because these depend on the
/// tree's farthest plane. A ray intersects the dominant objects first, so the tree is searched only up to their lambda.
#[derive(Clone, Debug)]
pub struct Hierarchy {
    margins: Margins,
    steps: [f32; 3],
    /// The dominant objects' nodes, and then the tree's nodes.
    nodes: Vec<Node>,
    /// Number of dominant objects.
    dominant: usize,
}

impl Hierarchy {
    /// Builds the hierarchy over the objects of `picture`, with the margins of the precision `T`.
    #[must_use]
    pub fn new<T: Float>(picture: &Picture<T>) -> Self {
        let mut margins = Margins::new(T::PRECISION);
        let spheres = picture.spheres.iter().zip(0..).map(|(placed, index): (_, u32)| {
            let (bounds, growth) = margins.of_sphere(&placed.record);
            Item { bounds, growth, object: 2 * index }
        });
        let cylinders = picture.cylinders.iter().zip(0..).map(|(placed, index): (_, u32)| {
            let (bounds, growth) = margins.of_cylinder(&placed.record);
            Item { bounds, growth, object: 2 * index + 1 }
        });
        let mut items: Vec<_> = spheres.chain(cylinders).collect();
        let smallest = picture.spheres.iter().map(|placed| placed.record.radius);
        let smallest = smallest.chain(picture.cylinders.iter().map(|placed| placed.record.radius));
        let smallest = smallest.map(Float::wide).fold(f64::INFINITY, f64::min);
        let dominant = move_dominant_to_front(&mut items);
        let (first, others) = items.split_at_mut(dominant);
        let nodes = build(first, others, picture.camera.position.map(Float::wide));
        let all = nodes.get(dominant).map_or(Bounds::EMPTY, |root| root.bounds);
        let farthest = |axis: usize| all.low[axis].abs().max(all.high[axis].abs());
        margins.limit((0..3).map(farthest).fold(0.0, f32::max), smallest);
        let steps = [0, 1, 2].map(|axis| farthest(axis) * STEP + LEAST_STEP);
        Self { margins, steps, nodes, dominant }
    }

    /// Returns the number of nodes, which is less than twice the number of objects.
    #[must_use]
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    /// Whether there is no object.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }

    /// Returns the bytes of the structure `Hierarchy` in `hierarchy.wgsl`.
    #[must_use]
    pub fn bytes(&self) -> Vec<u8> {
        let mut bytes = Vec::with_capacity(HEAD + NODE * self.nodes.len().max(1));
        [self.margins.point, self.margins.largest][..].pack(&mut bytes);
        self.steps[..].pack(&mut bytes);
        [self.nodes.len() as u32, self.dominant as u32].iter().for_each(|count| count.pack(&mut bytes));
        for node in &self.nodes {
            node.bounds.low[..].pack(&mut bytes);
            node.bounds.high[..].pack(&mut bytes);
            [node.growth.linear, node.growth.bend][..].pack(&mut bytes);
            node.next.pack(&mut bytes);
            node.object.pack(&mut bytes);
        }
        // The array of nodes must not be empty.
        bytes.resize(bytes.len().max(HEAD + NODE), 0);
        bytes
    }
}

/// Moves the dominant objects to the front, the largest one first, and returns their number.
fn move_dominant_to_front(items: &mut [Item]) -> usize {
    if items.is_empty() {
        return 0;
    }
    let size = |item: &Item| item.bounds.high[item.bounds.longest_axis()] - item.bounds.low[item.bounds.longest_axis()];
    let middle = items.len() / 2;
    let larger_first = |one: &Item, other: &Item| size(other).total_cmp(&size(one));
    let median = size(items.select_nth_unstable_by(middle, larger_first).1);
    let largest = MOST_DOMINANT.min(middle);
    if largest > 0 {
        items.select_nth_unstable_by(largest, larger_first);
    }
    items[..largest].sort_unstable_by(larger_first);
    items[..largest].iter().take_while(|item| size(item) > DOMINANT * median).count()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_node_holds_all_nodes_below_it_and_every_object_is_a_leaf_once() {
        for count in [1, 2, 3, 9, 64, 500] {
            let mut text = String::from("matte: m .5 .5 .5\n");
            for number in 0..count {
                let [x, y, size] =
                    [number * 7919 % 101, number * 104_729 % 53, 1 + number * 31 % 17 * (number * 5 % 13)];
                text += &match number % 3 {
                    0 => format!("cylinder: {x} {y} 0 {size} 0 {size} 1 m\n"),
                    _ => format!("sphere: {x} {y} {size} {size} m\n"),
                };
            }
            let scene = cpu::Scene::parse(text.as_bytes()).expect("it is valid");
            let picture = Picture::<f32>::new(&cpu::Config::default(), &scene).expect("it is valid");
            let hierarchy = Hierarchy::new(&picture);
            let nodes = &hierarchy.nodes;
            let mut objects: Vec<_> =
                nodes.iter().map(|node| node.object).filter(|&object| object != NO_OBJECT).collect();
            objects.sort_unstable();
            let spheres = (0..picture.spheres.len() as u32).map(|index| 2 * index);
            let mut expected: Vec<_> =
                spheres.chain((0..picture.cylinders.len() as u32).map(|index| 2 * index + 1)).collect();
            expected.sort_unstable();
            assert_eq!(objects, expected);
            let tree = hierarchy.dominant;
            assert!(nodes.get(tree).is_none_or(|root| root.next as usize == nodes.len()));
            for (index, node) in nodes.iter().enumerate() {
                assert!(index >= tree || (node.next as usize == index + 1 && node.object != NO_OBJECT));
                for below in &nodes[index + 1..node.next as usize] {
                    assert_eq!(node.bounds.union(&below.bounds), node.bounds);
                    assert!(below.growth.bend <= node.growth.bend && below.growth.linear <= node.growth.linear);
                    assert!(below.next <= node.next);
                }
            }
            assert_eq!(hierarchy.bytes().len(), HEAD + NODE * nodes.len());
        }
    }

    #[test]
    fn a_ground_sphere_is_dominant_and_does_not_move_the_planes() {
        let mut text = String::from("matte: m .5 .5 .5\n");
        for number in 0..100 {
            text.push_str(&format!("sphere: {number} 0 0 .5 m\n"));
        }
        let steps = |text: &str| {
            let scene = cpu::Scene::parse(text.as_bytes()).expect("it is valid");
            let picture = Picture::<f32>::new(&cpu::Config::default(), &scene).expect("it is valid");
            let hierarchy = Hierarchy::new(&picture);
            (hierarchy.dominant, hierarchy.steps)
        };
        let (none, without) = steps(&text);
        let (one, with) = steps(&format!("{text}sphere: 0 -100000 0 99999 m\n"));
        assert_eq!((none, one), (0, 1));
        assert_eq!(without, with);
    }
}
