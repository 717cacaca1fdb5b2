//! The structure for many objects: a tree of boxes with up to 16 children in each node.

pub(crate) mod boxes;
mod build;
pub(crate) mod byte_boxes;
pub(crate) mod collapsed_root;
mod find_isolated;
pub(crate) mod node;
pub mod planes;
pub mod slab_ray;
pub mod sphere_leaf;
pub mod sphere_ray;
mod visit;

use crate::accel::{
    accelerator::Accelerator, accelerator::Start, bounds::Bounds, bvh::boxes::Boxes, bvh::build::Tree,
    bvh::build::build, bvh::collapsed_root::CollapsedRoot, bvh::find_isolated::FindIsolated, bvh::node::Kind,
    bvh::node::Node, bvh::node::lanes_in, bvh::planes::WIDTH, bvh::slab_ray::SlabRay, bvh::slab_ray::is_in_reach,
    bvh::slab_ray::suits_slabs, bvh::sphere_ray::SphereRay, closest_hit::ClosestHit, dominant_sphere::DominantSphere,
    every_object::intersect_every_object, every_object::intersect_objects, extent::Extent, extent::is_tiny,
    extent::reach, giants::giants_beyond, isolated::Isolated, may_hit::conservative::ConservativeRay,
    object::NO_OBJECT, object::ObjectId, object::ObjectRef, object::count, object::cylinder_index, stack::Stack,
};
use crate::simd::instruction_set::InstructionSet;
use crate::{
    counters::Counter, counters::add, geometry::ray::Ray, input::error::Error, input::error::with_room,
    layout::OBJECTS, layout::Objects, layout::prefetch::prefetch, simd::Simd, simd::SimdF32,
};
use std::ops::Range;

/// Maximum number of objects of a scene in which the isolated objects are sought. In a larger scene no object counts as
/// isolated, because the search would take as long as building the tree.
const MOST_FOR_ISOLATION: usize = 1 << 17;

/// Maximum number of objects for which the nodes have the boxes of the form [`FloatBoxes`](boxes::FloatBoxes). These
/// are tested with fewer operations than [`ByteBoxes`](byte_boxes::ByteBoxes), so they are faster while the tree fits
/// into a cache. A larger tree waits for memory, of which bytes take less (docs/experiments.md, column "boxes of
/// floats, against bytes"; bench/src/bin/nearest.rs).
pub const MOST_IN_FLOAT_BOXES: usize = 200_000;

/// The tree over all objects of a scene but the dominant sphere, which is tested separately.
#[derive(Debug)]
pub struct Bvh<B> {
    nodes: Vec<Node<B>>,
    /// Most of the two highest levels of the tree, as one list of boxes. It may be empty.
    pub(super) collapsed_root: CollapsedRoot,
    /// For each axis, the part of a plane's move that does not depend on the ray; see [`slab_ray::margins`].
    margins: [f32; 3],
    /// The dominant sphere, which is not in the tree.
    dominant: DominantSphere,
    /// The numbers of the giants and tiny objects, which are not in the tree: spheres, and cylinders. `None` if there
    /// are none, and no coordinate of the scene exceeds [`Extent::LARGEST`].
    pub(super) apart: Option<[Range<ObjectId>; 2]>,
    pub(super) isolated: Isolated,
    /// Whether there are sphere leaves: nodes with only spheres have bounding spheres instead of boxes.
    has_sphere_leaves: bool,
    /// A bound of the scene's coordinates for the conservative test of the start object: twice the largest coordinate.
    twice_max_coordinate: f64,
}

impl<B: Boxes> Bvh<B> {
    /// Builds the tree over `objects`, and reorders them so that the objects of a node follow one another.
    /// `sphere_leaves` says whether it has sphere leaves; `None` leaves this to [`sphere_leaf::save_time`].
    ///
    /// # Errors
    /// [`Error::OutOfMemory`] if memory is short.
    pub(crate) fn new(objects: &mut impl Objects, extent: &Extent, sphere_leaves: Option<bool>) -> Result<Self, Error> {
        let count = count(objects);
        let (dominant, sphere_count) = (DominantSphere::of(objects), objects.sphere_count());
        let others = (0..count as ObjectId).filter(|&id| !dominant.is(id));
        let limit = giants_beyond(objects, dominant, extent);
        let is_apart = |id: &ObjectId| {
            limit.is_some_and(|limit| reach(objects, *id) > limit) || extent.has_tiny && is_tiny(objects, *id)
        };
        let mut apart = with_room(others.clone().filter(is_apart).count(), OBJECTS)?;
        apart.extend(others.clone().filter(is_apart));
        let boxes = others.filter(|id| !is_apart(id)).map(|id| (Bounds::of_object(objects, id), id));
        let tree = build(count, sphere_count, boxes, sphere_leaves)?;
        let Tree { mut nodes, mut spheres, mut cylinders, has_sphere_leaves } = tree;
        // The builder planned it for the objects of the tree, without the dominant sphere, which is added below.
        let collapsed_root = CollapsedRoot::new(&mut nodes, spheres.len() + cylinders.len())?;
        // The dominant sphere is behind all spheres of the tree. The objects apart are behind all others of their kind.
        let dominant = DominantSphere(dominant.0.map(|id| {
            spheres.push(id);
            spheres.len() as ObjectId - 1
        }));
        let apart = (limit.is_some() || !apart.is_empty()).then(|| {
            let first = [spheres.len(), sphere_count + cylinders.len()].map(|number| number as ObjectId);
            for id in apart {
                if (id as usize) < sphere_count { spheres.push(id) } else { cylinders.push(id) }
            }
            [first[0]..sphere_count as ObjectId, first[1]..count as ObjectId]
        });
        cylinders.iter_mut().for_each(|id| *id = cylinder_index(objects, *id) as u32);
        objects.reorder(&mut spheres, &mut cylinders);
        let root = nodes.first().into_iter().flat_map(Node::children);
        let margins = slab_ray::margins(&root.fold(Bounds::EMPTY, |all, (bounds, _)| all.union(&bounds)));
        let (isolated, twice_max_coordinate) = (Isolated::default(), 2.0 * extent.max_coordinate.min(Extent::LARGEST));
        let mut bvh =
            Self { nodes, collapsed_root, margins, dominant, apart, isolated, has_sphere_leaves, twice_max_coordinate };
        if count <= MOST_FOR_ISOLATION && bvh.apart.is_none() {
            let find = FindIsolated { nodes: &bvh.nodes, objects, extent, dominant };
            bvh.isolated = InstructionSet::fused().run(find)?;
        }
        Ok(bvh)
    }

    /// Returns the number of nodes with bounding spheres.
    #[cfg(any(test, feature = "internals"))]
    pub fn sphere_leaf_count(&self) -> usize {
        self.nodes.iter().filter(|node| node.bounding_spheres().is_some()).count()
    }

    /// Intersects the objects below `node` whose boxes or bounding spheres the ray hits, and updates `closest`. It
    /// leaves out the start object.
    #[inline(always)]
    fn traverse<'tree, S: Simd, O: Objects>(
        &'tree self,
        mut node: &'tree Node<B>,
        query: &Query<O, S::F32>,
        closest: &mut ClosestHit,
        stack: &mut Stack,
    ) {
        let &Query { objects, ray, start_object, ref slab_ray, sphere_ray } = query;
        let start_kind = Kind::of(ObjectRef::of(objects, start_object));
        let mut depth = 0;
        loop {
            add(Counter::NodeVisits, 1);
            let mut distances = [0.0; WIDTH];
            let (bits, lanes) = match node.bounding_spheres() {
                Some(leaf) => {
                    let bits = sphere_ray.intersect::<_, S::F32>(&leaf, farthest_for(closest.lambda), &mut distances);
                    (bits, [0, node.occupied(), 0])
                }
                None => (node.boxes.intersect(slab_ray, farthest_for(closest.lambda), &mut distances), node.lanes()),
            };
            let bits = bits & !node.lane_of(start_kind, start_object);
            let [nodes, spheres, cylinders] = lanes.map(|lanes| lanes & bits);
            // All spheres are asked for before the first is tested, so that they arrive together.
            for lane in lanes_in(spheres) {
                objects.prefetch_sphere(node.number(Kind::Sphere, lane) as usize);
            }
            for lane in lanes_in(spheres) {
                // Another object of this node may have been hit before the ray enters this box.
                if distances[lane] <= farthest_for(closest.lambda) {
                    closest.intersect_sphere(objects, node.number(Kind::Sphere, lane) as usize, ray);
                }
            }
            for lane in lanes_in(cylinders) {
                if distances[lane] <= farthest_for(closest.lambda) {
                    let id = node.number(Kind::Cylinder, lane);
                    closest.intersect_cylinder(objects, cylinder_index(objects, id), ray);
                }
            }
            if nodes == 0 && depth == 0 {
                return;
            }
            if nodes.is_power_of_two() {
                // A single child is visited without the stack.
                node = &self.nodes[node.number(Kind::Node, nodes.trailing_zeros() as usize % WIDTH) as usize];
                continue;
            }
            let first = depth;
            for lane in lanes_in(nodes) {
                let child = node.number(Kind::Node, lane);
                self.nodes.get(child as usize).into_iter().for_each(prefetch);
                stack.push_sorted(&mut depth, first, (child, distances[lane]));
            }
            loop {
                if depth == 0 {
                    return;
                }
                let (next, distance) = stack.pop(&mut depth);
                if distance <= farthest_for(closest.lambda) {
                    node = &self.nodes[next as usize];
                    break;
                }
            }
        }
    }
}

/// The data that do not change during a traversal.
struct Query<'a, O, F> {
    objects: &'a O,
    ray: &'a Ray,
    start_object: ObjectId,
    slab_ray: SlabRay<F>,
    /// The sphere ray is unused if the tree has no sphere leaves.
    sphere_ray: &'a SphereRay,
}

/// Returns a lambda in single precision beyond which no object is closer than a hit at `lambda`, or ties with it. It is
/// infinite before the first hit. It exceeds `lambda` by more than the error of a lambda. The factor adds at least one
/// unit in the last place, and rounding takes at most half of one.
#[inline(always)]
pub const fn farthest_for(lambda: f64) -> f32 {
    lambda as f32 * (1.0 + f32::EPSILON)
}

impl<B: Boxes> Accelerator for Bvh<B> {
    #[inline(always)]
    fn closest_hit<S: Simd, O: Objects>(&self, objects: &O, ray: &Ray, start: Start, stack: &mut Stack) -> ClosestHit {
        let (mut closest, mut start_object) = (ClosestHit::NOTHING, start.object);
        let conservative = ConservativeRay::new(*ray);
        if !suits_slabs(conservative.length_squared) {
            return intersect_every_object(objects, *ray);
        }
        if let Some(apart) = &self.apart {
            if !is_in_reach(ray.origin, conservative.length_squared) {
                return intersect_every_object(objects, *ray);
            }
            closest = intersect_objects(objects, apart.clone(), *ray);
            if apart.iter().any(|apart| apart.contains(&start_object)) {
                start_object = NO_OBJECT;
            }
        }
        if let Some(index) = self.dominant.may_be_hit(objects, &conservative) {
            closest.intersect_uncertain_sphere(objects, index, ray);
        }
        if start_object != NO_OBJECT && !self.dominant.is(start_object) {
            let mut again = ClosestHit::NOTHING;
            if conservative.may_hit(objects, start_object, self.twice_max_coordinate) {
                again.intersect(objects, start_object, ray);
            }
            if again.is_hit() {
                closest.update(objects, ray, again);
                if self.isolated.is(start_object) {
                    return closest;
                }
            }
        }
        let slab_ray = SlabRay::<S::F32>::new(ray, &self.margins);
        let sphere_ray = if self.has_sphere_leaves {
            SphereRay::new(ray, &self.margins, conservative.length_squared)
        } else {
            SphereRay::UNUSED
        };
        // This keeps the sphere ray in memory. Otherwise the compiler copies its numbers to lanes for every ray, even
        // in a tree without sphere leaves, which takes more instructions.
        let sphere_ray = std::hint::black_box(&sphere_ray);
        let query = Query { objects, ray, start_object, slab_ray, sphere_ray };
        // The traversal begins at the root if there is no collapsed root. The root's address needs no test of boxes, so
        // its boxes can be loaded at once. `boxes` are those of the collapsed root that are still to be visited.
        let (mut node, mut boxes) = (&self.nodes[0], 0);
        let backwards = self.collapsed_root.is_passed_backwards(ray.direction);
        if S::F32::LANES >= collapsed_root::LEAST_LANES && !self.collapsed_root.is_empty() {
            boxes = self.collapsed_root.intersect(&query.slab_ray, farthest_for(closest.lambda));
            if boxes == 0 {
                return closest;
            }
            node = &self.nodes[self.collapsed_root.take_nearest(&mut boxes, backwards)];
        }
        loop {
            self.traverse::<S, O>(node, &query, &mut closest, stack);
            if boxes == 0 {
                return closest;
            }
            node = &self.nodes[self.collapsed_root.take_nearest(&mut boxes, backwards)];
        }
    }
}
