//! Vectors of three components, for points, directions and colours.
//!
//! They are generic over [`Real`]. So a formula is written once, and works on one ray or on several rays in lanes.
//!
//! The order of the operations in each function is part of the result, because pictures are compared byte for byte. So
//! a dot product is always summed from left to right. A unit vector is always computed by dividing each component by
//! the length.

use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::math::real::Real;

/// A point, a direction (both in scene units) or a linear colour (red, green, blue).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[must_use]
#[repr(C)]
pub struct Vec3<T = f64> {
    /// First component; red in a colour.
    pub x: T,
    /// Second component; green in a colour. The background's gradient runs along it.
    pub y: T,
    /// Third component; blue in a colour.
    pub z: T,
}

impl Vec3 {
    /// Three zeros: the origin, the null vector or black.
    pub const ZERO: Self = Self::new(0.0, 0.0, 0.0);
    /// Three ones: white, or the reflectance of a surface that changes no colour.
    pub const ONE: Self = Self::new(1.0, 1.0, 1.0);

    /// Whether every component is finite.
    #[must_use]
    pub fn is_finite(self) -> bool {
        self.x.is_finite() && self.y.is_finite() && self.z.is_finite()
    }
}

impl<T: Copy> Vec3<T> {
    /// Returns the vector with these components.
    #[inline(always)]
    pub const fn new(x: T, y: T, z: T) -> Self {
        Self { x, y, z }
    }

    /// Returns the vector with three equal components.
    #[inline(always)]
    pub const fn splat(value: T) -> Self {
        Self::new(value, value, value)
    }

    /// Returns the components in order.
    #[inline(always)]
    #[must_use]
    pub const fn to_array(self) -> [T; 3] {
        [self.x, self.y, self.z]
    }

    /// Returns the vector with `convert` applied to every component.
    #[inline(always)]
    pub fn map<U: Copy>(self, convert: impl Fn(T) -> U) -> Vec3<U> {
        Vec3::new(convert(self.x), convert(self.y), convert(self.z))
    }
}

impl<T: Real> Vec3<T> {
    /// Returns `yes` where `mask` holds, and `no` elsewhere.
    #[inline(always)]
    pub(crate) fn select(mask: T::Mask, yes: Self, no: Self) -> Self {
        Self::new(T::select(mask, yes.x, no.x), T::select(mask, yes.y, no.y), T::select(mask, yes.z, no.z))
    }

    /// Returns the dot product, summed from left to right.
    #[inline(always)]
    #[must_use]
    pub fn dot(self, other: Self) -> T {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    /// Returns the cross product `self × other`.
    #[inline(always)]
    pub fn cross(self, other: Self) -> Self {
        Self::new(
            self.y * other.z - self.z * other.y,
            self.z * other.x - self.x * other.z,
            self.x * other.y - self.y * other.x,
        )
    }

    /// Returns the Euclidean length.
    #[inline(always)]
    #[must_use]
    pub fn length(self) -> T {
        self.dot(self).sqrt()
    }

    /// Returns the vector of length one in the same direction. For a null vector every component is NaN.
    #[inline(always)]
    pub fn unit(self) -> Self {
        self / self.length()
    }

    /// Returns the vector of length one in the same direction, and the length. In `f64` both are accurate for short
    /// vectors too.
    ///
    /// The square of a length below 2^-537 underflows in `f64`. A vector shorter than 2^-300 is therefore multiplied by
    /// 2^600 first, which is exact. All other vectors give the bits of [`Self::unit`] and [`Self::length`]. `f32`
    /// cannot hold 2^600. So in `f32` no vector is scaled, and the squared length of a short vector underflows.
    #[inline(always)]
    pub fn unit_and_length(self) -> (Self, T) {
        const SCALE_OF_SHORT: f64 = f64::from_bits((1023 + 600) << 52);
        const INVERSE: f64 = f64::from_bits((1023 - 600) << 52);
        let is_short = self.dot(self).less(T::of(INVERSE));
        let scaled = self * T::select(is_short, T::of(SCALE_OF_SHORT), T::of(1.0));
        let length = scaled.length();
        (scaled / length, length * T::select(is_short, T::of(INVERSE), T::of(1.0)))
    }

    /// Returns the product component by component: a colour after reflection by a surface with this `reflectance`.
    #[inline(always)]
    pub fn attenuate(self, reflectance: Self) -> Self {
        Self::new(self.x * reflectance.x, self.y * reflectance.y, self.z * reflectance.z)
    }

    /// Returns the part of this vector `v` that is perpendicular to `axis`: `v - (v . axis) axis`. The axis must have
    /// length one.
    #[inline(always)]
    pub fn perpendicular_to(self, axis: Self) -> Self {
        self - axis * self.dot(axis)
    }
}

impl<T: Real<Mask = bool>> Vec3<T> {
    /// Whether every component is smaller than [`NEGLIGIBLE`] in magnitude (specification, section 10.1).
    #[inline(always)]
    #[must_use]
    pub fn is_negligible(self) -> bool {
        let limit = T::of(NEGLIGIBLE);
        self.x.abs().less(limit) && self.y.abs().less(limit) && self.z.abs().less(limit)
    }
}

/// If all components of a matte surface's scattered direction are smaller than this in magnitude, the normal replaces
/// the direction (specification, section 10.1).
pub const NEGLIGIBLE: f64 = 1e-8;

impl<T: Copy> From<[T; 3]> for Vec3<T> {
    fn from([x, y, z]: [T; 3]) -> Self {
        Self::new(x, y, z)
    }
}

/// Implements operators component by component; `$right` is the right operand as a vector.
macro_rules! operators {
    ($($trait:ident $method:ident $operator:tt $other:ident: $type:ty => $right:expr;)+) => {
        $(impl<T: Real> $trait<$type> for Vec3<T> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, $other: $type) -> Self {
                let right = $right;
                Self::new(self.x $operator right.x, self.y $operator right.y, self.z $operator right.z)
            }
        })+
    };
}

operators! {
    Add add + other: Self => other;
    Sub sub - other: Self => other;
    Mul mul * factor: T => Vec3::splat(factor);
    Div div / divisor: T => Vec3::splat(divisor);
}

impl<T: Real> Neg for Vec3<T> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self::new(-self.x, -self.y, -self.z)
    }
}

/// Gives a structure the method `lanes`, from the names of its fields: first those that are vectors, then those that
/// are numbers.
macro_rules! broadcast {
    ($type:ident: $($vector:ident),*; $($number:ident),*) => {
        impl $type {
            /// Returns the same values in every lane.
            #[inline(always)]
            #[must_use]
            pub fn lanes<V: $crate::math::real::Real>(&self) -> $type<V> {
                $type { $($vector: self.$vector.map(V::of),)* $($number: V::of(self.$number),)* }
            }
        }
    };
}
pub(crate) use broadcast;

#[cfg(test)]
mod tests {
    use super::*;

    const A: Vec3 = Vec3::new(1.0, 2.0, 3.0);
    const B: Vec3 = Vec3::new(-4.0, 5.0, 0.5);

    #[test]
    fn operators_work_component_by_component() {
        assert_eq!(A + B, Vec3::new(-3.0, 7.0, 3.5));
        assert_eq!(A - B, Vec3::new(5.0, -3.0, 2.5));
        assert_eq!(A * 2.0, Vec3::new(2.0, 4.0, 6.0));
        assert_eq!(A / 2.0, Vec3::new(0.5, 1.0, 1.5));
        assert_eq!(-A, Vec3::new(-1.0, -2.0, -3.0));
        assert_eq!(A.attenuate(B), Vec3::new(-4.0, 10.0, 1.5));
    }

    #[test]
    fn dot_is_summed_left_to_right() {
        let large = Vec3::new(1e16, 1.0, -1e16);
        assert_eq!(large.dot(Vec3::ONE), 0.0, "1e16 + 1 rounds to 1e16 before the subtraction");
        assert_eq!(A.dot(B), 7.5);
    }

    #[test]
    fn cross_is_perpendicular_to_both() {
        let cross = A.cross(B);
        assert_eq!((cross.dot(A), cross.dot(B)), (0.0, 0.0));
        assert_eq!(Vec3::new(1.0, 0.0, 0.0).cross(Vec3::new(0.0, 1.0, 0.0)), Vec3::new(0.0, 0.0, 1.0));
    }

    #[test]
    fn unit_has_length_one_and_is_nan_for_the_null_vector() {
        assert_eq!(Vec3::new(0.0, 3.0, 4.0).length(), 5.0);
        assert_eq!(Vec3::new(0.0, 3.0, 4.0).unit(), Vec3::new(0.0, 0.6, 0.8));
        assert!(Vec3::ZERO.unit().x.is_nan());
        // The squares of the shorter vectors underflow.
        for scale in [1.0, 2.0_f64.powi(-600), 2.0_f64.powi(-1000)] {
            let (unit, length) = (Vec3::new(0.0, 3.0, 4.0) * scale).unit_and_length();
            assert_eq!((unit, length), (Vec3::new(0.0, 0.6, 0.8), 5.0 * scale));
        }
    }

    #[test]
    fn perpendicular_part_has_nothing_along_the_axis() {
        let axis = Vec3::new(0.0, 1.0, 0.0);
        assert_eq!(A.perpendicular_to(axis), Vec3::new(1.0, 0.0, 3.0));
    }

    #[test]
    fn negligible_means_all_components_below_the_limit() {
        assert!(Vec3::new(9e-9, -9e-9, 0.0).is_negligible());
        assert!(!Vec3::new(1e-8, 0.0, 0.0).is_negligible());
        assert!(!Vec3::new(f64::NAN, 0.0, 0.0).is_negligible());
    }

    #[test]
    fn finite_and_array_round_trip() {
        assert!(A.is_finite() && !Vec3::new(0.0, f64::INFINITY, 0.0).is_finite());
        assert_eq!(Vec3::from(A.to_array()), A);
    }
}
