//! Rays that leave a convex object do not come back to it.
//!
//! Most rays start on a surface and go outward. With `f(lambda)` the quadratic whose roots are the hits, such a ray has
//! `f` rising past zero before the smallest lambda that counts, `t`: then both roots are below `t`. The test leaves a
//! margin for rounding, so that it holds for the roots as they are computed; where it fails, the exact test decides.

use crate::cylinder::{CylinderRecord, CylinderView};
use crate::ray::LAMBDA_MIN as T;
use crate::real::Real;
use crate::vec3::Vec3;

/// Relative size of the margin: some hundred units in the last place.
const MARGIN: f64 = 128.0 * f64::EPSILON;

/// Whether a line certainly misses: the discriminant is below what rounding can make of zero. `size` bounds the
/// products that it is the difference of.
#[inline(always)]
pub fn misses<R: Real>(discriminant: R, size: R) -> R::Mask {
    discriminant.less(size * R::of(-4.0 * MARGIN))
}

/// Whether a ray certainly has no root that counts: past the sphere, or leaving it. `a`, `h` and `c` are the
/// quadratic's, `size` bounds the terms of `c`.
#[inline(always)]
pub fn leaves_sphere<R: Real>(a: R, h: R, c: R, size: R) -> R::Mask {
    h.less(R::of(0.0)) & (size * R::of(MARGIN)).less(a * R::of(T * T) - h * R::of(2.0 * T) + c)
}

/// [`leaves_sphere`] for an infinite cylinder, whose `h` has the other sign.
#[inline(always)]
pub fn leaves_side<R: Real>(a: R, h: R, c: R, size: R) -> R::Mask {
    R::of(0.0).less(h) & (size * R::of(4.0 * MARGIN)).less(a * R::of(T * T) + h * R::of(2.0 * T) + c)
}

/// Whether a ray may be between two planes at a lambda that counts. Its origin is `along` the planes' normal from
/// the middle between them, where it advances by `slope`; the planes are `half_width` from the middle, rounding included.
#[inline(always)]
pub fn crosses_slab<R: Real>(along: R, slope: R, half_width: R) -> R::Mask {
    // Seen in the direction in which the ray advances.
    let from_middle = R::select(slope.less(R::of(0.0)), -along, along);
    !half_width.less(from_middle + slope.abs() * R::of(T))
}

/// Whether a ray certainly meets no part of the cylinder: it leaves the infinite cylinder, or the slab between the
/// bases.
#[inline(always)]
pub fn leaves_cylinder(cylinder: &CylinderRecord, view: &CylinderView, direction: Vec3, origin: Vec3) -> bool {
    let (a, h, _) = cylinder.quadratic(view, direction);
    let size = origin.dot(origin) + cylinder.center.dot(cylinder.center) + cylinder.radius_squared;
    if leaves_side(a, h, view.c, size) {
        return true;
    }
    let along = (origin - cylinder.center).dot(cylinder.axis);
    let slack = 4.0 * MARGIN * (size.sqrt() + cylinder.half_height);
    !crosses_slab(along, direction.dot(cylinder.axis), cylinder.half_height + slack)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ray::Ray;
    use crate::sphere::{SphereRecord, SphereView};

    fn leaves(sphere: &SphereRecord, view: &SphereView, direction: Vec3) -> bool {
        let a = direction.dot(direction);
        leaves_sphere(a, view.quadratic(direction, a).0, view.c, view.c.abs() + 2.0 * sphere.radius_squared)
    }

    use crate::rng::Uniform;

    #[test]
    fn a_ray_that_goes_outward_leaves_and_one_that_goes_inward_does_not() {
        let sphere = SphereRecord::new(Vec3::ZERO, 1.0);
        let view = sphere.seen_from(Vec3::new(0.0, 1.0, 0.0));
        let leaves = |direction: Vec3| leaves(&sphere, &view, direction);
        assert!(leaves(Vec3::new(0.3, 1.0, 0.0)) && leaves(Vec3::new(1.0, 1e-9, 0.0)));
        assert!(!leaves(Vec3::new(0.3, -1.0, 0.0)) && !leaves(Vec3::new(1.0, -1e-9, 0.0)));
    }

    #[test]
    fn a_cylinder_is_left_by_its_side_and_by_its_bases() {
        let cylinder = CylinderRecord::new(Vec3::ZERO, 1.0, Vec3::new(0.0, 4.0, 0.0));
        let leaves = |origin: [f64; 3], direction: [f64; 3]| {
            let origin = Vec3::from(origin);
            leaves_cylinder(&cylinder, &cylinder.seen_from(origin), direction.into(), origin)
        };
        assert!(leaves([1.0, 0.0, 0.0], [1.0, 0.5, 0.0]));
        assert!(leaves([0.5, 2.0, 0.0], [0.1, 1.0, 0.0]));
        assert!(leaves([0.5, -2.0, 0.0], [0.1, -1.0, 0.0]));
        assert!(!leaves([1.0, 0.0, 0.0], [-1.0, 0.5, 0.0]));
        assert!(!leaves([0.5, 2.0, 0.0], [0.1, -1.0, 0.0]));
    }

    #[test]
    fn what_leaves_is_never_met() {
        let mut draws = Uniform::new(21);
        let (mut left, mut met) = (0, 0);
        for _ in 0..20_000 {
            let size = 10.0_f64.powf(draws.draw(-3.0, 6.0));
            let sphere = SphereRecord::new([(); 3].map(|()| draws.draw(-1e3, 1e3)).into(), size);
            let normal = Vec3::from([(); 3].map(|()| draws.draw(-1.0, 1.0))).unit();
            let origin = sphere.center + normal * size;
            // Grazing directions, where the test is hardest.
            let direction = Vec3::from([(); 3].map(|()| draws.draw(-1.0, 1.0))).perpendicular_to(normal)
                + normal * (draws.draw(-1.0, 1.0) * 10.0_f64.powf(draws.draw(-12.0, 0.0)));
            let ray = Ray { origin, direction };
            let view = sphere.seen_from(origin);
            let leaves = leaves(&sphere, &view, direction);
            left += u32::from(leaves);
            met += u32::from(!leaves);
            if leaves {
                assert_eq!(sphere.intersect(&ray), None);
                assert_eq!(crate::certified::sphere::intersect(&sphere, &ray), None);
            }
        }
        assert!(left > 5000 && met > 5000, "{left} leave, {met} do not");
    }
}
