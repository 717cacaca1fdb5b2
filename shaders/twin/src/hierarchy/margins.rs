//! Boxes around objects, and the margins by which `hierarchy.wgsl` enlarges them for each ray, so that they contain
//! every point that the plain formulas may report.
//!
//! Let `u` be the unit roundoff of the precision, `q` the square of the distance from the ray's origin to the object's
//! centre, `R` the radius, `H` the half height and `d` the direction.
//!
//! **Spheres.** The error of the computed discriminant is less than `24 u M`, with `M = d.d (q + R^2)` (docs/margins.md
//! proves 21). The exact discriminant changes by `d.d e` if the square of the radius changes by `e`. So the computed
//! discriminant is that of a sphere whose radius has at most the square `R^2 + 24 u (q + R^2)`. The rounding of the
//! root, the numerator and the quotient moves the point by at most `48 u sqrt(q + R^2)` besides.
//!
//! **Sides of cylinders.** Across the axis, the point at a computed lambda has a distance from the axis whose square is
//! `R^2 + f`, where `f` is the value of the exact quadratic there. The point is between the caps, so `lambda |d|` is at
//! most `sqrt(q) + R + H`. The computed coefficients of the quadratic are wrong by `12 u d.d`, `16 u |d| sqrt(q)` and
//! `16 u (q + R^2)`. The coefficient `a` is the square of the computed vector across the axis, and `h` is the product
//! of this vector and the one from the centre. So `h^2 / a` is at most `q`, even if the ray is parallel to the axis and
//! both numbers consist of rounding errors. The rounding of the discriminant and of lambda therefore changes `f` by at
//! most `32 u (q + R^2)`. Together `f` is at most `160 u (q + R^2 + H^2)`.
//!
//! **Caps.** The point is on the computed disc. Its distance from the cap's plane is due to the errors of the plane's
//! distance and of the slope, at most `16 u (sqrt(q) + R + H)`.
//!
//! **The margins.** Let `F` be the distance from the origin to the farthest corner of the object's box. Then
//! `q + R^2 + H^2 <= F^2`, because along each axis the corner is farther than the centre by half the size of the box. A
//! radius whose square grows by `k u F^2` grows by at most `sqrt(k u) F`, and by at most `k u F^2 / (2 R)`. `k` is 32
//! for spheres and 192 for cylinders. The box of a node serves with the largest of these factors of its objects. For
//! points, 64 `u` of the distance and of the coordinates are added. The factors leave room for the rounding of the
//! margins themselves, which are computed in f32.

use crate::Precision;
use cpu::Vec3;
use cpu::internals::accel::bounds::Bounds;
use cpu::internals::geometry::cylinder::CylinderRecord;
use cpu::internals::geometry::sphere::SphereRecord;

use crate::Float;

/// The margins in the square of a radius, in units of `u F^2`.
const SPHERE: f64 = 32.0;
const CYLINDER: f64 = 192.0;
/// The margin of a point, in units of `u` times distances and coordinates.
const POINT: f64 = 64.0;
/// The largest coordinate for which boxes are tested. With it and the limits of directions, no product in f32
/// overflows.
const LARGEST: f32 = 1e9;
/// The smallest radius for which boxes are tested. With it no error by underflow is larger than the margins.
const SMALLEST: f64 = 1e-6;

/// The margins of formulas in one precision.
#[derive(Clone, Copy, Debug)]
pub struct Margins {
    unit_roundoff: f64,
    /// The margin of a point, in units of distances and coordinates.
    pub point: f32,
    /// The largest coordinate of an origin for which boxes are tested.
    pub largest: f32,
}

/// The largest growth of the radii in a box, by the rounding of the formulas.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Growth {
    /// The growth in units of the distance.
    pub linear: f32,
    /// The growth in units of the squared distance.
    pub bend: f32,
}

impl Growth {
    fn new(square: f64, radius: f64) -> Self {
        Self { linear: square.sqrt() as f32, bend: (square / (2.0 * radius)) as f32 }
    }

    /// Returns a growth that is at least both.
    pub fn union(&self, other: &Self) -> Self {
        Self { linear: self.linear.max(other.linear), bend: self.bend.max(other.bend) }
    }
}

impl Margins {
    /// Returns the margins of formulas in this precision.
    pub fn new(precision: Precision) -> Self {
        let unit_roundoff = match precision {
            Precision::F32 => f64::from(f32::EPSILON) / 2.0,
            Precision::F64 => f64::EPSILON / 2.0,
        };
        Self { unit_roundoff, point: (POINT * unit_roundoff) as f32, largest: LARGEST }
    }

    /// Switches the test of boxes off if the scene's largest coordinate is too large, or its smallest radius too small.
    pub fn limit(&mut self, largest: f32, smallest: f64) {
        // The comparison fails for NaN, and then no box is tested.
        let is_moderate = largest <= LARGEST && smallest >= SMALLEST;
        self.largest = if is_moderate { LARGEST } else { 0.0 };
    }

    /// Returns the box around a sphere, and the growth of its radius.
    pub fn of_sphere<T: Float>(&self, record: &SphereRecord<T>) -> (Bounds, Growth) {
        let radius = record.radius.wide();
        let bounds = around(record.center.map(Float::wide), Vec3::splat(radius));
        (bounds, Growth::new(SPHERE * self.unit_roundoff, radius))
    }

    /// Returns the box around a cylinder, and the growth of its radius.
    pub fn of_cylinder<T: Float>(&self, record: &CylinderRecord<T>) -> (Bounds, Growth) {
        let (radius, half_height) = (record.radius.wide(), record.half_height.wide());
        let [x, y, z] = record.axis.map(Float::wide).to_array();
        let half = |along: f64, one: f64, other: f64| half_height * along.abs() + radius * one.hypot(other);
        let half_size = Vec3::new(half(x, y, z), half(y, z, x), half(z, x, y));
        (around(record.center.map(Float::wide), half_size), Growth::new(CYLINDER * self.unit_roundoff, radius))
    }
}

/// Returns the box around `center` with this half size, rounded outward.
fn around(center: Vec3, half_size: Vec3) -> Bounds {
    let (center, half) = (center.to_array(), half_size.to_array());
    Bounds {
        low: std::array::from_fn(|axis| ((center[axis] - half[axis]) as f32).next_down()),
        high: std::array::from_fn(|axis| ((center[axis] + half[axis]) as f32).next_up()),
    }
}
