//! A filter over all objects, several at once, in single precision.

use crate::accel::bvh::stack::Stack;
use crate::accel::closest_hit::ClosestHit;
use crate::accel::conservative::{ConservativeRay, is_too_short};
use crate::accel::dominant_sphere::DominantSphere;
use crate::accel::every_object::plain;
use crate::accel::extent::Extent;
use crate::accel::filter_ray::{BLOCK, Balls, FilterRay, Tubes, misses};
use crate::accel::find::Accelerator;
use crate::accel::find::Origin;
use crate::accel::object::ObjectId;
use crate::counters::{Counter, add};
use crate::geometry::ray::Ray;
use crate::input::error::Error;
use crate::layout::Objects;
use crate::materials::prepared::PreparedMaterial;
use crate::math::vec3::Vec3;
use crate::simd::{Simd, SimdF32};

/// Most spheres, and most cylinders, of a filter: their bits fill a word.
pub const CAPACITY: usize = u64::BITS as usize;

pub use crate::accel::filter_ray::LARGEST_REACH;

/// The filter's data: lanes in both layouts, for it decides nothing but which objects are asked.
#[derive(Debug)]
pub struct FlatFilter {
    middle: Vec3,
    ground: DominantSphere,
    /// See [`DominantSphere::overlapping`].
    overlapping: Option<Vec<ObjectId>>,
    spheres: Vec<Balls>,
    cylinders: Vec<(Balls, Tubes)>,
    /// The lanes that objects fill, as bits.
    sphere_lanes: u64,
    cylinder_lanes: u64,
}

impl FlatFilter {
    /// The filter over `objects`.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`].
    pub fn new(objects: &impl Objects, extent: &Extent) -> Result<Self, Error> {
        let (sphere_count, cylinder_count) = (objects.sphere_count(), objects.cylinder_count());
        let ground = DominantSphere::of(objects);
        let middle = middle(objects, ground);
        let (mut sphere_lanes, mut cylinder_lanes) = (0, 0);
        let mut spheres = blocks(sphere_count, Balls::EMPTY)?;
        let mut cylinders = blocks(cylinder_count, (Balls::EMPTY, Tubes::EMPTY))?;
        for index in (0..sphere_count).filter(|&index| !ground.is(index as ObjectId)) {
            let sphere = objects.sphere(index).record;
            let (block, lane) = (&mut spheres[index / BLOCK], index % BLOCK);
            block.set(lane, sphere.center - middle, sphere.radius_squared);
            sphere_lanes |= 1 << index;
        }
        for index in 0..cylinder_count {
            let cylinder = objects.cylinder(index).record;
            let ((balls, tubes), lane) = (&mut cylinders[index / BLOCK], index % BLOCK);
            let half_height_squared = cylinder.half_height * cylinder.half_height;
            let center = cylinder.center - middle;
            balls.set(lane, center, cylinder.radius_squared + half_height_squared);
            tubes.set(lane, center, cylinder.axis, (cylinder.radius_squared, half_height_squared));
            cylinder_lanes |= 1 << index;
        }
        let overlapping = ground.overlapping(objects, extent);
        Ok(Self { middle, ground, overlapping, spheres, cylinders, sphere_lanes, cylinder_lanes })
    }

    /// See [`Accel::without_isolation`](crate::accel::choice::Accel::without_isolation).
    pub fn without_isolation(&mut self) {
        self.overlapping = None;
    }

    /// The sphere that is asked apart.
    #[inline(always)]
    #[must_use]
    pub const fn ground(&self) -> DominantSphere {
        self.ground
    }

    /// The spheres but for the ground, and the cylinders, that a ray may meet: a bit each.
    #[inline(always)]
    fn may_meet<S: Simd>(&self, ray: &Ray) -> (u64, u64) {
        let filter_ray = FilterRay::<S::F32>::new(ray, self.middle);
        let (mut missed_spheres, mut missed_cylinders) = (0_u64, 0_u64);
        for balls in self.spheres.iter().rev() {
            for at in (0..BLOCK).step_by(S::F32::LANES).rev() {
                let missed = misses(filter_ray.ball(balls, at).miss);
                missed_spheres = missed_spheres << S::F32::LANES | u64::from(missed);
            }
        }
        for (balls, tubes) in self.cylinders.iter().rev() {
            for at in (0..BLOCK).step_by(S::F32::LANES).rev() {
                let ball = filter_ray.ball(balls, at);
                let missed = misses(ball.miss.max(filter_ray.tube(&ball, tubes, at)));
                missed_cylinders = missed_cylinders << S::F32::LANES | u64::from(missed);
            }
        }
        (self.sphere_lanes & !missed_spheres, self.cylinder_lanes & !missed_cylinders)
    }
}

/// The closest hit among all objects: for a ray whose direction is too short for the filter, or whose entry was
/// predicted wrong. It takes the ray by value, because a reference would keep every ray in memory.
#[cold]
#[inline(never)]
fn intersect_every_object<O: Objects>(objects: &O, ray: Ray) -> ClosestHit {
    plain(objects, &ray)
}

/// As many blocks as `count` objects take.
fn blocks<T: Clone>(count: usize, empty: T) -> Result<Vec<T>, Error> {
    let mut blocks = Vec::new();
    let number = count.div_ceil(BLOCK);
    blocks.try_reserve_exact(number).map_err(|_| Error::OutOfMemory { what: "the objects" })?;
    blocks.resize(number, empty);
    Ok(blocks)
}

/// The middle of all that is filtered: coordinates relative to it lose least in single precision.
fn middle(objects: &impl Objects, ground: DominantSphere) -> Vec3 {
    let (mut low, mut high) = (Vec3::splat(f64::INFINITY), Vec3::splat(f64::NEG_INFINITY));
    let spheres = (0..objects.sphere_count()).filter(|&index| !ground.is(index as ObjectId));
    let centers = spheres.map(|index| objects.sphere(index).record.center);
    for center in centers.chain((0..objects.cylinder_count()).map(|index| objects.cylinder(index).record.center)) {
        low = Vec3::new(low.x.min(center.x), low.y.min(center.y), low.z.min(center.z));
        high = Vec3::new(high.x.max(center.x), high.y.max(center.y), high.z.max(center.z));
    }
    if low.x > high.x { Vec3::ZERO } else { (low + high) * 0.5 }
}

impl Accelerator for FlatFilter {
    #[inline(always)]
    fn closest_hit_from<S: Simd, O: Objects>(
        &self,
        objects: &O,
        ray: &Ray,
        origin: Origin,
        _: &mut Stack,
    ) -> ClosestHit {
        let mut found = ClosestHit::NOTHING;
        let touch = ConservativeRay::new(*ray);
        if is_too_short(touch.length_squared) {
            return intersect_every_object(objects, *ray);
        }
        if self.ground.is(origin.object)
            && let Some(overlapping) = &self.overlapping
        {
            // The branch that the processor cannot guess is on what is expected, which is known early; whether it is as
            // expected it guesses right.
            if origin.goes_in {
                self.ground.intersect(&mut found, objects, &touch);
                if !found.is_hit() {
                    add(Counter::Unexpected, 1);
                    return intersect_every_object(objects, *ray);
                }
                for &id in overlapping {
                    found.intersect(objects, id, ray);
                }
                return found;
            }
            if self.ground.may_be_met(objects, &touch) {
                add(Counter::Unexpected, 1);
                return intersect_every_object(objects, *ray);
            }
        }
        let (mut spheres, mut cylinders) = self.may_meet::<S>(ray);
        if let Some(ground) = self.ground.id()
            && !(self.overlapping.is_some() && origin.object == ground)
            && self.ground.may_be_met(objects, &touch)
        {
            spheres |= 1 << ground;
        }
        // One branch for the commonest answer, as early as it can be known.
        if spheres | cylinders == 0 {
            return found;
        }
        while spheres != 0 {
            found.intersect_sphere(objects, spheres.trailing_zeros() as usize, ray);
            spheres &= spheres - 1;
        }
        while cylinders != 0 {
            found.intersect_cylinder(objects, cylinders.trailing_zeros() as usize, ray);
            cylinders &= cylinders - 1;
        }
        found
    }

    #[inline(always)]
    fn origin<O: Objects>(&self, objects: &O, ray: &Ray, object: ObjectId) -> Origin {
        let ground = self.ground();
        Origin { object, goes_in: ground.is(object) && ground.is_entered_by(objects, ray) }
    }

    #[inline(always)]
    fn next_origin<O: Objects>(
        &self,
        objects: &O,
        ray: &Ray,
        found: &ClosestHit,
        material_data: &PreparedMaterial,
        vector: Vec3,
    ) -> Origin {
        let (object, ground) = (found.object, self.ground());
        let goes_in = ground.is(object) && ground.will_be_entered(objects, ray, found.lambda, material_data, vector);
        Origin { object, goes_in }
    }
}
