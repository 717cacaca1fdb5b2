//! Ray against closed cylinder (statement, section 3.4.2).
//!
//! The curved side is part of the infinite cylinder `|r_c' + d' lambda|^2 = r^2`, where `'` takes the component
//! perpendicular to the axis and `r_c = O - C`. With `h = r_c'.d'`, half of the statement's `b`, its roots are
//! `(-h -+ sqrt(h^2 - a c)) / a`. The module of the [sphere](crate::geometry::sphere) explains why `h` gives the same
//! bits as `b`. A root counts if its point, measured along the axis, is at most half the height from the centre. The
//! caps are discs in the planes at both ends.

use crate::geometry::ray::{Ray, in_range};
use crate::math::real::Real;
use crate::math::vec3::Vec3;

/// A plane whose direction and the ray's have a smaller product than this is never met (statement, 3.4.2).
pub const PARALLEL: f64 = 1e-8;

/// A cylinder with what its rays need computed once.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct CylinderRecord<T = f64> {
    /// The point halfway between the centres of its bases.
    pub center: Vec3<T>,
    /// Its axis, of length one, towards the upper base.
    pub axis: Vec3<T>,
    /// The centre of the upper base.
    pub top: Vec3<T>,
    /// The centre of the lower base.
    pub bottom: Vec3<T>,
    /// Its radius, positive.
    pub radius: T,
    /// Its radius squared.
    pub radius_squared: T,
    /// Half its height, positive.
    pub half_height: T,
}

/// What the rays from one point share: they need only their directions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CylinderView<T = f64> {
    /// From the centre to the origin, perpendicular to the axis.
    pub r_c: Vec3<T>,
    /// `r_c.r_c - r^2`: negative inside the infinite cylinder.
    pub c: T,
    /// The squares of the distance to the centre and of the radius, together.
    pub squares: T,
    /// How far the origin is along the axis from the plane halfway between the bases.
    pub along: T,
    /// From the origin to the upper base's plane, along the axis.
    pub to_top: T,
    /// From the origin to the lower base's plane, along the axis.
    pub to_bottom: T,
}

impl CylinderView {
    /// The same in every lane.
    #[inline(always)]
    #[must_use]
    pub fn lanes<V: Real>(&self) -> CylinderView<V> {
        CylinderView {
            r_c: self.r_c.map(V::of),
            c: V::of(self.c),
            squares: V::of(self.squares),
            along: V::of(self.along),
            to_top: V::of(self.to_top),
            to_bottom: V::of(self.to_bottom),
        }
    }
}

impl CylinderRecord {
    /// The same in every lane.
    #[inline(always)]
    #[must_use]
    pub fn lanes<V: Real>(&self) -> CylinderRecord<V> {
        CylinderRecord {
            center: self.center.map(V::of),
            axis: self.axis.map(V::of),
            top: self.top.map(V::of),
            bottom: self.bottom.map(V::of),
            radius: V::of(self.radius),
            radius_squared: V::of(self.radius_squared),
            half_height: V::of(self.half_height),
        }
    }
}

/// The part of a cylinder that a ray meets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum CylinderPart {
    /// The curved side.
    Side = 0,
    /// The base that the axis points to.
    Top = 1,
    /// The other base.
    Bottom = 2,
}

impl<T: Real> CylinderRecord<T> {
    /// The record of the cylinder whose `axis` is as long as it is high.
    #[inline(always)]
    #[must_use]
    pub fn new(center: Vec3<T>, radius: T, axis: Vec3<T>) -> Self {
        let (unit, height) = axis.unit_and_length();
        let half_height = height / T::of(2.0);
        let reach = unit * half_height;
        let (top, bottom) = (center + reach, center - reach);
        Self { center, axis: unit, top, bottom, radius, radius_squared: radius * radius, half_height }
    }

    /// The cylinder as rays from `origin` see it.
    #[inline(always)]
    #[must_use]
    pub fn seen_from(&self, origin: Vec3<T>) -> CylinderView<T> {
        let from_center = origin - self.center;
        let r_c = from_center.perpendicular_to(self.axis);
        CylinderView {
            r_c,
            c: r_c.dot(r_c) - self.radius_squared,
            squares: from_center.dot(from_center) + self.radius_squared,
            along: from_center.dot(self.axis),
            to_top: (self.top - origin).dot(self.axis),
            to_bottom: (self.bottom - origin).dot(self.axis),
        }
    }

    /// `a`, half of `b` and a quarter of the discriminant of the quadratic with the infinite cylinder.
    #[inline(always)]
    #[must_use]
    pub fn quadratic(&self, view: &CylinderView<T>, direction: Vec3<T>) -> (T, T, T) {
        let direction = direction.perpendicular_to(self.axis);
        let a = direction.dot(direction);
        let h = view.r_c.dot(direction);
        (a, h, h * h - a * view.c)
    }

    /// How far the point at `lambda` is along the axis from the plane halfway between the bases.
    #[inline(always)]
    #[must_use]
    pub fn along(&self, ray: &Ray<T>, lambda: T) -> T {
        (ray.at(lambda) - self.center).dot(self.axis)
    }

    /// Whether the side's point at `lambda` lies between the bases.
    #[inline(always)]
    #[must_use]
    pub fn within_height(&self, ray: &Ray<T>, lambda: T) -> T::Mask {
        self.along(ray, lambda).abs().less_equal(self.half_height)
    }

    /// The curved side, given the quadratic: the smaller root that is in range and between the bases, else the larger;
    /// and whether that counts. Where the discriminant is negative nothing does.
    #[inline(always)]
    #[must_use]
    pub fn side(&self, ray: &Ray<T>, (a, h, discriminant): (T, T, T)) -> (T, T::Mask) {
        let root = discriminant.sqrt();
        let (near, far) = ((-h - root) / a, (-h + root) / a);
        let near_counts = in_range(near) & self.within_height(ray, near);
        let far_counts = in_range(far) & self.within_height(ray, far);
        (T::select(near_counts, near, far), near_counts | far_counts)
    }

    /// Where the ray meets the plane of a base that is `distance` along the axis from the ray's origin, and the product
    /// of ray and axis.
    #[inline(always)]
    #[must_use]
    pub fn plane(&self, ray: &Ray<T>, distance: T) -> (T, T) {
        // The lower base's normal is -axis: negating numerator and denominator leaves the quotient's bits.
        let slope = ray.direction.dot(self.axis);
        (distance / slope, slope)
    }

    /// Whether the point at `lambda` lies on the disc around `base`.
    #[inline(always)]
    #[must_use]
    pub fn on_disc(&self, ray: &Ray<T>, base: Vec3<T>, lambda: T) -> T::Mask {
        (ray.at(lambda) - base).length().less_equal(self.radius)
    }

    /// The disc around `base`, one of the two centres, `distance` along the axis from the ray's origin: where the ray
    /// meets its plane, and whether that counts.
    #[inline(always)]
    #[must_use]
    pub fn base(&self, ray: &Ray<T>, base: Vec3<T>, distance: T) -> (T, T::Mask) {
        let (lambda, slope) = self.plane(ray, distance);
        (lambda, !slope.abs().less(T::of(PARALLEL)) & in_range(lambda) & self.on_disc(ray, base, lambda))
    }

    /// The normal at `point` that leaves `part`. The side's is as long as the radius, by the statement.
    #[inline(always)]
    #[must_use]
    pub fn outward(&self, part: CylinderPart, point: Vec3<T>) -> Vec3<T> {
        match part {
            CylinderPart::Side => (point - self.center).perpendicular_to(self.axis),
            CylinderPart::Top => self.axis,
            CylinderPart::Bottom => -self.axis,
        }
    }
}

impl<T: Real<Mask = bool>> CylinderRecord<T> {
    /// Where the ray meets the cylinder first: the side, then the upper base, then the lower; of equals the later.
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
    #[must_use]
    pub fn intersect(&self, ray: &Ray<T>) -> Option<(T, CylinderPart)> {
        let view = self.seen_from(ray.origin);
        let quadratic = self.quadratic(&view, ray.direction);
        let mut nearest = None;
        if !quadratic.2.less(T::of(0.0)) {
            let (lambda, met) = self.side(ray, quadratic);
            nearest = met.then_some((lambda, CylinderPart::Side));
        }
        for (base, distance, part) in
            [(self.top, view.to_top, CylinderPart::Top), (self.bottom, view.to_bottom, CylinderPart::Bottom)]
        {
            let (lambda, met) = self.base(ray, base, distance);
            if met && nearest.is_none_or(|(best, _)| lambda.less_equal(best)) {
                nearest = Some((lambda, part));
            }
        }
        nearest
    }
}

#[cfg(test)]
mod tests;
