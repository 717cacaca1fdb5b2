//! This project's side of the comparison: the acceleration structure of the renderer, which gives the hits of exact
//! arithmetic in double precision.

use cpu::internals::InstructionSet;
use cpu::internals::accel::{
    choice::Accel, closest_hit::ClosestHit, every_object::intersect_every_object, extent::Extent, object::NO_OBJECT,
    object::ObjectId, object::count, object::file_index_of, stack::Stack,
};
use cpu::internals::input::scene::{Shape, Sphere};
use cpu::internals::layout::{Objects, aos::AosObjects};
use cpu::internals::simd::{Kernel, Simd};
use cpu::{Error, Ray, Scene};

use super::{NO_PLACE, NearestHit, Start};

/// The objects of a scene and their acceleration structure.
#[derive(Debug)]
pub struct Ours {
    objects: AosObjects,
    accel: Accel,
    /// The number of each object, by its place in the scene file.
    numbers: Vec<ObjectId>,
}

/// A ray in the form that [`Ours::find`] takes.
#[derive(Clone, Copy, Debug)]
pub struct PreparedRay {
    ray: Ray,
    /// The number of the start object, or [`NO_OBJECT`].
    start_object: ObjectId,
}

impl Ours {
    /// Builds the structure of a scene of spheres.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`] if memory is short.
    pub fn new(scene: &Scene) -> Result<Self, Error> {
        let mut objects = AosObjects::build(scene)?;
        let reach = |sphere: &Sphere| sphere.center.x.abs().max(sphere.center.y.abs()).max(sphere.center.z.abs());
        let max_coordinate = scene.objects.iter().fold(0.0_f64, |most, object| match &object.shape {
            Shape::Sphere(sphere) => most.max(reach(sphere) + sphere.radius),
            Shape::Cylinder(_) => most,
        });
        let extent = Extent { max_coordinate, moderate: true, has_tiny: false };
        let accel = Accel::new(&mut objects, &extent)?;
        let mut numbers: Vec<_> = (0..count(&objects) as ObjectId).collect();
        numbers.sort_unstable_by_key(|&id| file_index_of(&objects, id));
        Ok(Self { objects, accel, numbers })
    }

    /// Returns the rays in the form that [`Ours::find`] takes.
    #[must_use]
    pub fn prepare(&self, starts: &[Start]) -> Vec<PreparedRay> {
        let number = |place: u32| if place == NO_PLACE { NO_OBJECT } else { self.numbers[place as usize] };
        starts.iter().map(|start| PreparedRay { ray: start.ray, start_object: number(start.from) }).collect()
    }

    /// Finds the nearest hit of each prepared ray with an instruction set.
    pub fn find(&self, set: InstructionSet, rays: &[PreparedRay], hits: &mut Vec<NearestHit>) {
        hits.clear();
        set.run(Find { ours: self, rays, hits, stack: &mut Stack::EMPTY.clone() });
    }

    /// Returns the nearest hit of each ray, with the fastest instruction set.
    #[must_use]
    pub fn hits(&self, starts: &[Start]) -> Vec<NearestHit> {
        let mut hits = Vec::with_capacity(starts.len());
        self.find(InstructionSet::best(), &self.prepare(starts), &mut hits);
        hits
    }

    /// Returns the nearest hit of each ray by intersecting every object, to test the other functions.
    #[must_use]
    pub fn hits_without_structure(&self, starts: &[Start]) -> Vec<NearestHit> {
        starts.iter().map(|start| nearest(&self.objects, &intersect_every_object(&self.objects, start.ray))).collect()
    }
}

#[inline(always)]
fn nearest(objects: &AosObjects, hit: &ClosestHit) -> NearestHit {
    if hit.is_hit() {
        NearestHit { place: file_index_of(objects, hit.object), lambda: hit.lambda }
    } else {
        NearestHit::NOTHING
    }
}

/// A kernel that finds the nearest hit of one ray after the other.
struct Find<'a> {
    ours: &'a Ours,
    rays: &'a [PreparedRay],
    hits: &'a mut Vec<NearestHit>,
    stack: &'a mut Stack,
}

impl Kernel for Find<'_> {
    type Output = ();

    #[inline(always)]
    fn call<S: Simd>(self, _: S) {
        let Ours { objects, accel, .. } = self.ours;
        for (index, PreparedRay { ray, start_object }) in self.rays.iter().enumerate() {
            // In a picture, a ray starts on the object that the ray before it has hit, whose record is in the nearest
            // cache. Here the rays are in no order, so the record is asked for while the ray before is traced.
            if let Some(next) = self.rays.get(index + 1) {
                objects.prefetch_sphere(next.start_object as usize);
            }
            let hit = accel.closest_hit::<S, _>(objects, ray, *start_object, self.stack);
            self.hits.push(nearest(objects, &hit));
        }
    }
}
