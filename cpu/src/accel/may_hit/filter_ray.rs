//! Tests one ray against several bounding spheres and infinite cylinders at once, in single precision.
//!
//! With the ray `O + lambda d` and a bounding sphere of radius `R` around `C`, the quadratic is `a lambda^2 - 2 h
//! lambda + c` with `a = d.d`, `h = d.C - d.O` and `c = (|C|^2 - R^2) - 2 O.C + |O|^2`. The formulas for `h` and `c`
//! are multiplied out, so that few operations depend on both ray and object. Take a cylinder in that sphere, of radius
//! `r` around the axis `n`. Its quadratic uses only the parts of the vectors across the axis: `a' = a - (d.n)^2`, `h' =
//! h - (d.n) ((C - O).n)` and `c' = c + (R^2 - r^2) - ((C - O).n)^2`. Here `R^2 - r^2` is the square of half the
//! height.
//!
//! Formulas that are multiplied out lose digits to cancellation. The margins cover this loss (docs/margins.md).
//!
//! Each test returns a number that is positive if the ray certainly misses the object. The maximum of two tests is
//! positive if one of them is, and saves a comparison. A NaN is not positive, so [`misses`] keeps its object.
//!
//! A direction may have any length that is not [too short](crate::accel::may_hit::conservative::is_too_short). For
//! example, the normal of a cylinder's side is as long as the radius. Refraction there gives a direction about as long
//! as the index times the square of the radius. With a long direction a product may overflow, and the test may report a
//! miss. The miss is right, for this reason. Let `L` be the [largest
//! coordinate](crate::accel::extent::Extent::max_coordinate) of the scene. The ray's origin and the points of objects
//! are at most `3.5 L` apart. So a ray with `|d| > 3500 L` is past all objects at the smallest lambda in range, 10^-3.
//! For a shorter direction nothing overflows (`tests/stability/src/proof/magnitudes.rs`).

use crate::accel::may_hit::target::Target;
use crate::{geometry::ray::LAMBDA_MIN, geometry::ray::Ray, math::vec3::Vec3, simd::SimdF32};

/// The largest coordinate of a scene for which the tests of [`FilterRay`] are valid, in scene units. A scene with
/// larger coordinates gets another acceleration structure.
pub const MAX_COORDINATE: f64 = 2e7;

/// Number of objects in a block. It is a multiple of every instruction set's number of lanes.
pub const BLOCK: usize = 16;

/// Half a unit in the last place of 1: the relative error of one rounding to single precision.
const F32_ROUNDOFF: f64 = f32::EPSILON as f64 / 2.0;
/// The margin by which a bounding sphere's `c` is lowered, relative to `|C|^2 + |O|^2 + R^2`.
pub const SPHERE_MARGIN: f64 = 128.0 * F32_ROUNDOFF;
/// The margin by which an infinite cylinder's discriminant is increased, relative to `a (|C|^2 + |O|^2 + R^2)`. It is
/// larger than [`SPHERE_MARGIN`], because the terms have lost digits in one more cancellation.
pub const CYLINDER_MARGIN: f64 = 384.0 * F32_ROUNDOFF;

/// One number for each object of a block.
type Row = [f32; BLOCK];

/// A block of bounding spheres. Coordinates are relative to the scene's middle.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub struct BoundingSpheres {
    /// `-2 C`, one row for each component.
    minus_two_center: [Row; 3],
    /// `|C|^2 - R^2`, less the part of the margin that is proportional to `|C|^2 + R^2`.
    constant: Row,
}

/// A block of infinite cylinders. Their bounding spheres are stored separately. The test doubles all its terms. So the
/// axes have length `sqrt(2)`, which doubles a product of two dot products with an axis.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub struct InfiniteCylinders {
    /// `sqrt(2) n`, one row for each component.
    axis: [Row; 3],
    /// `-sqrt(2) C.n`.
    minus_center_along: Row,
    /// `2 (R^2 - r^2)`.
    two_half_height_squared: Row,
    /// `|C|^2 + R^2`, to which a part of the margin is proportional.
    size: Row,
}

impl BoundingSpheres {
    /// A block without objects. The flat filter ignores the results of lanes without an object.
    pub const EMPTY: Self = Self { minus_two_center: [[0.0; BLOCK]; 3], constant: [f32::INFINITY; BLOCK] };

    /// Sets the sphere in a lane. `center` is relative to the scene's middle.
    pub fn set(&mut self, lane: usize, center: Vec3, radius_squared: f64) {
        for (row, component) in self.minus_two_center.iter_mut().zip(center.to_array()) {
            row[lane] = (-2.0 * component) as f32;
        }
        let constant = center.dot(center) * (1.0 - SPHERE_MARGIN) - radius_squared * (1.0 + SPHERE_MARGIN);
        self.constant[lane] = constant as f32;
    }
}

impl InfiniteCylinders {
    /// A block without objects.
    pub const EMPTY: Self = Self {
        axis: [[0.0; BLOCK]; 3],
        minus_center_along: [0.0; BLOCK],
        two_half_height_squared: [0.0; BLOCK],
        size: [0.0; BLOCK],
    };

    /// Sets the cylinder in a lane. `center` is relative to the scene's middle.
    pub fn set(&mut self, lane: usize, center: Vec3, target: &Target) {
        let axis = target.axis * std::f64::consts::SQRT_2;
        for (row, component) in self.axis.iter_mut().zip(axis.to_array()) {
            row[lane] = component as f32;
        }
        self.minus_center_along[lane] = -center.dot(axis) as f32;
        self.two_half_height_squared[lane] = (2.0 * target.half_height * target.half_height) as f32;
        self.size[lane] = (center.dot(center) + target.bounding_radius_squared) as f32;
    }
}

/// One ray, the same in all lanes, relative to the scene's middle, with the products that all objects need.
pub struct FilterRay<F> {
    origin: [F; 3],
    direction: [F; 3],
    two_a: F,
    four_a: F,
    /// `2 d.O`.
    two_d_o: F,
    /// `|O|^2`, less the part of the spheres' margin that is proportional to it.
    constant: F,
    /// `a t^2`, where `t` is the smallest lambda in range.
    a_t_t: F,
    /// The cylinders' margin for each unit of `|C|^2 + R^2 + |O|^2`. It is multiplied by 4, because the test computes
    /// four times the discriminant.
    margin: F,
    /// The part of the cylinders' margin that is proportional to `|O|^2`.
    origin_margin: F,
}

/// The result of the test of several bounding spheres, with two numbers that the test of cylinders uses again.
pub struct SphereTest<F> {
    minus_two_h: F,
    c: F,
    /// A number that is positive where the ray certainly has no point in the sphere at a lambda in range. See
    /// [`misses`].
    pub miss: F,
}

impl<F: SimdF32> FilterRay<F> {
    /// Prepares the ray. `middle` is the scene's middle.
    #[inline(always)]
    pub fn new(ray: &Ray, middle: Vec3) -> Self {
        let (origin, direction) = (in_all_lanes(ray.origin - middle), in_all_lanes(ray.direction));
        let a: F = number(ray.direction.dot(ray.direction));
        let (distance_squared, d_o, two_a) = (dot(origin, origin), dot(direction, origin), a + a);
        let margin = a * number(4.0 * CYLINDER_MARGIN);
        Self {
            origin,
            direction,
            two_a,
            four_a: two_a + two_a,
            two_d_o: d_o + d_o,
            constant: distance_squared * number(1.0 - SPHERE_MARGIN),
            a_t_t: a * number(LAMBDA_MIN * LAMBDA_MIN),
            margin,
            origin_margin: margin * distance_squared,
        }
    }

    /// Tests the bounding spheres of a block from index `at` on, one in each lane.
    #[inline(always)]
    pub fn spheres(&self, spheres: &BoundingSpheres, at: usize) -> SphereTest<F> {
        let minus_two_center = load(&spheres.minus_two_center, at);
        let minus_two_h = plus_dot(self.two_d_o, self.direction, minus_two_center);
        let c = plus_dot(F::load(&spheres.constant[at..]) + self.constant, self.origin, minus_two_center);
        let minus_discriminant = minus_two_h.negative_mul_add(minus_two_h, self.four_a * c);
        // A ray misses if its line misses. It also misses if the centre is behind the ray and the ray's first point in
        // range is outside the sphere. If `minus_two_h` is NaN, `at_first` is NaN too. `min` and `max` return their
        // second operand if one of the two is NaN.
        let at_first = minus_two_h.mul_add(number(LAMBDA_MIN), self.a_t_t) + c;
        SphereTest { minus_two_h, c, miss: minus_discriminant.max(minus_two_h.min(at_first)) }
    }

    /// Tests the infinite cylinders of a block from index `at` on, one in each lane. `spheres` is the test of their
    /// bounding spheres. Returns a number that is positive where the ray certainly misses the cylinder. See [`misses`].
    #[inline(always)]
    pub fn cylinders(&self, spheres: &SphereTest<F>, cylinders: &InfiniteCylinders, at: usize) -> F {
        let axis = load(&cylinders.axis, at);
        let slope = dot(self.direction, axis);
        let origin_along = plus_dot(F::load(&cylinders.minus_center_along[at..]), self.origin, axis);
        let two_a = slope.negative_mul_add(slope, self.two_a);
        let minus_two_h = slope.negative_mul_add(origin_along, spheres.minus_two_h);
        let two_c = spheres.c.mul_add(number(2.0), F::load(&cylinders.two_half_height_squared[at..]));
        let two_c = origin_along.negative_mul_add(origin_along, two_c);
        let margin = F::load(&cylinders.size[at..]).mul_add(self.margin, self.origin_margin);
        minus_two_h.negative_mul_add(minus_two_h, two_a * two_c) - margin
    }
}

/// Returns a bit for each lane, which is 1 if `miss` is positive, so that the ray certainly misses the object.
/// [`SimdF32`] has only the comparison `<=`. So the smallest positive number is compared with `miss`.
#[inline(always)]
pub(crate) fn misses<F: SimdF32>(miss: F) -> u32 {
    const LEAST_POSITIVE: f32 = f32::from_bits(1);
    F::splat(LEAST_POSITIVE).less_equal(miss)
}

/// Returns `value` in every lane.
#[inline(always)]
fn number<F: SimdF32>(value: f64) -> F {
    F::splat(value as f32)
}

/// Returns `vector` in every lane.
#[inline(always)]
fn in_all_lanes<F: SimdF32>(vector: Vec3) -> [F; 3] {
    [number(vector.x), number(vector.y), number(vector.z)]
}

/// Returns the vectors from index `at` on, one in each lane.
#[inline(always)]
fn load<F: SimdF32>([x, y, z]: &[Row; 3], at: usize) -> [F; 3] {
    [F::load(&x[at..]), F::load(&y[at..]), F::load(&z[at..])]
}

#[inline(always)]
fn dot<F: SimdF32>([x, y, z]: [F; 3], other: [F; 3]) -> F {
    z.mul_add(other[2], y.mul_add(other[1], x * other[0]))
}

#[inline(always)]
fn plus_dot<F: SimdF32>(term: F, [x, y, z]: [F; 3], other: [F; 3]) -> F {
    z.mul_add(other[2], y.mul_add(other[1], x.mul_add(other[0], term)))
}
