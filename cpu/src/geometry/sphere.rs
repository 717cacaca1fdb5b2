//! Ray against sphere (specification, section 9.1).
//!
//! A point `O + d lambda` lies on the sphere if `a lambda^2 + b lambda + c = 0` with `a = d.d`, `b = -2 d.r_c`,
//! `c = r_c.r_c - r^2`, `r_c = C - O`. The code uses `h = -b / 2`. The roots `(h -+ sqrt(h^2 - a c)) / a` have the bits
//! of `(-b -+ sqrt(b^2 - 4 a c)) / (2 a)`, because a product with a power of two is exact short of overflow and
//! underflow.

use crate::{geometry::ray::Ray, geometry::ray::in_range, math::real::Real, math::vec3::Vec3, math::vec3::broadcast};

/// A sphere in the form that the formulas use. The square of the radius is computed once instead of for each ray.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct SphereRecord<T = f64> {
    /// The sphere's centre, in scene units.
    pub center: Vec3<T>,
    /// The sphere's radius, in scene units, positive.
    pub radius: T,
    /// The square of the radius.
    pub radius_squared: T,
}

/// The terms of the sphere's formula that are constant for all rays from one point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SphereView<T = f64> {
    /// The vector from the rays' origin to the sphere's centre.
    pub to_center: Vec3<T>,
    /// `r_c.r_c - r^2`, which is negative if the origin is inside the sphere.
    pub c: T,
    /// `r_c.r_c + r^2`.
    pub squares: T,
}

impl<T: Real> SphereView<T> {
    /// Returns `h = -b / 2` and `h^2 - a c`, a quarter of the quadratic's discriminant. The caller gives
    /// `a = direction . direction`.
    #[inline(always)]
    pub fn quadratic(&self, direction: Vec3<T>, a: T) -> (T, T) {
        let h = direction.dot(self.to_center);
        (h, h * h - a * self.c)
    }
}

broadcast!(SphereView: to_center; c, squares);
broadcast!(SphereRecord: center; radius, radius_squared);

impl<T: Real> SphereRecord<T> {
    /// Returns the record of the sphere around `center`.
    #[inline(always)]
    pub fn new(center: Vec3<T>, radius: T) -> Self {
        Self { center, radius, radius_squared: radius * radius }
    }

    /// Returns the terms of the formula that are constant for all rays from `origin`.
    #[inline(always)]
    pub fn seen_from(&self, origin: Vec3<T>) -> SphereView<T> {
        let to_center = self.center - origin;
        let distance_squared = to_center.dot(to_center);
        let (c, squares) = (distance_squared - self.radius_squared, distance_squared + self.radius_squared);
        SphereView { to_center, c, squares }
    }

    /// Returns the normal that points out of the sphere at `point`, a point on its surface. The length is one.
    #[inline(always)]
    pub fn outward(&self, point: Vec3<T>) -> Vec3<T> {
        (point - self.center) / self.radius
    }
}

impl SphereRecord {
    /// Returns the bits of [`SphereRecord::outward`]. If the radius is a power of two, this multiplies by its
    /// reciprocal, which is exact. A product has a lower latency than a quotient, and the next ray of a path waits for
    /// the normal.
    #[inline(always)]
    pub(crate) fn outward_by_reciprocal(&self, point: Vec3) -> Vec3 {
        // Only the significand's leading bit is set, which is not stored. A subnormal radius fails this test.
        let is_power_of_two = self.radius.to_bits().trailing_zeros() >= f64::MANTISSA_DIGITS - 1;
        if is_power_of_two { (point - self.center) * (1.0 / self.radius) } else { self.outward(point) }
    }
}

impl<T: Real<Mask = bool>> SphereRecord<T> {
    /// Returns the lambda at which the ray hits the sphere, by the plain formula. This is the smaller root if it is in
    /// range, else the larger root if that is in range, else `None`.
    ///
    /// ```
    /// use cpu::intersect::SphereRecord;
    /// use cpu::{Ray, Vec3};
    ///
    /// let sphere = SphereRecord::new(Vec3::ZERO, 1.0);
    /// let ray = Ray { origin: Vec3::new(0.0, 0.0, -5.0), direction: Vec3::new(0.0, 0.0, 2.0) };
    /// assert_eq!(sphere.intersect(&ray), Some(2.0));
    /// ```
    #[inline(always)]
    pub fn intersect(&self, ray: &Ray<T>) -> Option<T> {
        let a = ray.direction.dot(ray.direction);
        let (h, discriminant) = self.seen_from(ray.origin).quadratic(ray.direction, a);
        if discriminant.less(T::of(0.0)) {
            return None;
        }
        let sqrt_d = discriminant.sqrt();
        [(h - sqrt_d) / a, (h + sqrt_d) / a].into_iter().find(|&lambda| in_range(lambda))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const UNIT: SphereRecord = SphereRecord { center: Vec3::ZERO, radius: 1.0, radius_squared: 1.0 };

    #[test]
    fn rays_hit_where_they_should() {
        for (what, origin, direction, expected) in [
            ("from outside the smaller root", [0.0, 0.0, -3.0], [0.0, 0.0, 1.0], Some(2.0)),
            ("from outside, a short direction", [0.0, 0.0, -3.0], [0.0, 0.0, 0.5], Some(4.0)),
            ("from inside the larger root", [0.0, 0.0, 0.0], [0.0, 0.0, 1.0], Some(1.0)),
            ("from inside, a short direction", [0.0, 0.0, 0.0], [0.0, 0.0, 0.5], Some(2.0)),
            ("from the surface the larger root", [0.0, 0.0, -1.0], [0.0, 0.0, 1.0], Some(2.0)),
            ("nearer than the limit", [0.0, 0.0, -1.000_488_281_25], [0.0, 0.0, 1.0], Some(2.000_488_281_25)),
            ("a tangent", [1.0, 0.0, -3.0], [0.0, 0.0, 1.0], Some(3.0)),
            ("beside", [1.1, 0.0, -3.0], [0.0, 0.0, 1.0], None),
            ("both roots lie behind", [0.0, 0.0, 3.0], [0.0, 0.0, 1.0], None),
            ("a null direction inside", [0.0, 0.0, 0.0], [0.0; 3], None),
            ("a null direction outside", [0.0, 0.0, 3.0], [0.0; 3], None),
        ] {
            let ray = Ray { origin: origin.into(), direction: direction.into() };
            assert_eq!(UNIT.intersect(&ray), expected, "{what}");
        }
    }

    #[test]
    fn the_normal_has_length_one() {
        let sphere = SphereRecord::new(Vec3::new(1.0, 0.0, 0.0), 2.0);
        assert_eq!(sphere.radius_squared, 4.0);
        assert_eq!(sphere.outward(Vec3::new(3.0, 0.0, 0.0)), Vec3::new(1.0, 0.0, 0.0));
    }

    #[test]
    fn the_quadratic_has_the_two_roots_of_the_sphere() {
        // `(2 lambda - 3)^2 = 1`, so `4 lambda^2 - 12 lambda + 8 = 0`: the roots are 1 and 2, or `(6 -+ 2) / 4`.
        let view = UNIT.seen_from(Vec3::new(0.0, 0.0, -3.0));
        assert_eq!(view.quadratic(Vec3::new(0.0, 0.0, 2.0), 4.0), (6.0, 4.0));
    }

    #[test]
    fn a_view_has_the_terms_of_any_sphere() {
        let view = SphereRecord::new(Vec3::ONE, 2.0).seen_from(Vec3::new(1.0, 1.0, -2.0));
        assert_eq!((view.to_center, view.c, view.squares), (Vec3::new(0.0, 0.0, 3.0), 5.0, 13.0));
    }

    #[test]
    fn the_normal_by_a_reciprocal_has_the_same_bits_for_every_exponent() {
        let mut draws = crate::sampling::uniform::Uniform::new(17);
        for exponent in -1074..=1023 {
            let power = if exponent < -1022 { f64::from_bits(1 << (exponent + 1074)) } else { 2.0_f64.powi(exponent) };
            for radius in [power, power * 1.5, power * 0.75, power.next_up(), power.next_down()] {
                let mut vector = || Vec3::from([(); 3].map(|()| draws.draw(-1.0, 1.0)));
                let (sphere, far) = (SphereRecord::new(vector(), radius), SphereRecord::new(vector() * 1e5, radius));
                let toward = vector();
                for (sphere, point) in
                    [(sphere, toward), (sphere, toward * radius), (far, far.center + toward * radius)]
                {
                    let bits = |normal: Vec3| normal.to_array().map(f64::to_bits);
                    assert_eq!(
                        bits(sphere.outward_by_reciprocal(point)),
                        bits(sphere.outward(point)),
                        "{sphere:?}, {point:?}"
                    );
                }
            }
        }
    }

    #[test]
    fn single_precision_takes_the_same_steps() {
        let sphere = SphereRecord::<f32>::new(Vec3::splat(0.0), 1.0);
        let ray = Ray { origin: Vec3::new(0.0, 0.0, -3.0_f32), direction: Vec3::new(0.0, 0.0, 1.0) };
        assert_eq!(sphere.intersect(&ray), Some(2.0));
    }
}
