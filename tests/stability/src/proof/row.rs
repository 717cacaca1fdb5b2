//! A margin of the code, and the proof that it is enough.

use cpu::internals::exact::error_bound::UNDERFLOW;
use cpu::{Ray, Vec3};

use super::bounded::{Bounded, LOST_MARGIN, MARGIN, compared};
use super::bounds::{Arithmetic, arithmetic};
use super::direction::hardens;
use super::polynomial::{LENGTH, Polynomial};

/// The families of the numbers. A vector and its length have the same family.
pub mod family {
    /// A ray's direction `d`.
    pub const DIRECTION: u8 = 0;
    /// The vector from a ray's origin to a centre, or back.
    pub const TO_CENTER: u8 = 1;
    /// A radius.
    pub const RADIUS: u8 = 2;
    /// A cylinder's axis, of length one.
    pub const AXIS: u8 = 3;
    /// A centre.
    pub const CENTER: u8 = 4;
    /// A ray's origin.
    pub const ORIGIN: u8 = 5;
    /// The part of the direction across the axis.
    pub const DIRECTION_ACROSS: u8 = 6;
    /// The part of [`TO_CENTER`] across the axis.
    pub const TO_CENTER_ACROSS: u8 = 7;
    /// Half of a cylinder's height.
    pub const HALF_HEIGHT: u8 = 8;
    /// A cylinder's radius, where [`RADIUS`] is that of its bounding sphere.
    pub const INNER_RADIUS: u8 = 9;
    /// The families from this one on are for numbers that are computed from others.
    pub const DERIVED: u8 = 16;
}
use family::*;

/// The unit roundoff.
pub const U: f64 = Arithmetic::F64.roundoff;

/// Lengths that are known to be at most another one: the axis has length one, and the part of a vector across the axis
/// is not longer than the vector.
const LARGER: [(u8, Option<u8>); 4] = [
    (AXIS, None),
    (DIRECTION_ACROSS, Some(DIRECTION)),
    (TO_CENTER_ACROSS, Some(TO_CENTER)),
    (INNER_RADIUS, Some(RADIUS)),
];

/// A margin: the constant in the code, and what is proved to be enough, in units of the unit roundoff.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// What the margin covers.
    pub what: &'static str,
    /// The file in `cpu/src` that has the constant.
    pub file: &'static str,
    /// The constant in the code.
    pub constant: f64,
    /// The smallest constant that is proved to be enough.
    pub need: f64,
    /// What both are multiples of. docs/margins.md has the letters.
    pub unit: &'static str,
}

/// Where the proof holds.
#[derive(Clone, Copy, Debug)]
pub struct Domain {
    /// The smallest length of a direction.
    pub direction: f64,
    /// The smallest root of `|O - C|^2 + r^2`, or 0 if there is none.
    pub size: f64,
    /// The constant that the code adds for underflow, in units of `u`.
    pub underflow: f64,
}

/// The directions that are in scale, with any object.
pub const IN_SCALE: Domain =
    Domain { direction: f64::from_bits((1023 - 150) << 52), size: 0.0, underflow: UNDERFLOW / U };

/// Returns a ray whose numbers are exact.
pub fn ray() -> Ray<Bounded> {
    Ray { origin: Bounded::vector(ORIGIN, 0.0), direction: Bounded::vector(DIRECTION, 0.0) }
}

/// Returns the square of a length.
#[must_use]
pub fn squared(family: u8) -> Polynomial {
    Polynomial::of([(family, LENGTH); 2])
}

/// Returns the length of the vector that gives a family its name.
#[must_use]
pub fn length(family: u8) -> Polynomial {
    Polynomial::of([(family, LENGTH)])
}

/// Returns the sum of the magnitudes of a vector's components. Its length is at most that.
#[must_use]
pub fn components(family: u8) -> Polynomial {
    sum(&[0, 1, 2].map(|component| Polynomial::of([(family, component)])))
}

/// Returns the sum of polynomials.
#[must_use]
pub fn sum(parts: &[Polynomial]) -> Polynomial {
    parts.iter().fold(Polynomial::default(), |sum, part| sum.plus(part))
}

/// States that a vector is the exact one of `family`, up to the errors that are known of it.
pub fn is(vector: Vec3<Bounded>, family: u8) {
    for (component, number) in (0..).zip(vector.to_array()) {
        number.assume(Polynomial::of([(family, component)]));
    }
}

/// Returns the bound in which lengths are replaced by lengths that are at least as large.
#[must_use]
pub fn enlarged(bound: &Polynomial) -> Polynomial {
    bound.enlarged(&LARGER)
}

/// Returns how much margin the code adds to `number`, as a multiple of `roundoff` times `size`. The constant has the
/// value `margin` in the code. The result is 0 if the code forgets the margin in one of the monomials of `size`.
///
/// # Panics
/// If the code compares the number in `f64`, and the margin is not known to make the comparison harder, or has a
/// rounding error of a relative 10^-9 or more.
#[must_use]
pub fn added(number: Bounded, size: &Polynomial, margin: f64, roundoff: f64) -> f64 {
    for pair in compared().into_iter().filter(|pair| roundoff == U && pair.contains(&number)) {
        assert!(matches!(hardens(pair), Some(0 | 1)), "the margin is on the wrong side of a comparison");
    }
    let [bound, error] = [number.bounds().size, number.bounds().error].map(|bound| bound.enlarged(&[(AXIS, None)]));
    let factor = size.0.iter().map(|(monomial, coefficient)| {
        let product = Polynomial::of([monomial.as_slice(), &[MARGIN]].concat());
        let [of_bound, of_error] = [&bound, &error].map(|bound| bound.coefficient(&product));
        // In `f32` this error is a part of the need. In the compensated formulas it is not known, because it consists
        // of a few roundings of numbers that have no relative bounds here.
        let is_known = arithmetic().roundoff == U && of_error.is_finite();
        assert!(!is_known || of_error * U <= 1e-9 * of_bound, "the margin is not accurate");
        of_bound / coefficient
    });
    // The bounds are rounded up, and the computed margin is rounded, by far less than this.
    factor.fold(f64::INFINITY, f64::min) * margin / roundoff * (1.0 - 1e-8)
}

/// Returns in how many comparisons the margin takes part.
///
/// # Panics
/// If the margin is not known to make them harder.
#[must_use]
pub fn uses_of_margin() -> usize {
    let uses: Vec<_> = compared().into_iter().map(hardens).filter(|effect| *effect != Some(0)).collect();
    assert!(uses.iter().all(|effect| *effect == Some(1)), "the margin is on the wrong side of a comparison");
    uses.len()
}

impl Row {
    /// Returns a row, with the constant and the need.
    #[must_use]
    pub const fn new(what: &'static str, file: &'static str, [constant, need]: [f64; 2], unit: &'static str) -> Self {
        Self { what, file, constant, need, unit }
    }

    /// Whether the constant is as large as is needed.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.need <= self.constant
    }
}

/// Returns the bound of an error in which the margin has its value and lengths are replaced by larger ones.
fn with_margin(error: &Polynomial, margin: f64) -> Polynomial {
    let families = [MARGIN.0, LOST_MARGIN.0];
    let of_margin = families.iter().fold(enlarged(error), |error, &family| error.scaled_by(family, margin));
    of_margin.enlarged(&families.map(|family| (family, None)))
}

/// Returns how large an error is relative to a size that is at least each of `sizes` and `least`, in units of `u`.
///
/// # Panics
/// If there are monomials that none of `sizes` bounds and that are not negligible.
#[must_use]
pub fn relative_to_sizes(error: &Polynomial, margin: f64, sizes: &[Polynomial], least: f64) -> f64 {
    factors(error, margin, sizes, least).into_iter().sum()
}

/// Returns factors with which the sum of the products with `sizes` is at least the error, as [`relative_to_sizes`].
#[must_use]
pub fn factors(error: &Polynomial, margin: f64, sizes: &[Polynomial], least: f64) -> Vec<f64> {
    let (mut factors, mut rest) = (Vec::new(), with_margin(error, margin));
    for size in sizes {
        let factor;
        (factor, rest) = rest.relative_to(&size.enlarged(&LARGER));
        factors.push(factor);
    }
    // What is left must come from underflow or from a constant of the code. Else it is a product that has no bound.
    let from_underflow = arithmetic().underflow * 1e9;
    assert!(rest.0.iter().all(|(of, &rest)| of.is_empty() || rest <= from_underflow), "no size bounds {rest:?}");
    let most = rest.sum() / least;
    assert!(most < 1e-9, "underflow adds {most:e} u: {rest:?}");
    factors[0] += most;
    assert!(factors.iter().all(|factor| factor.is_finite()), "nothing is known of a part of the error");
    factors
}

impl Domain {
    /// Returns how large an error is relative to `size`, in units of `u`. `margin` is the value of the constant.
    ///
    /// What `size` cannot bound comes from underflow. With `w^2 = |O - C|^2 + r^2` it consists of monomials `|d|^i w^j`
    /// with `i, j <= 2`. Relative to `|d|^2 w^2` each is at most `l^-2 s^-2`, with the smallest length `l < 1` of a
    /// direction and the smallest size `s < 1`. Without a smallest size, each is at most `l^-2` times the larger of
    /// `|d|^2 w^2` and 1, if no direction is longer than `1 / l`.
    ///
    /// # Panics
    /// If underflow is not negligible.
    #[must_use]
    pub fn relative(&self, error: &Polynomial, size: &Polynomial, margin: f64) -> f64 {
        self.relative_and_rest(error, size, margin).iter().sum()
    }

    /// Returns the result of [`Self::relative`] in two parts, of which the second one comes from underflow.
    #[must_use]
    pub fn relative_and_rest(&self, error: &Polynomial, size: &Polynomial, margin: f64) -> [f64; 2] {
        let (factor, rest) = with_margin(error, margin).relative_to(size);
        for monomial in rest.0.keys() {
            let directions = monomial.iter().filter(|variable| variable.0 == DIRECTION).count();
            assert!(directions <= 2 && monomial.len() - directions <= 2, "{monomial:?}");
        }
        let (size, limit) = if self.size > 0.0 { (self.size, 1e-6) } else { (1.0, self.underflow) };
        let most = rest.sum() / (self.direction * size).powi(2);
        assert!(most < limit, "underflow adds {most:e} u: {rest:?}");
        assert!(factor.is_finite(), "nothing is known of a part of the error");
        [factor, most]
    }
}
