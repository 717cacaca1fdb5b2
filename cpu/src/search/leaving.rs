//! Rays that leave a convex object do not come back to it.
//!
//! Most rays start on a surface and go outward. With `f(lambda)` the quadratic whose roots are the hits, such a ray has
//! `f` rising past zero before the smallest lambda that counts, `t`: then both roots are below `t`. The test leaves a
//! margin for rounding, so that it holds for the roots as they are computed; where it fails, the exact test decides.

use crate::cylinder::{CylinderRecord, CylinderView};
use crate::ray::LAMBDA_MIN as T;
use crate::sphere::{SphereRecord, SphereView};
use crate::vec3::Vec3;

/// Relative size of the margin: some hundred units in the last place.
const MARGIN: f64 = 128.0 * f64::EPSILON;

/// Whether a ray certainly has no root that counts: past the sphere, or leaving it. `a` is `direction.direction` and
/// `h` the view's product with the direction.
#[inline(always)]
pub fn leaves_sphere(sphere: &SphereRecord, view: &SphereView, a: f64, h: f64) -> bool {
    let margin = MARGIN * (view.c.abs() + 2.0 * sphere.radius_squared);
    (h < 0.0) & (a * (T * T) - 2.0 * T * h + view.c > margin)
}

/// Whether a ray certainly meets no part of the cylinder: it leaves the infinite cylinder, or the slab between the
/// bases. `reach` bounds the coordinates' magnitudes.
#[inline(always)]
pub fn leaves_cylinder(cylinder: &CylinderRecord, view: &CylinderView, direction: Vec3, origin: Vec3) -> bool {
    let (a, h, _) = cylinder.quadratic(view, direction);
    let scale = origin.dot(origin) + cylinder.center.dot(cylinder.center) + cylinder.radius_squared;
    if h > 0.0 && a * (T * T) + 2.0 * T * h + view.c > MARGIN * scale {
        return true;
    }
    let slope = direction.dot(cylinder.axis);
    let margin = MARGIN * (scale.sqrt() + cylinder.half_height);
    (slope > 0.0 && slope * T - view.to_top > margin) || (slope < 0.0 && view.to_bottom - slope * T > margin)
}
