//! Intersects ray and sphere by the [compensated formulas](crate::exact::compensated_roots). They serve rays that start
//! near a sphere whose radius is much larger than the distance to its surface, such as rays that leave a large floor,
//! and rays that pass a small and far sphere.
//!
//! By Lagrange's identity the discriminant equals `a r^2 - |(C - O) x d|^2`. If the ray passes near the sphere, both
//! terms are about `a r^2`, however far away the sphere is. Kahan's algorithm computes the [cross
//! product](accurate_cross).

use crate::exact::compensated_roots::{
    Discriminant, Quadratic, Roots, certainly_in_range_and_finite, difference_of_squares,
};
use crate::exact::{error_bound::Decision, error_bound::in_scale, sphere_filter::SphereHits};
use crate::geometry::{ray::Ray, sphere::SphereRecord};
use crate::math::error_free::{accurate_cross, two_product, vector_difference};
use crate::math::{rounding::Rounding, vec3::Vec3};

/// The share of `a (|C - O|^2 + r^2)` in the terms of `a r^2 - |(C - O) x d|^2`, 2^-90. It covers errors of second
/// order in the cross product, if the sphere is farther away than 2^40 radii.
pub const SHARE_OF_DISTANCE: f64 = f64::from_bits((1023 - 90) << 52);

/// The terms of a ray and a sphere from which both discriminants are computed.
#[derive(Clone, Copy, Debug)]
pub struct SphereTerms<T> {
    direction: Vec3<T>,
    /// `C - O`, rounded, and the rounding error.
    to_center: Vec3<T>,
    error: Vec3<T>,
    radius_squared: T,
    /// The coefficients.
    pub quadratic: Quadratic<T>,
}

impl<T: Rounding> SphereTerms<T> {
    /// Returns the terms.
    #[inline(always)]
    pub fn new(record: &SphereRecord<T>, ray: &Ray<T>) -> Self {
        let direction = ray.direction;
        let a = direction.dot(direction);
        let (to_center, error) = vector_difference(record.center, ray.origin);
        let (c, squares) = difference_of_squares((to_center, error), two_product(record.radius, record.radius));
        let h = direction.dot(to_center);
        let quadratic = Quadratic { a, h, c, size_of_c: squares, size_of_h: (a * squares).sqrt() };
        Self { direction, to_center, error, radius_squared: record.radius_squared, quadratic }
    }

    /// Returns `a r^2 - |(C - O) x d|^2`, which is accurate if the ray starts far away.
    #[inline(always)]
    pub fn far(&self) -> Discriminant<T> {
        let Quadratic { a, size_of_c, .. } = self.quadratic;
        let across = accurate_cross(self.to_center, self.direction) + accurate_cross(self.error, self.direction);
        let (of_radius, of_distance) = (a * self.radius_squared, across.dot(across));
        let size = of_radius + (of_distance + a * size_of_c * T::of(SHARE_OF_DISTANCE));
        Discriminant { value: of_radius - of_distance, size }
    }

    /// Returns the hits with this discriminant.
    #[inline(always)]
    pub(crate) fn hits(&self, discriminant: Discriminant<T>) -> SphereHits<T> {
        let Quadratic { a, h, c, .. } = self.quadratic;
        let roots = self.quadratic.roots(discriminant);
        let (small, large) = (c.abs() / roots.w, roots.w / a);
        let small_hits = roots.small_is_ahead & certainly_in_range_and_finite(small);
        let large_hits = roots.small_fails & T::of(0.0).less_equal(h) & certainly_in_range_and_finite(large);
        let misses = roots.misses | (roots.accurate & roots.small_fails & roots.large_fails);
        SphereHits {
            lambda: T::select(misses, T::of(f64::INFINITY), T::select(small_hits, small, large)),
            certain: in_scale(a) & (misses | (roots.accurate & (small_hits | large_hits))),
        }
    }
}

impl SphereTerms<f64> {
    /// Returns the hit with this discriminant. The result is that of [`SphereTerms::hits`] with branches, which take
    /// fewer instructions.
    #[inline(always)]
    fn hit(&self, discriminant: Discriminant<f64>) -> Decision<Option<f64>> {
        let Quadratic { a, h, c, .. } = self.quadratic;
        let roots: Roots<f64> = self.quadratic.roots(discriminant);
        if !in_scale(a) {
            return Decision::Uncertain;
        }
        if !roots.accurate {
            return if roots.misses { Decision::Certain(None) } else { Decision::Uncertain };
        }
        if roots.small_is_ahead {
            let small = c.abs() / roots.w;
            if certainly_in_range_and_finite(small) {
                return Decision::Certain(Some(small));
            }
        }
        if roots.small_fails {
            if roots.large_fails {
                return Decision::Certain(None);
            }
            let large = roots.w / a;
            if h >= 0.0 && certainly_in_range_and_finite(large) {
                return Decision::Certain(Some(large));
            }
        }
        Decision::Uncertain
    }
}

/// Returns the hit of one ray, or `None` for a miss, if rounding certainly has not changed it.
#[inline(always)]
pub fn compensated(record: &SphereRecord, ray: &Ray) -> Decision<Option<f64>> {
    let terms = SphereTerms::new(record, ray);
    if in_scale(terms.quadratic.a) && terms.quadratic.moves_away() {
        return Decision::Certain(None);
    }
    match terms.hit(terms.quadratic.near()) {
        Decision::Uncertain => terms.hit(terms.far()),
        decision => decision,
    }
}

/// Returns the lambda of the ray's hit, with twice the bound of its error, or `None` if that is uncertain.
#[inline(always)]
pub(crate) fn lambda(record: &SphereRecord, ray: &Ray) -> Option<(f64, f64)> {
    let terms = SphereTerms::new(record, ray);
    let (near, far) = (terms.quadratic.near(), terms.far());
    let roots = terms.quadratic.roots(if near.size < far.size { near } else { far });
    let [small, large] = roots.magnitudes(&terms.quadratic);
    let small_hits = roots.small_is_ahead && certainly_in_range_and_finite(small.0);
    let large_hits = roots.small_fails && terms.quadratic.h >= 0.0;
    let is_certain = in_scale(terms.quadratic.a) && roots.accurate && (small_hits || large_hits);
    is_certain.then_some(if small_hits { small } else { large })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::order::is_certainly_closer;
    use crate::exact::sphere;
    use crate::exact::sphere::precise;
    use crate::math::{double_double::DoubleDouble, real::Real};
    use crate::sampling::uniform::Uniform;
    use crate::simd::instruction_set::InstructionSet;
    use crate::simd::{Kernel, Simd};

    /// Returns rays of four kinds. They start above or below the surface of a sphere by `10^-18` to 10 times its
    /// radius, some of them along the surface. Or they start on the surface, or pass a far sphere near its rim.
    fn cases(count: usize) -> Vec<(SphereRecord, Ray)> {
        let mut draws = Uniform::new(11);
        let mut cases = Vec::with_capacity(count);
        for number in 0..count {
            let mut vector = || Vec3::from([(); 3].map(|()| draws.draw(-1.0, 1.0)));
            let (center, up, mut direction, off) = (vector() * 100.0, vector().unit(), vector(), vector());
            let radius = 10.0_f64.powf(draws.draw(0.0, 7.0));
            let height = 10.0_f64.powf(draws.draw(-18.0, 1.0)) * if number % 3 == 0 { -1.0 } else { 1.0 };
            let mut origin = center + up * (radius + if number % 4 == 0 { 0.0 } else { height * radius });
            if number % 4 == 2 {
                direction = direction.perpendicular_to(up);
            }
            if number % 4 == 1 {
                origin = center + up * (radius * 10.0_f64.powf(draws.draw(0.0, 9.0)));
                let rim = off.perpendicular_to(up).unit() * (1.0 + height);
                direction = center + rim * radius - origin;
            }
            cases.push((SphereRecord::new(center, radius), Ray { origin, direction }));
        }
        cases
    }

    #[test]
    fn what_is_certain_is_the_precise_answer() {
        let (mut hits, mut misses, mut bounds, mut worst) = (0, 0, 0, 0.0_f64);
        for (record, ray) in cases(200_000) {
            let precise = precise(&record, &ray);
            if let (Err(least), Some(precise)) = (sphere::filtered_or_lower_bound(&record, &ray), precise) {
                assert!(!is_certainly_closer(precise, least), "{least} is above {precise}: {record:?}, {ray:?}");
                bounds += usize::from(least > precise * 0.999);
            }
            if let Decision::Certain(hit) = compensated(&record, &ray) {
                assert_eq!(hit.is_some(), precise.is_some(), "{record:?}, {ray:?}");
                let (Some(lambda), Some(precise)) = (hit, precise) else {
                    misses += 1;
                    continue;
                };
                worst = worst.max(((lambda - precise) / precise).abs());
                hits += 1;
            }
        }
        assert!(hits > 60_000 && misses > 60_000 && bounds > 2_000, "{hits}, {misses} and {bounds}");
        // By the proof the relative error is at most (10 k + 6) u, where k is the condition limit.
        assert!(worst < 4.6e-12, "{worst:e}");
    }

    #[test]
    fn a_ray_that_touches_a_far_sphere_but_for_the_rounding_of_its_radius_is_uncertain() {
        let mut draws = Uniform::new(3);
        for number in 0..3000 {
            let mut vector = || Vec3::from([(); 3].map(|()| draws.draw(-1000.0, 1000.0).round()));
            let (direction, other) = (vector(), vector());
            // All these numbers are integers, so nothing but the radius is rounded.
            let touched = direction.cross(other);
            let record = SphereRecord::new(Vec3::ZERO, touched.length());
            let origin = touched - direction * f64::from(1 << (12 + number % 12));
            let ray = Ray { origin, direction };
            assert_eq!(compensated(&record, &ray), Decision::Uncertain, "{record:?}, {ray:?}");
            assert_eq!(lambda(&record, &ray), None, "{record:?}, {ray:?}");
        }
    }

    #[test]
    fn a_c_of_rounding_errors_is_uncertain() {
        // The surface is so near that `c` consists of the squares of the roundings of `C - O`, which are left out. The
        // direction is so short that lambda is in range.
        let (center, radius) = (Vec3::new(1.0 / 3.0, 0.1, 0.0), 1e6);
        let record = SphereRecord::new(center, radius);
        for number in 0..1000 {
            let angle = 0.1 + f64::from(number) * 1e-3;
            let [x, y] = [radius * angle.cos(), radius * angle.sin()];
            let of = DoubleDouble::of;
            let [across, up] = [of(x) - of(center.x), of(y) - of(center.y)];
            let rest = of(radius) * of(radius) - across * across - up * up;
            let origin = Vec3::new(x, y, rest.abs().sqrt().high);
            let direction = (center - origin) * 1e-30;
            assert_eq!(compensated(&record, &Ray { origin, direction }), Decision::Uncertain, "{origin:?}");
        }
    }

    #[test]
    fn most_uncertain_rays_become_certain() {
        let (mut uncertain, mut certain) = (0, 0);
        for (record, ray) in cases(100_000) {
            if sphere::filtered(&record, &ray) == Decision::Uncertain {
                uncertain += 1;
                certain += u32::from(compensated(&record, &ray) != Decision::Uncertain);
            }
        }
        assert!(uncertain > 10_000 && certain * 100 > uncertain * 85, "{certain} of {uncertain}");
    }

    #[test]
    fn a_direction_out_of_scale_and_nan_are_uncertain() {
        let large = SphereRecord::new(Vec3::new(0.0, -1e4, 0.0), 1e4);
        let down = |length: f64| Ray { origin: Vec3::new(0.0, 1.0, 0.0), direction: Vec3::new(0.0, -length, 0.0) };
        assert_eq!(compensated(&large, &down(1.0)), Decision::Certain(Some(1.0)));
        for length in [0.0, 1e-60, 1e60, -1e60, f64::INFINITY, f64::NAN] {
            assert_eq!(compensated(&large, &down(length)), Decision::Uncertain, "{length}");
        }
        // One ray goes away from the sphere. The other one starts on its surface, and leaves it on the other side.
        let hit = |ray: &Ray| compensated(&large, ray);
        assert_eq!(hit(&down(-1.0)), Decision::Certain(None));
        let inward = Ray { origin: Vec3::ZERO, direction: Vec3::new(0.0, -1.0, 0.0) };
        assert_eq!(hit(&inward), Decision::Certain(Some(2e4)));
    }

    /// A kernel that intersects as many cases as there are lanes, and compares them with one case at a time.
    struct Together<'a>(&'a [(SphereRecord, Ray)]);

    impl Kernel for Together<'_> {
        type Output = usize;

        #[inline(always)]
        fn call<S: Simd>(self, _: S) -> usize {
            use crate::simd::SimdF64 as _;
            let cases = &self.0[..S::F64::LANES];
            let mut values = [[0.0; 8]; 10];
            for (lane, (record, ray)) in cases.iter().enumerate() {
                let Ray { origin, direction } = ray;
                let all = [record.center.to_array(), origin.to_array(), direction.to_array()].concat();
                for (value, component) in values.iter_mut().zip(all.into_iter().chain([record.radius])) {
                    value[lane] = component;
                }
            }
            let at = |first: usize| {
                Vec3::new(
                    S::F64::load(&values[first]),
                    S::F64::load(&values[first + 1]),
                    S::F64::load(&values[first + 2]),
                )
            };
            let record = SphereRecord::new(at(0), S::F64::load(&values[9]));
            let terms = SphereTerms::new(&record, &Ray { origin: at(3), direction: at(6) });
            let both = [terms.hits(terms.quadratic.near()), terms.hits(terms.far())];
            for (lane, (record, ray)) in cases.iter().enumerate() {
                let terms = SphereTerms::new(record, ray);
                for (lanes, one) in both.iter().zip([terms.hit(terms.quadratic.near()), terms.hit(terms.far())]) {
                    let mut lambdas = [0.0; 8];
                    lanes.lambda.store(&mut lambdas);
                    let lambda = (lambdas[lane] < f64::INFINITY).then_some(lambdas[lane]);
                    let is_certain = S::F64::bits(lanes.certain) >> lane & 1 == 1;
                    let hit = if is_certain { Decision::Certain(lambda) } else { Decision::Uncertain };
                    assert_eq!(hit, one, "{record:?}, {ray:?}");
                }
            }
            S::F64::LANES
        }
    }

    #[test]
    fn lanes_are_as_each_alone_in_every_instruction_set() {
        let cases = cases(4000);
        for set in InstructionSet::available() {
            let mut at = 0;
            while at + 8 <= cases.len() {
                at += set.run(Together(&cases[at..]));
            }
        }
    }
}
