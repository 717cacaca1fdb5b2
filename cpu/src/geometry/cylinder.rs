//! Ray against closed cylinder (specification, sections 9.2 and 9.3).
//!
//! The curved side is part of the infinite cylinder `|(O - C)' + d' lambda|^2 = r^2`. A prime marks the part of a
//! vector that is perpendicular to the axis. With `a = d'.d'`, `c = (O - C)'.(O - C)' - r^2` and `b/2 = (O - C)'.d'`,
//! half of the linear coefficient, the roots are `(-b/2 -+ sqrt((b/2)^2 - a c)) / a`. The module of the
//! [sphere](crate::geometry::sphere) explains why this gives the bits of the usual formula. There, and in all of
//! [`exact`](crate::exact), `h` is `-b/2`. A root counts if its point, measured along the axis, is at most half the
//! height from the centre. The caps are discs in the planes at both ends ([`cap`]).

use crate::geometry::{cap, ray::Ray, ray::in_range, tie::later_cap_is_closer};
use crate::math::{real::Real, vec3::Vec3, vec3::broadcast};

/// A cylinder in the form that the formulas use. The terms that do not depend on the ray are computed once.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct CylinderRecord<T = f64> {
    /// The point halfway between the centres of its caps.
    pub center: Vec3<T>,
    /// The direction of the axis towards the top cap, of length one.
    pub axis: Vec3<T>,
    /// The centre of the top cap.
    pub top: Vec3<T>,
    /// The centre of the bottom cap.
    pub bottom: Vec3<T>,
    /// The cylinder's radius, in scene units, positive.
    pub radius: T,
    /// The square of the radius.
    pub radius_squared: T,
    /// Half of the cylinder's height, in scene units, positive.
    pub half_height: T,
}

/// The terms of the cylinder's formula that are constant for all rays from one point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CylinderView<T = f64> {
    /// The vector from the axis to the rays' origin, perpendicular to the axis. The statement calls it
    /// `r_c'`; for a sphere its `r_c` is the opposite, from origin to centre.
    pub from_axis: Vec3<T>,
    /// The square of its length, minus `r^2`, which is negative if the origin is inside the infinite cylinder.
    pub c: T,
    /// `|O - C|^2 + r^2`: the square of the distance from origin to centre, plus the square of the radius.
    pub squares: T,
    /// The distance of the origin, along the axis, from the plane halfway between the caps. It is positive on the side
    /// of the top cap.
    pub along: T,
}

broadcast!(CylinderView: from_axis; c, squares, along);
broadcast!(CylinderRecord: center, axis, top, bottom; radius, radius_squared, half_height);

/// The part of a cylinder that a ray hits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum CylinderPart {
    /// The curved side.
    Side = 0,
    /// The cap that the axis points to.
    Top = 1,
    /// The cap at the end to which the axis does not point.
    Bottom = 2,
}

impl CylinderPart {
    /// Returns the number of the part, in the order side, top, bottom. Lanes hold parts as these numbers.
    #[inline(always)]
    pub fn number<T: Real>(self) -> T {
        T::of(f64::from(self as u32))
    }

    /// Returns the part with this number.
    pub(crate) fn of_number(number: f64) -> Self {
        debug_assert!([0.0, 1.0, 2.0].contains(&number));
        [Self::Side, Self::Top, Self::Bottom][number as usize % 3]
    }
}

impl<T: Real> CylinderRecord<T> {
    /// Returns the record of the cylinder around `center`. The length of `file_axis` is the height of the
    /// cylinder.
    #[inline(always)]
    pub fn new(center: Vec3<T>, radius: T, file_axis: Vec3<T>) -> Self {
        let (unit, height) = file_axis.unit_and_length();
        Self::with_unit_axis(center, radius, unit, height / T::of(2.0))
    }

    /// Returns the record of the cylinder around `center`, for an `axis` of length one.
    #[inline(always)]
    pub fn with_unit_axis(center: Vec3<T>, radius: T, axis: Vec3<T>, half_height: T) -> Self {
        let to_cap = axis * half_height;
        let (top, bottom) = (center + to_cap, center - to_cap);
        Self { center, axis, top, bottom, radius, radius_squared: radius * radius, half_height }
    }

    /// Returns the terms of the formula that are constant for all rays from `origin`.
    #[inline(always)]
    pub fn seen_from(&self, origin: Vec3<T>) -> CylinderView<T> {
        let from_center = origin - self.center;
        let from_axis = from_center.perpendicular_to(self.axis);
        CylinderView {
            from_axis,
            c: from_axis.dot(from_axis) - self.radius_squared,
            squares: from_center.dot(from_center) + self.radius_squared,
            along: from_center.dot(self.axis),
        }
    }

    /// Returns `a`, `b/2` and `(b/2)^2 - a c` of the infinite cylinder's quadratic `a lambda^2 + b lambda + c`. The
    /// last one is a quarter of the discriminant.
    #[inline(always)]
    pub fn quadratic(&self, view: &CylinderView<T>, direction: Vec3<T>) -> (T, T, T) {
        let direction = direction.perpendicular_to(self.axis);
        let a = direction.dot(direction);
        let half_b = view.from_axis.dot(direction);
        (a, half_b, half_b * half_b - a * view.c)
    }

    /// Whether the ray's point at `lambda` lies between the planes of the two caps.
    #[inline(always)]
    pub fn within_height(&self, ray: &Ray<T>, lambda: T) -> T::Mask {
        (ray.at(lambda) - self.center).dot(self.axis).abs().less_equal(self.half_height)
    }

    /// Returns the normal that points out of the cylinder at `point`, a point on `part`. On the side the normal is as
    /// long as the radius (specification, section 9.2). On a cap its length is one.
    #[inline(always)]
    pub fn outward(&self, part: CylinderPart, point: Vec3<T>) -> Vec3<T> {
        match part {
            CylinderPart::Side => (point - self.center).perpendicular_to(self.axis),
            CylinderPart::Top => self.axis,
            CylinderPart::Bottom => -self.axis,
        }
    }

    /// Returns the normals of several points, one in each lane, as [`CylinderRecord::outward`] does. `part` has the
    /// [number](CylinderPart::number) of each point's part.
    #[inline(always)]
    pub(crate) fn outward_lanes(&self, part: T, point: Vec3<T>) -> Vec3<T> {
        let before = |next: CylinderPart| part.less(next.number());
        let cap = Vec3::select(before(CylinderPart::Bottom), self.axis, -self.axis);
        Vec3::select(before(CylinderPart::Top), self.outward(CylinderPart::Side, point), cap)
    }
}

impl<T: Real<Mask = bool>> CylinderRecord<T> {
    /// Returns lambda and part of the closest hit among side, top cap and bottom cap, by the plain formulas. If the ray
    /// hits no part, the result is `None`.
    ///
    /// ```
    /// use cpu::intersect::{CylinderPart, CylinderRecord};
    /// use cpu::{Ray, Vec3};
    ///
    /// let cylinder = CylinderRecord::new(Vec3::ZERO, 1.0, Vec3::new(0.0, 4.0, 0.0));
    /// let ray = Ray { origin: Vec3::new(0.0, 5.0, 0.5), direction: Vec3::new(0.0, -1.0, 0.0) };
    /// assert_eq!(cylinder.intersect(&ray), Some((3.0, CylinderPart::Top)));
    /// ```
    #[inline(always)]
    pub fn intersect(&self, ray: &Ray<T>) -> Option<(T, CylinderPart)> {
        let view = self.seen_from(ray.origin);
        let (a, half_b, discriminant) = self.quadratic(&view, ray.direction);
        let mut nearest = None;
        if !discriminant.less(T::of(0.0)) {
            let sqrt_d = discriminant.sqrt();
            let mut roots = [(-half_b - sqrt_d) / a, (-half_b + sqrt_d) / a].into_iter();
            let side = roots.find(|&lambda| in_range(lambda) && self.within_height(ray, lambda));
            nearest = side.map(|lambda| (lambda, CylinderPart::Side));
        }
        for (center, part) in [(self.top, CylinderPart::Top), (self.bottom, CylinderPart::Bottom)] {
            if let Some(lambda) = cap::intersect(center, self.axis, self.radius, ray)
                && nearest.is_none_or(|(closest, _)| later_cap_is_closer(lambda, closest))
            {
                nearest = Some((lambda, part));
            }
        }
        nearest
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn normals_of_side_and_caps_are_right_also_in_lanes() {
        let record = CylinderRecord::new(Vec3::new(5.0, 6.0, 7.0), 2.0, Vec3::new(0.0, 4.0, 0.0));
        for (part, point, normal) in [
            (CylinderPart::Side, [7.0, 6.5, 7.0], [2.0, 0.0, 0.0]),
            (CylinderPart::Top, [5.0, 8.0, 7.0], [0.0, 1.0, 0.0]),
            (CylinderPart::Bottom, [5.0, 4.0, 7.0], [0.0, -1.0, 0.0]),
        ] {
            let point = Vec3::from(point);
            let normals = [record.outward(part, point), record.outward_lanes(part.number(), point)];
            assert_eq!(normals, [Vec3::from(normal); 2]);
        }
    }

    #[test]
    fn the_record_holds_the_derived_values() {
        let record = CylinderRecord::new(Vec3::ONE, 3.0, Vec3::new(0.0, 0.0, -4.0));
        assert_eq!(record.axis, Vec3::new(0.0, 0.0, -1.0));
        assert_eq!((record.half_height, record.radius_squared), (2.0, 9.0));
        assert_eq!((record.top, record.bottom), (Vec3::new(1.0, 1.0, -1.0), Vec3::new(1.0, 1.0, 3.0)));
        assert_eq!(CylinderRecord::with_unit_axis(Vec3::ONE, 3.0, Vec3::new(0.0, 0.0, -1.0), 2.0), record);
    }

    #[test]
    fn the_quadratic_has_the_two_roots_of_the_infinite_cylinder_and_points_beyond_the_caps_are_known() {
        let upright = CylinderRecord::new(Vec3::ZERO, 1.0, Vec3::new(0.0, 4.0, 0.0));
        // `(3 + lambda)^2 = 1`: the roots are -4 and -2, or `-b/2 -+ 1`.
        let view = upright.seen_from(Vec3::new(3.0, 5.0, 0.0));
        assert_eq!(upright.quadratic(&view, Vec3::new(1.0, 2.0, 0.0)), (1.0, 3.0, 1.0));
        let down = Ray { origin: Vec3::new(0.0, 5.0, 0.0), direction: Vec3::new(0.0, -1.0, 0.0) };
        let within = [2.9, 3.0, 5.0, 7.0, 7.1].map(|lambda| upright.within_height(&down, lambda));
        assert_eq!(within, [false, true, true, true, false]);
    }

    #[test]
    fn the_number_of_a_part_gives_the_part() {
        use CylinderPart::{Bottom, Side, Top};

        assert_eq!([Side, Top, Bottom].map(|part| CylinderPart::of_number(part.number())), [Side, Top, Bottom]);
    }

    #[test]
    fn rays_hit_sides_and_caps_where_they_should() {
        use CylinderPart::{Bottom, Side, Top};

        let upright = CylinderRecord::new(Vec3::ZERO, 1.0, Vec3::new(0.0, 4.0, 0.0));
        for (what, origin, direction, expected) in [
            ("the side from outside", [0.0, 0.0, -3.0], [0.0, 0.0, 1.0], Some((2.0, Side))),
            ("the side from inside", [0.0, 0.0, 0.0], [0.0, 0.0, 1.0], Some((1.0, Side))),
            ("the top from outside", [0.5, 5.0, 0.0], [0.0, -1.0, 0.0], Some((3.0, Top))),
            ("the bottom from outside", [0.5, -5.0, 0.0], [0.0, 1.0, 0.0], Some((3.0, Bottom))),
            ("the top from inside", [0.0, 0.0, 0.0], [0.1, 1.0, 0.0], Some((2.0, Top))),
            ("beyond the rim of the top", [1.1, 5.0, 0.0], [0.0, -1.0, 0.0], None),
            ("above the top", [0.0, 2.1, -3.0], [0.0, 0.0, 1.0], None),
            ("behind", [0.0, 0.0, 3.0], [0.0, 0.0, 1.0], None),
            ("on the rim the cap is not nearer than the side", [0.0, 4.0, -3.0], [0.0, -1.0, 1.0], Some((2.0, Side))),
            // The ray enters the infinite cylinder above the top cap. So the smaller root does not count.
            ("the top from above, at an angle", [0.0, 4.5, -3.0], [0.0, -1.0, 1.0], Some((2.5, Top))),
            // The roots for the side are 0 / 0, but the cap still counts.
            ("along the axis from outside", [0.0, 5.0, 0.0], [0.0, -2.0, 0.0], Some((1.5, Top))),
            ("along the axis from inside", [0.0, 1.0, 0.0], [0.0, 2.0, 0.0], Some((0.5, Top))),
            ("a null direction", [0.0, 1.0, 0.0], [0.0; 3], None),
            ("in the plane of the top", [0.0, 2.0, -3.0], [0.0, 0.0, 1.0], Some((2.0, Side))),
        ] {
            let (origin, direction) = (Vec3::from(origin), Vec3::from(direction));
            assert_eq!(upright.intersect(&Ray { origin, direction }), expected, "{what}");
            // Elsewhere and with a longer or shorter direction, the ray hits the same part.
            let moved = CylinderRecord::new(Vec3::new(8.0, -16.0, 32.0), 1.0, Vec3::new(0.0, 4.0, 0.0));
            for scale in [0.25, 4.0] {
                let ray = Ray { origin: origin + moved.center, direction: direction * scale };
                assert_eq!(moved.intersect(&ray), expected.map(|(lambda, part)| (lambda / scale, part)), "{what}");
            }
        }
    }
}
