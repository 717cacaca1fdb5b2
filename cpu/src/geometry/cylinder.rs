//! Ray against closed cylinder (specification, sections 9.2 and 9.3).
//!
//! The curved side is part of the infinite cylinder `|r_c' + d' lambda|^2 = r^2`, where `'` takes the component
//! perpendicular to the axis and `r_c = O - C`. With `h = r_c'.d'`, half of the linear coefficient, its roots are
//! `(-h -+ sqrt(h^2 - a c)) / a`. The module of the [sphere](crate::geometry::sphere) explains why `h` gives the same
//! bits as `b`. A root counts if its point, measured along the axis, is at most half the height from the centre. The
//! caps are discs in the planes at both ends.

use crate::geometry::ray::{Ray, broadcast, in_range};
use crate::math::real::Real;
use crate::math::vec3::Vec3;

/// A plane whose direction and the ray's have a smaller product than this is never met (specification, section 9.3).
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
}

broadcast!(CylinderView: r_c; c, squares, along);
broadcast!(CylinderRecord: center, axis, top, bottom; radius, radius_squared, half_height);

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

    /// Whether the side's point at `lambda` lies between the bases.
    #[inline(always)]
    #[must_use]
    pub fn within_height(&self, ray: &Ray<T>, lambda: T) -> T::Mask {
        (ray.at(lambda) - self.center).dot(self.axis).abs().less_equal(self.half_height)
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

    /// The normal at `point` that leaves `part`. The side's is as long as the radius (specification, section 9.2).
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
        let (a, h, discriminant) = self.quadratic(&view, ray.direction);
        let mut nearest = None;
        if !discriminant.less(T::of(0.0)) {
            let root = discriminant.sqrt();
            let mut roots = [(-h - root) / a, (-h + root) / a].into_iter();
            let side = roots.find(|&lambda| in_range(lambda) && self.within_height(ray, lambda));
            nearest = side.map(|lambda| (lambda, CylinderPart::Side));
        }
        for (base, part) in [(self.top, CylinderPart::Top), (self.bottom, CylinderPart::Bottom)] {
            let (lambda, slope) = self.plane(ray, (base - ray.origin).dot(self.axis));
            let is_hit = !slope.abs().less(T::of(PARALLEL)) && in_range(lambda) && self.on_disc(ray, base, lambda);
            if is_hit && nearest.is_none_or(|(best, _)| lambda.less_equal(best)) {
                nearest = Some((lambda, part));
            }
        }
        nearest
    }
}

#[cfg(test)]
mod tests;
