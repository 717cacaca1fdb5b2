//! A search for scenes of a handful of objects: all of them at once, in double precision.
//!
//! A sphere is an infinite cylinder without an axis: with the axis null, the component perpendicular to it is the whole
//! vector, to the bit. So one quadratic serves both kinds, with the bits of the exact formulas, and decides which
//! objects are asked.

use super::{Found, ObjectId};
use crate::certified::Intersect;
use crate::layout::Objects;
use crate::ray::{LAMBDA_MIN, Ray};
use crate::simd::{LaneMask, Lanes, Simd};
use crate::vec3::Vec3;

/// Most objects; every instruction set's lanes divide it.
pub const CAPACITY: usize = 8;

/// Relative size of the margins: some hundred units in the last place.
const MARGIN: f64 = 512.0 * f64::EPSILON;

/// A value of every object.
type Values = [f64; CAPACITY];

/// The objects, a lane each.
#[derive(Clone, Debug)]
#[repr(align(64))]
pub struct Few {
    center: [Values; 3],
    /// Null for a sphere.
    axis: [Values; 3],
    radius_squared: Values,
    /// Of the bounding sphere.
    bound_squared: Values,
    /// Lanes that hold an object, as bits.
    present: u32,
    /// The objects in the order of the file.
    in_order: Vec<ObjectId>,
}

impl Few {
    /// The search over `objects`, of which there are at most eight.
    #[must_use]
    pub fn new(objects: &impl Objects) -> Self {
        let mut few = Self {
            center: [[0.0; CAPACITY]; 3],
            axis: [[0.0; CAPACITY]; 3],
            radius_squared: [0.0; CAPACITY],
            bound_squared: [0.0; CAPACITY],
            present: 0,
            in_order: super::in_order(objects),
        };
        for index in 0..objects.sphere_count() {
            let record = objects.sphere(index).record;
            few.set(record.center, Vec3::ZERO, record.radius_squared, record.radius_squared);
        }
        for index in 0..objects.cylinder_count() {
            let record = objects.cylinder(index).record;
            let bound = record.radius_squared + record.half_height * record.half_height;
            few.set(record.center, record.axis, record.radius_squared, bound * (1.0 + 1e-7));
        }
        few
    }

    fn set(&mut self, center: Vec3, axis: Vec3, radius_squared: f64, bound_squared: f64) {
        let lane = self.present.count_ones() as usize;
        for (values, value) in self.center.iter_mut().zip(center.to_array()) {
            values[lane] = value;
        }
        for (values, value) in self.axis.iter_mut().zip(axis.to_array()) {
            values[lane] = value;
        }
        self.radius_squared[lane] = radius_squared;
        self.bound_squared[lane] = bound_squared;
        self.present |= 1 << lane;
    }

    /// The objects in the order of the file.
    #[must_use]
    pub fn in_order(&self) -> &[ObjectId] {
        &self.in_order
    }

    /// The nearest object that a ray meets.
    #[inline(always)]
    pub fn nearest<S: Simd, O: Objects, P: Intersect>(&self, objects: &O, ray: &Ray) -> Found {
        let mut found = Found::NOTHING;
        let mut bits = 0;
        for at in (0..CAPACITY).step_by(S::Narrow::LANES) {
            if self.present >> at != 0 {
                bits |= self.meets::<S::Narrow>(ray, at) << at;
            }
        }
        bits &= self.present;
        let spheres = objects.sphere_count();
        while bits != 0 {
            let id = bits.trailing_zeros() as usize;
            bits &= bits - 1;
            match id.checked_sub(spheres) {
                None => found.ask_sphere::<O, P>(objects, id, ray),
                Some(index) => found.ask_cylinder::<O, P>(objects, index, ray),
            }
        }
        found
    }

    /// The objects from lane `at` on that the ray may meet, as bits.
    #[inline(always)]
    fn meets<V: Lanes>(&self, ray: &Ray, at: usize) -> u32 {
        const T: f64 = LAMBDA_MIN;
        let zero = V::of(0.0);
        let (center, axis) = (load::<V>(&self.center, at), load::<V>(&self.axis, at));
        let (radius_squared, bound_squared) = (V::load(&self.radius_squared[at..]), V::load(&self.bound_squared[at..]));
        let direction = ray.direction.map(V::of);
        let from_center = ray.origin.map(V::of) - center;
        // The infinite cylinder, or the sphere.
        let d = direction.perpendicular_to(axis);
        let r_c = from_center.perpendicular_to(axis);
        let a = d.dot(d);
        let h = r_c.dot(d);
        let c = r_c.dot(r_c) - radius_squared;
        // The whole of direction and distance bounds what cancellation may have left of a cylinder's.
        let whole_a = direction.dot(direction);
        let whole_h = from_center.dot(direction);
        let whole_q = from_center.dot(from_center);
        let size = whole_q + radius_squared;
        let touches = zero.less_equal(h * h - a * c + whole_a * size * V::of(MARGIN));
        let bound = whole_h * whole_h - whole_a * (whole_q - bound_squared);
        let near = zero.less_equal(bound + whole_a * size * V::of(MARGIN));
        // See `leaving`: past the smallest lambda that counts, the quadratic stays positive.
        let leaves = zero.less(h) & (size * V::of(MARGIN)).less(a * V::of(T * T) + h * V::of(2.0 * T) + c);
        (touches & near & !leaves).bits()
    }
}

#[inline(always)]
fn load<V: Lanes>([x, y, z]: &[Values; 3], at: usize) -> Vec3<V> {
    Vec3::new(V::load(&x[at..]), V::load(&y[at..]), V::load(&z[at..]))
}

/// Whether a scene of this many objects is searched like this.
#[must_use]
pub fn suits(objects: &impl Objects) -> bool {
    objects.sphere_count() + objects.cylinder_count() <= CAPACITY
}

/// The objects' positions in the search are their lanes.
const _: () = assert!(CAPACITY <= ObjectId::BITS as usize);
