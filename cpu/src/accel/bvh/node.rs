//! A node of the tree: up to 16 children with their boxes. A child is another node, a sphere or a cylinder.
//!
//! A node stores one number for each kind of child, and not one for each child: children of the same kind follow one
//! another, both in the node's lanes and in their list. So a node with [byte
//! boxes](crate::accel::bvh::byte_boxes::ByteBoxes) has 128 bytes, two cache lines.

use crate::accel::{
    bounds::Bounds, bvh::boxes::Boxes, bvh::planes::WIDTH, bvh::sphere_leaf::SphereLeaf, object::ObjectId,
    object::ObjectRef,
};
use crate::simd::SimdF32;

/// The words for the tree in the message of [`Error::OutOfMemory`](crate::input::error::Error::OutOfMemory).
pub const HIERARCHY: &str = "the hierarchy over the objects";

/// The kinds of children, in the order of the lanes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Another node of the tree.
    Node,
    /// A sphere.
    Sphere,
    /// A cylinder.
    Cylinder,
}

impl Kind {
    /// All kinds, in the order of the lanes.
    pub const ALL: [Self; 3] = [Self::Node, Self::Sphere, Self::Cylinder];

    /// Returns the kind of an object.
    #[inline(always)]
    pub(crate) const fn of(object: ObjectRef) -> Self {
        match object {
            ObjectRef::Sphere(_) => Self::Sphere,
            ObjectRef::Cylinder(_) => Self::Cylinder,
        }
    }
}

/// A child of a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Child {
    /// Whether the child is a node or an object.
    pub kind: Kind,
    /// The index of the node, or the number of the object.
    pub number: u32,
}

/// A node of the tree, with up to 16 children. Lane `i` holds child `i`. The children are sorted by their kind: nodes,
/// then spheres, then cylinders.
#[derive(Clone, Debug)]
#[repr(C, align(64))]
pub struct Node<B> {
    /// The boxes of the children. If `has_bounding_spheres` is set, their bounding spheres are stored here instead.
    pub boxes: B,
    /// For each kind, the number that the child in lane 0 would have if all lanes had this kind. It wraps around at
    /// 2^32.
    base: [u32; 3],
    /// For each kind, the first lane behind the children of this kind.
    ends: [u8; 3],
    /// Whether `boxes` holds bounding spheres.
    has_bounding_spheres: bool,
}

impl<B: Boxes> Node<B> {
    /// A node without children.
    pub const EMPTY: Self = Self { boxes: B::EMPTY, base: [0; 3], ends: [0; 3], has_bounding_spheres: false };

    /// Returns the node with these children: `boxes` are their boxes, ordered by kind. `counts` says how many
    /// children of each kind there are, and `first` has the [number](Child::number) of the first child of each kind.
    pub(crate) fn new(boxes: &[Bounds], counts: [usize; 3], first: [u32; 3]) -> Self {
        Self::with_bounds(B::new(boxes), counts, first)
    }

    /// Returns the node whose children are spheres with these boxes. It holds their bounding spheres. `first` is the
    /// number of the first sphere.
    pub(crate) fn of_spheres(boxes: &[Bounds], first: u32) -> Self {
        let node = Self::with_bounds(B::of_spheres(boxes), [0, boxes.len(), 0], [first; 3]);
        Self { has_bounding_spheres: true, ..node }
    }

    /// Returns a node with `counts` children of each kind in the lanes of `boxes`. `first` has the first number of each
    /// kind.
    fn with_bounds(boxes: B, counts: [usize; 3], first: [u32; 3]) -> Self {
        debug_assert!(counts.iter().sum::<usize>() <= WIDTH);
        let mut node = Self { boxes, ..Self::EMPTY };
        let mut end = 0;
        for kind in Kind::ALL.map(|kind| kind as usize) {
            node.base[kind] = first[kind].wrapping_sub(end);
            end += counts[kind] as u32;
            node.ends[kind] = end as u8;
        }
        node
    }

    /// Returns a node with one child.
    pub(crate) fn of_child(bounds: Bounds, child: Child) -> Self {
        let counts = Kind::ALL.map(|kind| usize::from(kind == child.kind));
        Self::new(&[bounds], counts, [child.number; 3])
    }

    /// Returns the bounding spheres of the children, if this node has them instead of boxes. Then every child is a
    /// sphere.
    #[inline(always)]
    pub(crate) fn bounding_spheres(&self) -> Option<SphereLeaf<'_, B::Number>> {
        self.has_bounding_spheres.then(|| self.boxes.bounding_spheres())
    }

    /// Returns 16 bits. Bit `i` is 1 if the box or the bounding sphere of child `i` overlaps `bounds`. It may also be 1
    /// if the two are near each other. If there are fewer children, the caller must ignore the other bits.
    #[inline(always)]
    pub(crate) fn overlaps<F: SimdF32>(&self, bounds: &Bounds) -> u32 {
        match self.bounding_spheres() {
            Some(spheres) => spheres.overlaps::<F>(bounds),
            None => self.boxes.overlaps::<F>(bounds),
        }
    }

    /// Whether every child is a node.
    pub(crate) const fn has_only_nodes(&self) -> bool {
        self.ends[0] == self.ends[2]
    }

    /// Returns a bit for each lane up to the last child of `kind`.
    #[inline(always)]
    const fn lanes_up_to(&self, kind: Kind) -> u32 {
        (1 << self.ends[kind as usize]) - 1
    }

    /// Returns a bit for each lane, which is 1 if the lane has a child.
    #[inline(always)]
    pub(crate) const fn occupied(&self) -> u32 {
        self.lanes_up_to(Kind::Cylinder)
    }

    /// Returns a bit for each lane, for each kind in turn. The bit is 1 if the child in this lane has the kind.
    #[inline(always)]
    pub(crate) const fn lanes(&self) -> [u32; 3] {
        let (nodes, spheres) = (self.lanes_up_to(Kind::Node), self.lanes_up_to(Kind::Sphere));
        [nodes, spheres ^ nodes, self.occupied() ^ spheres]
    }

    /// Returns the number of the child in a lane, whose kind is `kind`. It is the index of a node or the number of an
    /// object.
    #[inline(always)]
    pub(crate) const fn number(&self, kind: Kind, lane: usize) -> u32 {
        self.base[kind as usize].wrapping_add(lane as u32)
    }

    /// Returns a bit for each lane, which is 1 if the child is the object of this kind with the number `id`.
    #[inline(always)]
    pub(crate) fn lane_of(&self, kind: Kind, id: ObjectId) -> u32 {
        let lane = id.wrapping_sub(self.base[kind as usize]);
        if lane < WIDTH as u32 { 1 << lane & self.lanes()[kind as usize] } else { 0 }
    }

    /// Returns the children with their boxes.
    pub(crate) fn children(&self) -> impl Iterator<Item = (Bounds, Child)> {
        let kind = |lane| {
            if lane < self.ends[0] {
                Kind::Node
            } else if lane < self.ends[1] {
                Kind::Sphere
            } else {
                Kind::Cylinder
            }
        };
        let spheres = self.bounding_spheres();
        (0..self.ends[2]).map(move |lane| {
            let (kind, lane) = (kind(lane), usize::from(lane));
            let bounds = match &spheres {
                Some(spheres) => spheres.bounds(lane),
                None => self.boxes.bounds(lane),
            };
            (bounds, Child { kind, number: self.number(kind, lane) })
        })
    }
}

/// Returns the lanes whose bits are 1, from the lowest. Only the 16 lowest bits may be 1, so the remainder by [`WIDTH`]
/// does not change a lane. It tells the compiler that each lane is below [`WIDTH`], and so a valid index.
#[inline(always)]
pub(crate) fn lanes_in(mut bits: u32) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let lane = (bits != 0).then(|| bits.trailing_zeros() as usize % WIDTH);
        bits &= bits.wrapping_sub(1);
        lane
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accel::bvh::{boxes::FloatBoxes, byte_boxes::ByteBoxes};

    #[test]
    fn a_node_of_bytes_has_two_cache_lines() {
        assert_eq!([size_of::<Node<ByteBoxes>>(), size_of::<Node<FloatBoxes>>()], [128, 448]);
        assert_eq!([align_of::<Node<ByteBoxes>>(), align_of::<Node<FloatBoxes>>()], [64, 64]);
    }

    #[test]
    fn the_children_of_each_kind_follow_one_another() {
        let boxes = [Bounds { low: [0.0; 3], high: [1.0; 3] }; 9];
        let node = Node::<FloatBoxes>::new(&boxes, [2, 3, 4], [7, 0, u32::MAX - 9]);
        assert_eq!(node.lanes(), [0b11, 0b11100, 0b1_1110_0000]);
        let children: Vec<_> = node.children().map(|(_, Child { kind, number })| (kind, number)).collect();
        assert_eq!(children[..3], [(Kind::Node, 7), (Kind::Node, 8), (Kind::Sphere, 0)]);
        assert_eq!(children[4..6], [(Kind::Sphere, 2), (Kind::Cylinder, u32::MAX - 9)]);
        for (kind, first, last) in [(Kind::Sphere, 0, 2), (Kind::Cylinder, u32::MAX - 9, u32::MAX - 6)] {
            let lanes = (first..=last).fold(0, |lanes, id| lanes | node.lane_of(kind, id));
            assert_eq!(lanes, node.lanes()[kind as usize]);
            assert_eq!([first.wrapping_sub(1), last + 1, u32::MAX].map(|id| node.lane_of(kind, id)), [0; 3]);
        }
    }
}
