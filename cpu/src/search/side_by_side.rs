//! A handful of objects side by side: which of them one ray may meet, an object a lane.

use super::few::{misses_cylinder, misses_sphere};
use crate::cylinder::CylinderRecord;
use crate::layout::Objects;
use crate::ray::Ray;
use crate::simd::{LaneMask, Lanes};
use crate::sphere::SphereRecord;
use crate::vec3::Vec3;

/// Places for objects of a kind; every instruction set's lanes divide it.
const PLACES: usize = super::few::CAPACITY;

/// A number of each object of a kind.
type Row = [f64; PLACES];

/// The objects, a place each; places that are left over repeat the first one.
#[derive(Clone, Debug)]
pub struct SideBySide {
    sphere_count: usize,
    spheres: SphereRecord<Row>,
    cylinder_count: usize,
    cylinders: CylinderRecord<Row>,
}

impl SideBySide {
    /// The objects, of each kind at most [`PLACES`].
    pub fn new(objects: &impl Objects) -> Self {
        let sphere_count = objects.sphere_count();
        let sphere = |index| objects.sphere(index).record;
        let spheres = SphereRecord {
            center: rows(sphere_count, |index| sphere(index).center),
            radius: row(sphere_count, |index| sphere(index).radius),
            radius_squared: row(sphere_count, |index| sphere(index).radius_squared),
        };
        let cylinder_count = objects.cylinder_count();
        let cylinder = |index| objects.cylinder(index).record;
        let cylinders = CylinderRecord {
            center: rows(cylinder_count, |index| cylinder(index).center),
            axis: rows(cylinder_count, |index| cylinder(index).axis),
            top: rows(cylinder_count, |index| cylinder(index).top),
            bottom: rows(cylinder_count, |index| cylinder(index).bottom),
            radius: row(cylinder_count, |index| cylinder(index).radius),
            radius_squared: row(cylinder_count, |index| cylinder(index).radius_squared),
            half_height: row(cylinder_count, |index| cylinder(index).half_height),
        };
        Self { sphere_count, spheres, cylinder_count, cylinders }
    }

    /// The objects that a ray, which starts within the scene's reach, may meet: a bit each by its
    /// [id](super::ObjectId). `slack` is how far rounding may move a point.
    #[inline(always)]
    pub fn touched<V: Lanes>(&self, ray: &Ray, slack: f64) -> u32 {
        let ray = Ray { origin: ray.origin.map(V::of), direction: ray.direction.map(V::of) };
        let a = ray.direction.dot(ray.direction);
        let (mut spheres, mut cylinders) = (0, 0);
        for at in (0..self.sphere_count).step_by(V::LANES) {
            spheres |= (!misses_sphere(&sphere_lanes::<V>(&self.spheres, at), &ray, a)).bits() << at;
        }
        for at in (0..self.cylinder_count).step_by(V::LANES) {
            cylinders |= (!misses_cylinder(&cylinder_lanes::<V>(&self.cylinders, at), &ray, a, slack)).bits() << at;
        }
        let first = |count: usize| (1_u32 << count) - 1;
        (spheres & first(self.sphere_count)) | (cylinders & first(self.cylinder_count)) << self.sphere_count
    }
}

/// A number of each of `count` objects.
fn row(count: usize, number: impl Fn(usize) -> f64) -> Row {
    std::array::from_fn(|place| if count == 0 { 0.0 } else { number(if place < count { place } else { 0 }) })
}

/// A vector of each of `count` objects.
fn rows(count: usize, vector: impl Fn(usize) -> Vec3) -> Vec3<Row> {
    Vec3::new(
        row(count, |index| vector(index).x),
        row(count, |index| vector(index).y),
        row(count, |index| vector(index).z),
    )
}

/// The vectors from `at` on, a lane each.
#[inline(always)]
fn vector_lanes<V: Lanes>(Vec3 { x, y, z }: &Vec3<Row>, at: usize) -> Vec3<V> {
    Vec3::new(V::load(&x[at..]), V::load(&y[at..]), V::load(&z[at..]))
}

/// The spheres from `at` on, a lane each.
#[inline(always)]
fn sphere_lanes<V: Lanes>(rows: &SphereRecord<Row>, at: usize) -> SphereRecord<V> {
    SphereRecord {
        center: vector_lanes(&rows.center, at),
        radius: V::load(&rows.radius[at..]),
        radius_squared: V::load(&rows.radius_squared[at..]),
    }
}

/// The cylinders from `at` on, a lane each.
#[inline(always)]
fn cylinder_lanes<V: Lanes>(rows: &CylinderRecord<Row>, at: usize) -> CylinderRecord<V> {
    CylinderRecord {
        center: vector_lanes(&rows.center, at),
        axis: vector_lanes(&rows.axis, at),
        top: vector_lanes(&rows.top, at),
        bottom: vector_lanes(&rows.bottom, at),
        radius: V::load(&rows.radius[at..]),
        radius_squared: V::load(&rows.radius_squared[at..]),
        half_height: V::load(&rows.half_height[at..]),
    }
}
