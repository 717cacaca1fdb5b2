//! A node of the tree: the boxes of up to 16 children. A child is an object or another node.

use crate::{accel::bounds::Bounds, accel::object::ObjectId, simd::SimdF32};

/// Maximum number of children of a node. It is a multiple of every instruction set's number of `f32` lanes.
pub const WIDTH: usize = 16;

/// The words for the tree in the message of [`Error::OutOfMemory`](crate::input::error::Error::OutOfMemory).
pub const HIERARCHY: &str = "the hierarchy over the objects";

/// A child of a node: an object, or another node of the tree.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Child(u32);

impl Child {
    /// The bit that is set if the child is an object.
    pub const OBJECT: u32 = 1 << 31;

    /// Returns the child that is the object with the number `id`.
    pub const fn object(id: ObjectId) -> Self {
        Self(id | Self::OBJECT)
    }

    /// Returns the child that is the node at `index`.
    pub const fn node(index: u32) -> Self {
        Self(index)
    }

    /// Returns the number of the object, or `None` if the child is a node.
    pub const fn as_object(self) -> Option<ObjectId> {
        if self.0 & Self::OBJECT == 0 { None } else { Some(self.index()) }
    }

    /// Returns the number of the object, or the index of the node.
    pub const fn index(self) -> u32 {
        self.0 & !Self::OBJECT
    }
}

/// A node of the tree: up to 16 children with their boxes, one in each lane.
#[derive(Clone, Debug)]
#[repr(C, align(64))]
pub struct Node {
    /// The smallest coordinates of the boxes for each axis, then the largest coordinates.
    pub corners: [[[f32; WIDTH]; 3]; 2],
    /// The children, each as the number of a [`Child`].
    children: [u32; WIDTH],
    /// A bit for each lane, which is 1 if the child is an object.
    pub objects: u32,
}

impl Node {
    /// A node without children. No ray hits its boxes.
    pub const EMPTY: Self = Self {
        corners: [[[f32::INFINITY; WIDTH]; 3], [[f32::NEG_INFINITY; WIDTH]; 3]],
        children: [0; WIDTH],
        objects: 0,
    };

    /// Sets the child in a lane, and its box.
    pub fn set(&mut self, lane: usize, bounds: &Bounds, child: Child) {
        for axis in 0..3 {
            self.corners[0][axis][lane] = bounds.low[axis];
            self.corners[1][axis][lane] = bounds.high[axis];
        }
        self.children[lane] = child.0;
        self.objects |= u32::from(child.as_object().is_some()) << lane;
    }

    /// Replaces the indices of all children that are nodes. `now` returns the new index for an old one. Lanes without a
    /// child hold index 0, which is replaced too.
    pub fn relink(&mut self, now: impl Fn(u32) -> u32) {
        for child in self.children.iter_mut().filter(|child| Child(**child).as_object().is_none()) {
            *child = now(*child);
        }
    }

    /// Returns the child in a lane.
    #[inline(always)]
    pub const fn child(&self, lane: usize) -> Child {
        Child(self.children[lane])
    }

    /// Returns a bit for each of the lanes from `at` on, as many as `F` has. The bit is 1 if the child is the object
    /// with the number `id`.
    #[inline(always)]
    pub fn lanes_of<F: SimdF32>(&self, id: ObjectId, at: usize) -> u32 {
        F::places_of(Child::object(id).0, &self.children[at..])
    }

    /// Returns a bit for each lane, which is 1 if the child's box overlaps the box `bounds`.
    pub fn overlaps(&self, bounds: &Bounds) -> u32 {
        let ([low, high], mut bits) = (&self.corners, 0);
        for lane in 0..WIDTH {
            let mut overlaps = true;
            for axis in 0..3 {
                overlaps &= (low[axis][lane] <= bounds.high[axis]) & (bounds.low[axis] <= high[axis][lane]);
            }
            bits |= u32::from(overlaps) << lane;
        }
        bits
    }

    /// Returns the children with their boxes. Lanes without a child are left out.
    pub fn children(&self) -> impl Iterator<Item = (Bounds, Child)> {
        let [low, high] = &self.corners;
        (0..WIDTH).filter(|&lane| low[0][lane] <= high[0][lane]).map(|lane| {
            let bounds = Bounds {
                low: std::array::from_fn(|axis| low[axis][lane]),
                high: std::array::from_fn(|axis| high[axis][lane]),
            };
            (bounds, self.child(lane))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn boxes_overlap_where_they_share_a_point() {
        let left = Bounds { low: [0.0; 3], high: [1.0; 3] };
        let overlap = |left: &Bounds, right: &Bounds| {
            let mut node = Node::EMPTY;
            node.set(3, left, Child::object(0));
            node.overlaps(right)
        };
        for axis in 0..3 {
            for (from, overlaps) in [(1.0, true), (1.1, false), (-1.0, true), (-1.1, false), (0.5, true)] {
                let mut right = left;
                (right.low[axis], right.high[axis]) = (from, from + 1.0);
                let expected = u32::from(overlaps) << 3;
                assert_eq!((overlap(&left, &right), overlap(&right, &left)), (expected, expected), "{axis}: {from}");
                assert_eq!(overlap(&left, &right.enlarged(0.2)), 1 << 3);
            }
        }
    }
}
