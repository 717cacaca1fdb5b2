//! Visits the objects of a tree whose boxes pass a test. A sphere leaf has the boxes around its bounding spheres.
//! Frustum culling uses this.

use crate::accel::bvh::{Bvh, boxes::Boxes, node::Kind};
use crate::accel::{bounds::Bounds, object::ObjectId, stack};

impl<B: Boxes> Bvh<B> {
    /// Calls `visit` with the dominant sphere, the objects apart, and every object for which `may_reach` accepts the
    /// object's box and the boxes of all nodes above it.
    pub(crate) fn visit(&self, mut may_reach: impl FnMut(&Bounds) -> bool, mut visit: impl FnMut(ObjectId)) {
        let mut pending = Vec::with_capacity(stack::MOST_PENDING);
        pending.push(0);
        if let Some(id) = self.dominant.0 {
            visit(id);
        }
        self.apart.iter().flatten().cloned().flatten().for_each(&mut visit);
        while let Some(index) = pending.pop() {
            for (bounds, child) in self.nodes[index as usize].children() {
                if may_reach(&bounds) {
                    match child.kind {
                        Kind::Node => pending.push(child.number),
                        Kind::Sphere | Kind::Cylinder => visit(child.number),
                    }
                }
            }
        }
    }
}
