//! Finds the isolated objects of a tree, those whose box no other box overlaps. See
//! [`isolated`](crate::accel::isolated) for what they are good for.

use crate::accel::bvh::{boxes::Boxes, node::Kind, node::Node, node::lanes_in};
use crate::accel::{
    bounds::Bounds, dominant_sphere::DominantSphere, extent::Extent, isolated::Isolated, isolated::SEPARATION,
};
use crate::accel::{object::ObjectId, object::count};
use crate::{input::error::Error, layout::Objects, simd::Kernel, simd::Simd};

/// Maximum number of nodes that are visited to decide whether an object is isolated. It limits the time.
const MOST_VISITS: usize = 64;

/// A kernel that finds the isolated objects. An overlap with the dominant sphere does not count, because every ray is
/// tested against that sphere.
pub struct FindIsolated<'a, B, O> {
    /// The nodes of the tree, the root first.
    pub nodes: &'a [Node<B>],
    /// All objects of the scene.
    pub objects: &'a O,
    /// The extent of the scene.
    pub extent: &'a Extent,
    /// The dominant sphere, which is not in the tree.
    pub dominant: DominantSphere,
}

impl<B: Boxes, O: Objects> Kernel for FindIsolated<'_, B, O> {
    type Output = Result<Isolated, Error>;

    #[inline(always)]
    fn call<S: Simd>(self, _: S) -> Result<Isolated, Error> {
        let count = count(self.objects);
        let mut isolated = Isolated::none(count)?;
        let slack = (SEPARATION * self.extent.max_coordinate) as f32;
        for id in 0..count as ObjectId {
            if !self.dominant.is(id) && !self.overlaps_another::<S>(id, &self.bounds_of(id).enlarged(slack)) {
                isolated.insert(id);
            }
        }
        Ok(isolated)
    }
}

impl<B: Boxes, O: Objects> FindIsolated<'_, B, O> {
    fn bounds_of(&self, id: ObjectId) -> Bounds {
        Bounds::of_object(self.objects, id)
    }

    /// Whether the box of an object other than `id` overlaps the box `bounds`. If [`MOST_VISITS`] visits of nodes do
    /// not decide this, the result is true.
    #[inline(always)]
    fn overlaps_another<S: Simd>(&self, id: ObjectId, bounds: &Bounds) -> bool {
        let (mut pending, mut count) = ([0; MOST_VISITS], 1);
        for _ in 0..MOST_VISITS {
            if count == 0 {
                return false;
            }
            count -= 1;
            let node = &self.nodes[pending[count] as usize];
            let overlapping = node.overlaps::<S::F32>(bounds);
            let [nodes, spheres, cylinders] = node.lanes();
            for lane in lanes_in(nodes & overlapping) {
                if count == MOST_VISITS {
                    return true;
                }
                pending[count] = node.number(Kind::Node, lane);
                count += 1;
            }
            for (kind, lanes) in [(Kind::Sphere, spheres), (Kind::Cylinder, cylinders)] {
                for lane in lanes_in(lanes & overlapping) {
                    let other = node.number(kind, lane);
                    // The boxes in the tree may be larger than those of the objects.
                    if other != id && self.bounds_of(other).overlaps(bounds) {
                        return true;
                    }
                }
            }
        }
        count != 0
    }
}

#[cfg(test)]
mod tests {
    use crate::accel::bvh::{Bvh, boxes::FloatBoxes};
    use crate::accel::{dominant_sphere::DominantSphere, extent::Extent};
    use crate::input::scene::Scene;
    use crate::layout::{Objects, aos::AosObjects};

    /// Returns the objects of a scene whose largest coordinate is 1. Their boxes are hardly larger than the spheres.
    fn objects(lines: &str) -> (AosObjects, Extent) {
        let scene = Scene::parse(format!("matte: m 1 1 1\n{lines}").as_bytes()).expect("the scene is valid");
        (AosObjects::build(&scene).expect("it fits"), Extent { max_coordinate: 1.0, moderate: true, has_tiny: false })
    }

    #[test]
    fn objects_that_are_nearer_than_the_separation_are_not_isolated() {
        for (gap, isolated) in [(5e-9, false), (3e-8, true)] {
            let right = 3e-4 + gap;
            let (mut spheres, extent) = objects(&format!("sphere: -3e-4 0 0 3e-4 m\nsphere: {right} 0 0 3e-4 m\n"));
            let bvh = Bvh::<FloatBoxes>::new(&mut spheres, &extent, None).expect("it fits");
            assert_eq!([0, 1].map(|id| bvh.isolated.is(id)), [isolated; 2], "{gap}");
            let (spheres, extent) = objects(&format!("sphere: -.5 0 0 .5 m\nsphere: {right} 0 0 3e-4 m\n"));
            let overlapping = DominantSphere(Some(0)).overlapping(&spheres, &extent).expect("they are few");
            assert_eq!(overlapping.is_empty(), isolated, "{gap}");
        }
    }
}
