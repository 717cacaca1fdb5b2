//! A tree of boxes, 16 children a node, for scenes of many objects.
//!
//! A node's boxes are tested at once, in single precision: along each axis a plane at `p` is at the distance `p r - o r`,
//! with the reciprocal `r` of the direction and the origin `o`. Of its error, with `u = 2^-24`, `2 u` of the distance come
//! from `r`, and as much and `u |o r|` from the product and the sum, fused or not, since `p r` is `o r` and the distance.
//! The origin is moved by `8 u |o|` towards the side that lets the ray pass, which covers what is relative to it: its own
//! rounding, that of the sum and of `o r`, and that of `p r`. So a ray that meets a box, ahead and not farther than the
//! nearest hit so far, has `near (1 - 5u) <= far (1 + 5u)`, which [`SLACK`] covers.

use super::alone::{Alone, roomy_bounds};
use super::bounds::Bounds;
use super::build::build;
use super::ground::Ground;
use super::node::{Child, Node, WIDTH};
use super::touch::Touch;
use super::{Found, ObjectId, plain};
use crate::certified::Intersect;
use crate::counters::{Counter, add};
use crate::error::Error;
use crate::layout::Objects;
use crate::prepare::Extent;
use crate::ray::Ray;
use crate::simd::{FilterLanes, Simd};

/// Most nodes that wait during a traversal: 15 a level, and the builder bounds the levels.
const STACK: usize = 512;

/// Most objects of which each is asked whether it is alone: the answers take as long as building the tree.
const MOST_ASKED_WHETHER_ALONE: usize = 1 << 17;

/// Most nodes visited for such an answer, so that no scene makes it long.
const MOST_VISITS: usize = 64;

/// Factor on a far distance that covers all rounding.
const SLACK: f32 = 1.0 + 16.0 * f32::EPSILON;

/// Largest magnitude of a reciprocal: no coordinate of a moderate scene overflows with it.
const LARGEST_RECIPROCAL: f32 = 1e28;

/// The least that an origin is moved: with the largest reciprocal it is farther than any plane across another axis, for
/// a direction that is not shorter than [`SHORTEST`].
const LEAST_STEP: f32 = 1e-10;

/// Length squared of the shortest direction that the tree is used for.
const SHORTEST: f64 = 1e-14;

/// The tree over all objects of a scene.
#[derive(Debug)]
pub struct Hierarchy {
    nodes: Vec<Node>,
    /// It is not in the tree.
    ground: Ground,
    alone: Alone,
    /// Rays that start beyond this are asked by the plain search: the boxes' margins do not cover them.
    reach: f64,
}

/// Nodes that wait to be visited, with their distances; kept between rays, for clearing it would cost more than a visit.
#[derive(Clone, Debug)]
pub struct Stack([(u32, f32); STACK]);

impl Stack {
    /// Nothing waits.
    pub const EMPTY: Self = Self([(0, 0.0); STACK]);
}

/// A ray as the boxes see it.
struct BoxRay<F> {
    /// Of its direction.
    reciprocal: [F; 3],
    /// Minus the origin times the reciprocal: moved so that near planes are not farther, and far planes not nearer, than
    /// they are.
    near_origin: [F; 3],
    far_origin: [F; 3],
    /// Which [corner](Node::corners) is the near one along each axis.
    near: [usize; 3],
}

impl<F: FilterLanes> BoxRay<F> {
    // Without a branch on where the ray goes, which no processor could guess.
    #[inline(always)]
    fn new(ray: &Ray) -> Self {
        let (origin, direction) = (ray.origin.to_array(), ray.direction.to_array());
        let mut box_ray = Self {
            reciprocal: [F::splat(0.0); 3],
            near_origin: [F::splat(0.0); 3],
            far_origin: [F::splat(0.0); 3],
            near: [0; 3],
        };
        for axis in 0..3 {
            let (origin, direction) = (origin[axis] as f32, direction[axis] as f32);
            let reciprocal = (1.0 / direction).clamp(-LARGEST_RECIPROCAL, LARGEST_RECIPROCAL);
            let step = (origin.abs() * (4.0 * f32::EPSILON) + LEAST_STEP).copysign(direction);
            box_ray.reciprocal[axis] = F::splat(reciprocal);
            box_ray.near_origin[axis] = F::splat(-((origin + step) * reciprocal));
            box_ray.far_origin[axis] = F::splat(-((origin - step) * reciprocal));
            box_ray.near[axis] = usize::from(direction.is_sign_negative());
        }
        box_ray
    }

    /// Distances to the boxes of a node, and which the ray meets within `farthest`.
    #[inline(always)]
    fn meets(&self, node: &Node, at: usize, farthest: F) -> (F, u32) {
        let mut near = F::splat(0.0);
        let mut far = farthest;
        for axis in 0..3 {
            let (enter, leave) = (&node.corners[self.near[axis]][axis], &node.corners[1 - self.near[axis]][axis]);
            near = F::load(&enter[at..]).mul_add(self.reciprocal[axis], self.near_origin[axis]).max(near);
            far = F::load(&leave[at..]).mul_add(self.reciprocal[axis], self.far_origin[axis]).min(far);
        }
        (near, near.less_equal(far * F::splat(SLACK)))
    }
}

impl Hierarchy {
    /// The tree over `objects`.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`].
    pub fn new(objects: &impl Objects, extent: &Extent) -> Result<Self, Error> {
        let count = objects.sphere_count() + objects.cylinder_count();
        if count >= Child::OBJECT as usize {
            return Err(Error::OutOfMemory { what: "the hierarchy over the objects" });
        }
        let ground = Ground::of(objects);
        let inside = (0..count as ObjectId).filter(|&id| !ground.is(id));
        let nodes = build(count, inside.map(|id| (Bounds::of_object(objects, id as usize, extent), id)))?;
        let mut tree = Self { nodes, ground, alone: Alone::none(), reach: 2.0 * extent.reach };
        if count <= MOST_ASKED_WHETHER_ALONE {
            let alone =
                Alone::new(count, |id| ground.is(id) || tree.overlaps_another(id, &roomy_bounds(objects, id, extent)))?;
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
                let child = node.child[bits.trailing_zeros() as usize];
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

    /// Whether the ray may use the tree.
    #[inline(always)]
    fn covers(&self, Touch { ray, length_squared, .. }: &Touch<f64>) -> bool {
        let is_near = |coordinate: f64| coordinate.abs() <= self.reach;
        is_near(ray.origin.x) && is_near(ray.origin.y) && is_near(ray.origin.z) && *length_squared >= SHORTEST
    }

    /// See [`Search::forget_who_is_alone`](super::Search::forget_who_is_alone).
    pub fn forget_who_is_alone(&mut self) {
        self.alone = Alone::none();
    }

    /// The nearest object that a ray from the surface of `from` meets.
    #[inline(always)]
    pub fn nearest<S: Simd, O: Objects, P: Intersect>(
        &self,
        objects: &O,
        ray: &Ray,
        from: ObjectId,
        Stack(stack): &mut Stack,
    ) -> Found {
        let mut found = Found::NOTHING;
        let touch = Touch::new(*ray);
        if !self.covers(&touch) {
            return plain::<O, P>(objects, ray);
        }
        self.ground.ask_closely::<S, O, P>(&mut found, objects, &touch);
        if self.nodes.is_empty() {
            return found;
        }
        if self.alone.is::<O, P>(objects, from) {
            let mut again = Found::NOTHING;
            self.ask::<O, P>(&mut again, objects, from, &touch, from);
            if again.is_hit() {
                found.offer(again.lambda, again.object, again.order, again.part);
                return found;
            }
        }
        let box_ray = BoxRay::<S::F32>::new(ray);
        let (mut index, mut waiting) = (0, 0);
        loop {
            let farthest = farthest(&found);
            add(Counter::NodeVisits, 1);
            let node = &self.nodes[index as usize];
            let mut distances = [0.0; WIDTH];
            let mut bits = 0;
            for at in (0..WIDTH).step_by(S::F32::LANES) {
                let (near, met) = box_ray.meets(node, at, S::F32::splat(farthest));
                near.store(&mut distances[at..]);
                bits |= met << at;
            }
            let mut asked = bits & node.objects;
            let mut entered = bits & !node.objects;
            while asked != 0 {
                let lane = asked.trailing_zeros() as usize % WIDTH;
                asked &= asked - 1;
                self.ask::<O, P>(&mut found, objects, node.child[lane].as_id(), &touch, from);
            }
            if entered.is_power_of_two() {
                // The only one goes past the stack.
                index = node.child[entered.trailing_zeros() as usize % WIDTH].as_node();
                continue;
            }
            let first = waiting;
            while entered != 0 {
                let lane = entered.trailing_zeros() as usize % WIDTH;
                entered &= entered - 1;
                // Kept in order, the nearest last, so that it is taken first.
                let entry = (node.child[lane].as_node(), distances[lane]);
                let mut place = waiting.min(STACK - 1);
                while place > first && stack[place - 1].1 < entry.1 {
                    stack[place] = stack[place - 1];
                    place -= 1;
                }
                stack[place] = entry;
                waiting += 1;
            }
            loop {
                if waiting == 0 {
                    return found;
                }
                waiting -= 1;
                let (next, distance) = stack[waiting % STACK];
                if distance <= self::farthest(&found) * SLACK {
                    index = next;
                    break;
                }
            }
        }
    }

    /// Asks an object, unless the filter stops the ray: that is worth trying for the one that it leaves.
    #[inline(always)]
    fn ask<O: Objects, P: Intersect>(
        &self,
        found: &mut Found,
        objects: &O,
        id: ObjectId,
        touch: &Touch<f64>,
        from: ObjectId,
    ) {
        match (id as usize).checked_sub(objects.sphere_count()) {
            None => {
                if id != from || touch.sphere_at(objects, id as usize) {
                    found.ask_sphere::<O, P>(objects, id as usize, &touch.ray);
                }
            }
            Some(index) => {
                if id != from || touch.cylinder_at(objects, index, self.reach) {
                    found.ask_cylinder::<O, P>(objects, index, &touch.ray);
                }
            }
        }
    }

    /// Calls `visit` with the ground, and every object whose box, or that of a node above it, `reaches` does not rule
    /// out.
    pub fn visit(&self, mut reaches: impl FnMut(&Bounds) -> bool, mut visit: impl FnMut(ObjectId)) {
        let mut pending = Vec::with_capacity(STACK);
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

/// The nearest hit so far, rounded up; infinite at first.
#[inline(always)]
fn farthest(found: &Found) -> f32 {
    found.lambda as f32 * (1.0 + f32::EPSILON)
}
