//! Finds the closest hits of many rays, exactly, with the acceleration structure of the renderer.

use std::sync::atomic::{AtomicBool, Ordering};

use cpu::internals::accel::{
    choice::Accel, closest_hit::ClosestHit, extent::Extent, object::NO_OBJECT, object::ObjectRef, stack::Stack,
};
use cpu::internals::input::error::with_room;
use cpu::internals::layout::{Objects, aos::AosObjects};
use cpu::internals::simd::{Kernel, Simd};
use cpu::internals::{Camera, InstructionSet};
use cpu::intersect::CylinderPart;
use cpu::{Error, Ray, Scene, Vec3};

/// The closest hits of rays, with an entry for each ray.
#[derive(Debug)]
pub struct Hits {
    /// The place of the object among all objects of the scene, from 0, or -1 without a hit.
    pub object: Vec<i64>,
    /// The lambda of the hit, in lengths of the ray's direction. It is NaN without a hit.
    pub lambda: Vec<f64>,
    /// Three numbers for each ray: the normal that points out of the object. It has length one, or is NaN
    /// without a hit.
    pub normal: Vec<f64>,
    /// The part of the object: 0 for a sphere or the side of a cylinder, 1 for the cap to which the axis points, 2 for
    /// the other cap, and -1 without a hit.
    pub part: Vec<i8>,
}

/// Returns the objects of `scene` and a structure that is valid for the rays. `origin` and `direction` are the largest
/// magnitudes of components of the rays' origins and directions.
pub fn structure(scene: &Scene, origin: f64, direction: f64) -> Result<(AosObjects, Accel), Error> {
    let mut objects = AosObjects::build(scene)?;
    // The structure is built as for a camera that is as far away as the farthest origin, and has rays as long as the
    // longest direction.
    let position = Vec3::ONE * origin;
    let camera = Camera { position, origin: position + Vec3::ONE * direction, delta_x: Vec3::ONE, delta_y: Vec3::ONE };
    let extent = Extent::new(&objects, &camera, &[]);
    let accel = Accel::new(&mut objects, &extent)?;
    Ok((objects, accel))
}

/// Appends the closest hits of `count` rays to `hits`, and returns the list. `ray` returns the ray with a given index.
/// The hits are incomplete if `stop` becomes true.
pub fn append(
    hits: Hits,
    (objects, accel): &(AosObjects, Accel),
    count: usize,
    ray: impl Fn(usize) -> Ray,
    stop: &AtomicBool,
) -> Hits {
    InstructionSet::chosen().run(Find { objects, accel, count, ray, stop, hits })
}

struct Find<'a, R> {
    objects: &'a AosObjects,
    accel: &'a Accel,
    count: usize,
    ray: R,
    stop: &'a AtomicBool,
    hits: Hits,
}

impl<R: Fn(usize) -> Ray> Kernel for Find<'_, R> {
    type Output = Hits;

    #[inline(always)]
    fn call<S: Simd>(mut self, _: S) -> Hits {
        let mut stack = Stack::EMPTY;
        for index in 0..self.count {
            if self.stop.load(Ordering::Relaxed) {
                break;
            }
            let ray = (self.ray)(index);
            let hit = self.accel.closest_hit::<S, _>(self.objects, &ray, NO_OBJECT, &mut stack);
            self.hits.push(self.objects, &ray, &hit);
        }
        self.hits
    }
}

impl Hits {
    /// Returns an empty list with room for `count` hits.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`] if memory is short.
    pub fn with_room(count: usize) -> Result<Self, Error> {
        Ok(Self {
            object: with_room(count, "the hits")?,
            lambda: with_room(count, "the hits")?,
            normal: with_room(count.saturating_mul(3), "the hits")?,
            part: with_room(count, "the hits")?,
        })
    }

    #[inline(always)]
    fn push(&mut self, objects: &AosObjects, ray: &Ray, hit: &ClosestHit) {
        let none = (-1, Vec3::ONE * f64::NAN, -1);
        let (object, normal, part) = if hit.is_hit() { surface(objects, ray, hit) } else { none };
        self.object.push(object);
        self.lambda.push(if hit.is_hit() { hit.lambda } else { f64::NAN });
        self.normal.extend(normal.to_array());
        self.part.push(part);
    }
}

/// Returns the place of the object that is hit, its normal and its part.
#[inline(always)]
fn surface(objects: &AosObjects, ray: &Ray, hit: &ClosestHit) -> (i64, Vec3, i8) {
    let point = ray.at(hit.lambda);
    match ObjectRef::of(objects, hit.object) {
        ObjectRef::Sphere(index) => {
            let sphere = objects.sphere(index);
            (sphere.order.into(), sphere.record.outward(point), 0)
        }
        ObjectRef::Cylinder(index) => {
            let cylinder = objects.cylinder(index);
            let normal = cylinder.record.outward(hit.part, point);
            // On the side it is as long as the radius.
            let normal = if hit.part == CylinderPart::Side { normal / cylinder.record.radius } else { normal };
            (cylinder.order.into(), normal, hit.part as i8)
        }
    }
}
