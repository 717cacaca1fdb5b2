//! Tests of the closest hits of several rays.

use super::*;
use crate::accel::every_object::intersect_every_object;
use crate::input::scene::Scene;
use crate::layout::aos::AosObjects;
use crate::math::vec3::Vec3;
use crate::sampling::uniform::Uniform;
use crate::simd::instruction_set::InstructionSet;
use crate::simd::{Kernel, Simd};

/// A kernel that finds the closest hit of a ray, the same in all lanes, with a sphere and a cylinder. Returns its
/// lambda, or infinity for a miss.
struct Intersect<'a>(&'a AosObjects, Ray);

impl Kernel for Intersect<'_> {
    type Output = f64;

    #[inline(always)]
    fn call<S: Simd>(self, _: S) -> f64 {
        let Self(objects, ray) = self;
        let ray = ray.lanes::<S::F64>();
        let (rays, mut hits) = (Rays::new(objects, &ray, 1), HitLanes::none());
        let (sphere, cylinder) = (objects.sphere(0).record, objects.cylinder(0).record);
        hits.intersect_sphere(0, &sphere, &sphere.lanes().seen_from(ray.origin), &rays);
        let view = cylinder.lanes().seen_from(ray.origin);
        hits.intersect_cylinder(1, (&cylinder, &objects.file_axis(0)), &view, &rays);
        let mut lambda = [0.0; 8];
        hits.lambda.store(&mut lambda);
        lambda[0]
    }
}

#[test]
fn no_miss_is_certain_where_a_discriminant_may_overflow() {
    assert_eq!([1.0, LARGEST_SQUARES].map(limited), [1.0, f64::INFINITY]);
}

#[test]
fn directions_of_any_length_give_the_closest_hit() {
    let text = "matte: m 1 1 1\nsphere: 0 0 0 2 m\ncylinder: 0 1 5 3 0 4 1 m\n";
    let objects = AosObjects::build(&Scene::parse(text.as_bytes()).expect("it is valid")).expect("it fits");
    let (mut draws, mut hits) = (Uniform::new(9), 0);
    for _ in 0..3000 {
        let mut vector = || Vec3::from([(); 3].map(|()| draws.draw(-4.0, 4.0)));
        let (origin, target) = (vector() * 3.0, vector());
        let direction = (target - origin) * 10.0_f64.powf(draws.draw(-200.0, 200.0));
        let ray = Ray { origin, direction };
        let expected = intersect_every_object(&objects, ray);
        hits += usize::from(expected.is_hit());
        for set in InstructionSet::available() {
            assert_eq!(set.run(Intersect(&objects, ray)), expected.lambda, "{}: {ray:?}", set.name());
        }
    }
    assert!(hits > 500, "{hits}");
}

#[test]
fn rays_that_touch_a_surface_up_to_the_rounding_of_its_radius_have_the_exact_hits() {
    let (mut draws, mut hits) = (Uniform::new(3), [0; 2]);
    for number in 0..2000 {
        let mut vector = || Vec3::from([(); 3].map(|()| draws.draw(-1000.0, 1000.0).round()));
        let (direction, other) = (vector(), vector());
        // The ray touches the sphere, or the side of a cylinder along z. Nothing but the radius is rounded.
        let is_sphere = number % 2 == 0;
        let touched = direction.cross(if is_sphere { other } else { Vec3::new(0.0, 0.0, other.z) });
        let (origin, radius) = (touched - direction * f64::from(1 << (2 + number % 20)), touched.length());
        let [sphere, tube] = if is_sphere { [radius, 1.0] } else { [1.0, radius] };
        let away = "1e12 0 0";
        let [of_sphere, of_tube] = if is_sphere { ["0 0 0", away] } else { [away, "0 0 0"] };
        let text = format!("matte: m 1 1 1\nsphere: {of_sphere} {sphere} m\ncylinder: {of_tube} {tube} 0 0 1e12 m\n");
        // The radius is 0 if both vectors are along one line. Such a scene is refused.
        let Ok(scene) = Scene::parse(text.as_bytes()) else { continue };
        let (objects, ray) = (AosObjects::build(&scene).expect("it fits"), Ray { origin, direction });
        let expected = intersect_every_object(&objects, ray);
        hits[usize::from(is_sphere)] += usize::from(expected.is_hit());
        for set in InstructionSet::available() {
            assert_eq!(set.run(Intersect(&objects, ray)), expected.lambda, "{}: {ray:?}, {text}", set.name());
        }
    }
    // The radius of about half of the objects is rounded up.
    assert!(hits.iter().all(|hits| (300..700).contains(hits)), "{hits:?}");
}
