//! A node of the tree: the boxes of up to 16 children. A child is another node, a sphere or a cylinder.
//!
//! The traversal of a large scene waits for memory most of the time. So a node has 128 bytes, two cache lines. Each
//! plane of a box is one byte, in the frame of the node. And no index of a child is stored: children of the same kind
//! follow one another, both in the node's lanes and in their list.

use crate::accel::{bounds::Bounds, object::ObjectId};

/// Maximum number of children of a node. It is a multiple of every instruction set's number of `f32` lanes.
pub const WIDTH: usize = 16;

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
}

/// A child of a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Child {
    /// Whether the child is a node or an object.
    pub kind: Kind,
    /// The index of the node, or the number of the object.
    pub number: u32,
}

/// A node of the tree. The children are in the first lanes: nodes first, then spheres, then cylinders.
///
/// The frame of the node divides each axis into steps. The plane with the number `n` is at the coordinate
/// `origin + n step`.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub struct Node {
    /// The lower planes of all boxes for each axis, then the upper planes, as numbers of steps.
    pub planes: [[[u8; WIDTH]; 3]; 2],
    /// For each axis, the coordinate of the plane with the number 0, in scene units.
    pub origin: [f32; 3],
    /// For each kind, the number that the child in lane 0 would have if all lanes had this kind. It wraps around at
    /// 2^32.
    base: [u32; 3],
    /// For each axis, the exponent of the step, as in the bits of an `f32`. A step is a power of two, so a number of
    /// steps is multiplied by it without rounding.
    exponents: [u8; 3],
    /// For each kind, the first lane behind the children of this kind.
    ends: [u8; 3],
}

impl Node {
    /// A node without children.
    pub const EMPTY: Self =
        Self { planes: [[[0; WIDTH]; 3]; 2], origin: [0.0; 3], base: [0; 3], exponents: [1; 3], ends: [0; 3] };

    /// Returns the node with these children: `boxes` are their boxes, ordered by kind. `counts` are the numbers of
    /// children of each kind, and `first` the numbers of the first child of each kind.
    pub fn new(boxes: &[Bounds], counts: [usize; 3], first: [u32; 3]) -> Self {
        let mut node = Self::EMPTY;
        let mut end = 0;
        for kind in Kind::ALL.map(|kind| kind as usize) {
            node.base[kind] = first[kind].wrapping_sub(end);
            end += counts[kind] as u32;
            node.ends[kind] = end as u8;
        }
        let all = boxes.iter().fold(Bounds::EMPTY, |all, bounds| all.union(bounds));
        for axis in 0..3 {
            let origin = f64::from(all.low[axis]);
            // The step is larger than the 255th part of the length, even after this division and conversion.
            let least_step = ((f64::from(all.high[axis]) - origin) / 255.0) as f32;
            node.origin[axis] = all.low[axis];
            node.exponents[axis] = (least_step.to_bits() >> 23) as u8 + 1;
            let steps = 1.0 / f64::from(node.step(axis));
            for (lane, bounds) in boxes.iter().enumerate() {
                // The conversion to an integer rounds down, as no number is negative.
                node.planes[0][axis][lane] = ((f64::from(bounds.low[axis]) - origin) * steps) as u8;
                let high = (f64::from(bounds.high[axis]) - origin) * steps;
                let whole = high as u8;
                node.planes[1][axis][lane] = whole + u8::from(f64::from(whole) < high);
            }
        }
        node
    }

    /// Returns a node with one child.
    pub fn of_child(bounds: Bounds, child: Child) -> Self {
        let counts = Kind::ALL.map(|kind| usize::from(kind == child.kind));
        Self::new(&[bounds], counts, [child.number; 3])
    }

    /// Whether every child is a node.
    pub const fn has_only_nodes(&self) -> bool {
        self.ends[0] == self.ends[2]
    }

    /// Returns the distance between neighbouring planes along an axis, in scene units.
    #[inline(always)]
    pub fn step(&self, axis: usize) -> f32 {
        f32::from_bits(u32::from(self.exponents[axis]) << 23)
    }

    /// Returns a bit for each lane up to the last child of `kind`.
    #[inline(always)]
    const fn lanes_up_to(&self, kind: Kind) -> u32 {
        (1 << self.ends[kind as usize]) - 1
    }

    /// Returns a bit for each lane, which is 1 if the lane has a child.
    #[inline(always)]
    pub const fn occupied(&self) -> u32 {
        self.lanes_up_to(Kind::Cylinder)
    }

    /// Returns a bit for each lane, for each kind in turn. The bit is 1 if the child in this lane has the kind.
    #[inline(always)]
    pub const fn lanes(&self) -> [u32; 3] {
        let (nodes, spheres) = (self.lanes_up_to(Kind::Node), self.lanes_up_to(Kind::Sphere));
        [nodes, spheres ^ nodes, self.occupied() ^ spheres]
    }

    /// Returns the number of the child in a lane, whose kind is `kind`. It is the index of a node or the number of an
    /// object.
    #[inline(always)]
    pub const fn number(&self, kind: Kind, lane: usize) -> u32 {
        self.base[kind as usize].wrapping_add(lane as u32)
    }

    /// Returns a bit for each lane, which is 1 if the child is the object of this kind with the number `id`.
    #[inline(always)]
    pub fn lane_of(&self, kind: Kind, id: ObjectId) -> u32 {
        let lane = id.wrapping_sub(self.base[kind as usize]);
        if lane < WIDTH as u32 { 1 << lane & self.lanes()[kind as usize] } else { 0 }
    }

    /// Returns a bit for each lane, which is 1 if the child's box overlaps the box `bounds`. The test works on whole
    /// steps, so it also finds boxes that are up to a step away.
    pub fn overlaps(&self, bounds: &Bounds) -> u32 {
        let mut overlaps = [1_u8; WIDTH];
        for axis in 0..3 {
            let steps = |plane: f32| (f64::from(plane) - f64::from(self.origin[axis])) / f64::from(self.step(axis));
            // The conversion to an integer rounds down and saturates.
            let (low, high) = (steps(bounds.low[axis]) as u8, (steps(bounds.high[axis]) as u8).saturating_add(1));
            let [lows, highs] = &self.planes;
            for (lane, overlaps) in overlaps.iter_mut().enumerate() {
                *overlaps &= u8::from(lows[axis][lane] <= high) & u8::from(low <= highs[axis][lane]);
            }
        }
        // The product has the lowest bits of all eight bytes in its highest byte, the first byte's lowest.
        let halves = overlaps.as_chunks::<8>().0;
        let [first, second] = [0, 1].map(|at| u64::from_le_bytes(halves[at]).wrapping_mul(0x0102_0408_1020_4080) >> 56);
        (first | second << 8) as u32 & self.occupied()
    }

    /// Returns the box in a lane. It contains the box that was given to [`Node::new`].
    fn bounds(&self, lane: usize) -> Bounds {
        let plane = |side: usize, axis: usize| {
            f64::from(self.origin[axis]) + f64::from(self.step(axis)) * f64::from(self.planes[side][axis][lane])
        };
        Bounds {
            low: [0, 1, 2].map(|axis| (plane(0, axis) as f32).next_down()),
            high: [0, 1, 2].map(|axis| (plane(1, axis) as f32).next_up()),
        }
    }

    /// Returns the children with their boxes.
    pub fn children(&self) -> impl Iterator<Item = (Bounds, Child)> {
        let kind = |lane| {
            if lane < self.ends[0] {
                Kind::Node
            } else if lane < self.ends[1] {
                Kind::Sphere
            } else {
                Kind::Cylinder
            }
        };
        (0..self.ends[2]).map(move |lane| {
            let (kind, lane) = (kind(lane), usize::from(lane));
            (self.bounds(lane), Child { kind, number: self.number(kind, lane) })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sampling::uniform::Uniform;

    #[test]
    fn a_node_has_two_cache_lines() {
        assert_eq!((size_of::<Node>(), align_of::<Node>()), (128, 64));
    }

    #[test]
    fn a_box_contains_the_box_that_was_given_and_is_hardly_larger() {
        let mut draws = Uniform::new(3);
        for number in 0..2000 {
            let scale = 10.0_f64.powf(draws.draw(-5.0, 9.0));
            let offset = if number % 2 == 0 { 0.0 } else { draws.draw(-1e9, 1e9) };
            let boxes: Vec<_> = (0..1 + number % WIDTH)
                .map(|_| {
                    let low = [(); 3].map(|()| (offset + draws.draw(-scale, scale)) as f32);
                    Bounds { low, high: low.map(|low| low + draws.draw(0.0, scale) as f32) }
                })
                .collect();
            let all = boxes.iter().fold(Bounds::EMPTY, |all, bounds| all.union(bounds));
            let node = Node::new(&boxes, [0, boxes.len(), 0], [0, 40, 0]);
            assert_eq!(node.children().count(), boxes.len());
            for ((actual, child), (lane, given)) in node.children().zip(boxes.iter().enumerate()) {
                assert_eq!(child, Child { kind: Kind::Sphere, number: 40 + lane as u32 });
                for axis in 0..3 {
                    let most = f64::from(all.high[axis]) - f64::from(all.low[axis]);
                    let rounding =
                        3.0 * f64::from(f32::EPSILON) * f64::from(all.low[axis].abs().max(all.high[axis].abs()));
                    let outside = [
                        f64::from(given.low[axis]) - f64::from(actual.low[axis]),
                        f64::from(actual.high[axis]) - f64::from(given.high[axis]),
                    ];
                    for distance in outside {
                        assert!(distance > 0.0 && distance <= most / 127.0 + rounding, "{given:?} in {actual:?}");
                    }
                }
            }
        }
    }

    #[test]
    fn the_children_of_each_kind_follow_one_another() {
        let boxes = [Bounds { low: [0.0; 3], high: [1.0; 3] }; 9];
        let node = Node::new(&boxes, [2, 3, 4], [7, 0, u32::MAX - 9]);
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
