//! A tree of boxes, 16 children a node, for scenes of many objects.

mod build;
pub(crate) mod collapsed_root;
pub(crate) mod node;
pub mod slab_ray;
pub mod stack;

use crate::accel::bounds::Bounds;
use crate::accel::bvh::build::build;
use crate::accel::bvh::collapsed_root::CollapsedRoot;
use crate::accel::bvh::node::{Child, Node, WIDTH};
use crate::accel::bvh::slab_ray::{SlabRay, Steps, is_in_scale};
use crate::accel::bvh::stack::{Stack, wait};
use crate::accel::closest_hit::ClosestHit;
use crate::accel::conservative::ConservativeRay;
use crate::accel::dominant_sphere::DominantSphere;
use crate::accel::every_object::plain;
use crate::accel::extent::Extent;
use crate::accel::find::{Accelerator, Origin};
use crate::accel::isolated::{Isolated, roomy_bounds};
use crate::accel::object;
use crate::accel::object::{NOWHERE, ObjectId};
use crate::counters::{Counter, add};
use crate::geometry::ray::Ray;
use crate::input::error::Error;
use crate::layout::Objects;
use crate::simd::{Simd, SimdF32};

/// Most objects for which isolation is computed: it takes as long as building the tree.
const MOST_ASKED_WHETHER_ALONE: usize = 1 << 17;

/// Most nodes visited for such an answer, so that no scene makes it long.
const MOST_VISITS: usize = 64;

/// The tree over all objects of a scene.
#[derive(Debug)]
pub struct Bvh {
    nodes: Vec<Node>,
    /// The two highest levels in one row.
    top: CollapsedRoot,
    /// How far its planes are moved.
    steps: Steps,
    /// It is not in the tree.
    ground: DominantSphere,
    alone: Isolated,
    /// The margin with which the object that a ray starts on is tested.
    reach: f64,
}

impl Bvh {
    /// The tree over `objects`.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`].
    pub fn new(objects: &impl Objects, extent: &Extent) -> Result<Self, Error> {
        let count = object::count(objects);
        if count >= Child::OBJECT as usize {
            return Err(Error::OutOfMemory { what: "the hierarchy over the objects" });
        }
        let ground = DominantSphere::of(objects);
        let inside = (0..count as ObjectId).filter(|&id| !ground.is(id));
        let mut nodes = build(count, inside.map(|id| (Bounds::of_object(objects, id, extent), id)))?;
        let top = CollapsedRoot::new(&mut nodes)?;
        let all = nodes.first().into_iter().flat_map(Node::children).fold(Bounds::EMPTY, |all, (it, _)| all.union(&it));
        let steps = Steps::new(&all);
        let mut tree = Self { nodes, top, steps, ground, alone: Isolated::none(), reach: 2.0 * extent.reach };
        if count <= MOST_ASKED_WHETHER_ALONE {
            let alone = Isolated::new(count, |id| {
                ground.is(id) || tree.overlaps_another(id, &roomy_bounds(objects, id, extent))
            })?;
            tree.alone = alone;
        }
        Ok(tree)
    }

    /// Whether an object of the tree other than `id` has a box that overlaps this one; true when it takes long to say.
    fn overlaps_another(&self, id: ObjectId, bounds: &Bounds) -> bool {
        let mut pending = [0; MOST_VISITS];
        let mut waiting = usize::from(!self.nodes.is_empty());
        for _ in 0..MOST_VISITS {
            if waiting == 0 {
                return false;
            }
            waiting -= 1;
            let node = &self.nodes[pending[waiting] as usize];
            let mut bits = node.overlaps(bounds);
            while bits != 0 {
                let child = node.child(bits.trailing_zeros() as usize);
                bits &= bits - 1;
                match child.as_object() {
                    Some(other) if other == id => {}
                    Some(_) => return true,
                    None if waiting == MOST_VISITS => return true,
                    None => {
                        pending[waiting] = child.as_node();
                        waiting += 1;
                    }
                }
            }
        }
        true
    }

    /// See [`Accel::without_isolation`](crate::accel::choice::Accel::without_isolation).
    pub fn without_isolation(&mut self) {
        self.alone = Isolated::none();
    }

    /// Takes the objects below a node into account, but for the one that the ray leaves.
    #[inline(always)]
    fn traverse<'tree, S: Simd, O: Objects>(
        &'tree self,
        mut node: &'tree Node,
        query: &Query<O, S::F32>,
        found: &mut ClosestHit,
        Stack(stack): &mut Stack,
    ) {
        let &Query { objects, ray, from, ref box_ray } = query;
        let mut waiting = 0;
        loop {
            let farthest = farthest(found);
            add(Counter::NodeVisits, 1);
            let mut distances = [0.0; WIDTH];
            let mut bits = 0;
            for at in (0..WIDTH).step_by(S::F32::LANES) {
                let (near, met) = box_ray.meets(node, at, S::F32::splat(farthest));
                near.store(&mut distances[at..]);
                bits |= (met & !node.lanes_of::<S::F32>(from, at)) << at;
            }
            let mut asked = bits & node.objects;
            let mut entered = bits & !node.objects;
            while asked != 0 {
                let lane = asked.trailing_zeros() as usize % WIDTH;
                asked &= asked - 1;
                found.intersect(objects, node.child(lane).as_id(), ray);
            }
            if entered == 0 && waiting == 0 {
                return;
            }
            if entered.is_power_of_two() {
                // The only one goes past the stack.
                let only = node.child(entered.trailing_zeros() as usize % WIDTH);
                node = &self.nodes[only.as_node() as usize];
                continue;
            }
            let first = waiting;
            while entered != 0 {
                let lane = entered.trailing_zeros() as usize % WIDTH;
                entered &= entered - 1;
                // Kept in order, the nearest last, so that it is taken first.
                let entry = (node.child(lane).as_node(), distances[lane]);
                wait(stack, &mut waiting, first, entry);
            }
            loop {
                if waiting == 0 {
                    return;
                }
                waiting -= 1;
                let (next, distance) = stack[waiting % stack.len()];
                if distance <= self::farthest(found) {
                    node = &self.nodes[next as usize];
                    break;
                }
            }
        }
    }

    /// Calls `visit` with the dominant sphere, and every object whose box, or that of a node above it, `reaches` does
    /// not rule out.
    pub fn visit(&self, mut reaches: impl FnMut(&Bounds) -> bool, mut visit: impl FnMut(ObjectId)) {
        let mut pending = Vec::with_capacity(stack::MOST);
        if !self.nodes.is_empty() {
            pending.push(0);
        }
        if let Some(id) = self.ground.id() {
            visit(id);
        }
        while let Some(index) = pending.pop() {
            for (bounds, child) in self.nodes[index as usize].children() {
                if reaches(&bounds) {
                    match child.as_object() {
                        Some(id) => visit(id),
                        None => pending.push(child.as_node()),
                    }
                }
            }
        }
    }
}

/// What a traversal looks for.
struct Query<'a, O, F> {
    objects: &'a O,
    ray: &'a Ray,
    /// The object that the ray leaves.
    from: ObjectId,
    box_ray: SlabRay<F>,
}

/// The nearest hit so far, rounded up; infinite at first.
#[inline(always)]
fn farthest(found: &ClosestHit) -> f32 {
    found.lambda as f32 * (1.0 + f32::EPSILON)
}

impl Accelerator for Bvh {
    #[inline(always)]
    fn closest_hit_from<S: Simd, O: Objects>(
        &self,
        objects: &O,
        ray: &Ray,
        Origin { object: from, .. }: Origin,
        stack: &mut Stack,
    ) -> ClosestHit {
        let mut found = ClosestHit::NOTHING;
        let touch = ConservativeRay::new(*ray);
        // A ray starts at the camera or on a surface, so within the scene's reach.
        if !is_in_scale(touch.length_squared) {
            return plain(objects, ray);
        }
        self.ground.intersect_closely::<S, O>(&mut found, objects, &touch);
        if self.nodes.is_empty() {
            return found;
        }
        if from != NOWHERE && !self.ground.is(from) {
            let mut again = ClosestHit::NOTHING;
            if touch.object_at(objects, from, self.reach) {
                again.intersect(objects, from, ray);
            }
            if again.is_hit() {
                found.update(again.lambda, again.object, again.order, again.part);
                if self.alone.is(from) {
                    return found;
                }
            }
        }
        let query = Query { objects, ray, from, box_ray: SlabRay::<S::F32>::new(ray, &self.steps) };
        if S::F32::LANES < WIDTH {
            self.traverse::<S, O>(&self.nodes[0], &query, &mut found, stack);
            return found;
        }
        let mut met = self.top.met(&query.box_ray, farthest(&found));
        let backwards = self.top.is_passed_backwards(ray.direction);
        while met != 0 {
            let place = self.top.take(&mut met, backwards);
            self.traverse::<S, O>(&self.nodes[place], &query, &mut found, stack);
        }
        found
    }
}
