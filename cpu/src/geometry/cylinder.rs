//! Ray against closed cylinder (specification, sections 9.2 and 9.3).
//!
//! The curved side is part of the infinite cylinder `|r_c' + d' lambda|^2 = r^2`, where `'` takes the component
//! perpendicular to the axis and `r_c = O - C`. With `h = r_c'.d'`, half of the linear coefficient, its roots are
//! `(-h -+ sqrt(h^2 - a c)) / a`. The module of the [sphere](crate::geometry::sphere) explains why `h` gives the same
//! bits as `b`. A root counts if its point, measured along the axis, is at most half the height from the centre. The
//! caps are discs in the planes at both ends ([`cap`]).

use crate::geometry::{cap, ray::Ray, ray::in_range, tie::later_is_closer};
use crate::math::{real::Real, vec3::Vec3, vec3::broadcast};

/// A cylinder with what its rays need computed once.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct CylinderRecord<T = f64> {
    /// The point halfway between the centres of its caps.
    pub center: Vec3<T>,
    /// Its axis, of length one, towards the top cap.
    pub axis: Vec3<T>,
    /// The centre of the top cap.
    pub top: Vec3<T>,
    /// The centre of the bottom cap.
    pub bottom: Vec3<T>,
    /// Its radius, positive.
    pub radius: T,
    /// Its radius squared.
    pub radius_squared: T,
    /// Half its height, positive.
    pub half_height: T,
}

/// The terms of the cylinder's formula that are constant for all rays from one point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CylinderView<T = f64> {
    /// From the centre to the origin, perpendicular to the axis.
    pub r_c: Vec3<T>,
    /// `r_c.r_c - r^2`: negative inside the infinite cylinder.
    pub c: T,
    /// The sum of the squares of the distance to the centre and of the radius.
    pub squares: T,
    /// How far the origin is along the axis from the plane halfway between the caps.
    pub along: T,
}

broadcast!(CylinderView: r_c; c, squares, along);
broadcast!(CylinderRecord: center, axis, top, bottom; radius, radius_squared, half_height);

/// The part of a cylinder that a ray hits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum CylinderPart {
    /// The curved side.
    Side = 0,
    /// The cap that the axis points to.
    Top = 1,
    /// The other cap.
    Bottom = 2,
}

impl<T: Real> CylinderRecord<T> {
    /// The record of the cylinder whose `axis` is as long as it is high.
    #[inline(always)]
    pub fn new(center: Vec3<T>, radius: T, axis: Vec3<T>) -> Self {
        let (unit, height) = axis.unit_and_length();
        Self::with_unit_axis(center, radius, unit, height / T::of(2.0))
    }

    /// The record of the cylinder with an `axis` of length one.
    #[inline(always)]
    pub fn with_unit_axis(center: Vec3<T>, radius: T, axis: Vec3<T>, half_height: T) -> Self {
        let to_cap = axis * half_height;
        let (top, bottom) = (center + to_cap, center - to_cap);
        Self { center, axis, top, bottom, radius, radius_squared: radius * radius, half_height }
    }

    /// The cylinder as rays from `origin` see it.
    #[inline(always)]
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
    pub fn quadratic(&self, view: &CylinderView<T>, direction: Vec3<T>) -> (T, T, T) {
        let direction = direction.perpendicular_to(self.axis);
        let a = direction.dot(direction);
        let h = view.r_c.dot(direction);
        (a, h, h * h - a * view.c)
    }

    /// Whether the side's point at `lambda` lies between the caps.
    #[inline(always)]
    pub fn within_height(&self, ray: &Ray<T>, lambda: T) -> T::Mask {
        (ray.at(lambda) - self.center).dot(self.axis).abs().less_equal(self.half_height)
    }

    /// The normal at `point` that leaves `part`. The side's is as long as the radius (specification, section 9.2).
    #[inline(always)]
    pub fn outward(&self, part: CylinderPart, point: Vec3<T>) -> Vec3<T> {
        match part {
            CylinderPart::Side => (point - self.center).perpendicular_to(self.axis),
            CylinderPart::Top => self.axis,
            CylinderPart::Bottom => -self.axis,
        }
    }
}

impl<T: Real<Mask = bool>> CylinderRecord<T> {
    /// The closest hit among the side, the top cap and the bottom cap.
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
        let (a, h, discriminant) = self.quadratic(&view, ray.direction);
        let mut nearest = None;
        if !discriminant.less(T::of(0.0)) {
            let root = discriminant.sqrt();
            let mut roots = [(-h - root) / a, (-h + root) / a].into_iter();
            let side = roots.find(|&lambda| in_range(lambda) && self.within_height(ray, lambda));
            nearest = side.map(|lambda| (lambda, CylinderPart::Side));
        }
        for (center, part) in [(self.top, CylinderPart::Top), (self.bottom, CylinderPart::Bottom)] {
            if let Some(lambda) = cap::intersect(center, self.axis, self.radius, ray)
                && nearest.is_none_or(|(closest, _)| later_is_closer(lambda, closest))
            {
                nearest = Some((lambda, part));
            }
        }
        nearest
    }
}

#[cfg(test)]
mod tests;
