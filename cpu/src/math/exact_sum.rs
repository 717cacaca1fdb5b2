//! Sums without a rounding error, short of overflow, and of underflow of a product. They are expansions: lists of
//! numbers whose bits do not overlap (Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric
//! predicates", Discrete & Computational Geometry 18, 1997).

use crate::math::{double_double::DoubleDouble, error_free::two_product, error_free::two_sum, real::Real};

/// The exact sum of at most `N` numbers.
pub(crate) struct ExactSum<const N: usize> {
    /// The first `count` numbers make up the sum, in order of magnitude. Only the last one may be zero.
    parts: [f64; N],
    count: usize,
}

impl<const N: usize> ExactSum<N> {
    /// Returns an empty sum.
    #[inline(always)]
    pub(crate) const fn new() -> Self {
        Self { parts: [0.0; N], count: 0 }
    }

    /// Adds a number.
    #[inline(always)]
    pub(crate) fn add(&mut self, term: f64) {
        let (mut sum, mut kept) = (term, 0);
        for index in 0..self.count {
            let (next, error) = two_sum(sum, self.parts[index]);
            if error != 0.0 {
                self.parts[kept] = error;
                kept += 1;
            }
            sum = next;
        }
        self.parts[kept] = sum;
        self.count = kept + 1;
    }

    /// Adds `a b`, which counts as two numbers.
    #[inline(always)]
    pub(crate) fn add_product(&mut self, a: f64, b: f64) {
        let (product, error) = two_product(a, b);
        self.add(error);
        self.add(product);
    }

    /// Returns the sum, with a relative error of at most 12 u^2. Between the bits of two parts there is at least one
    /// bit, which is zero (Shewchuk, theorem 10). So each part is at most half of the next, and the sum up to a part
    /// lies between half and one and a half of the part. The sums but for the last one are together less than 3 times
    /// that one, and each addition has an error of at most 3 u^2. A last part of zero is added without an error.
    #[inline(always)]
    pub(crate) fn rounded(&self) -> DoubleDouble {
        self.parts[..self.count].iter().fold(DoubleDouble::default(), |sum, &part| sum + DoubleDouble::of(part))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::dyadic::Dyadic;
    use crate::sampling::uniform::Uniform;

    #[test]
    fn what_cancels_leaves_the_rest() {
        let mut sum = ExactSum::<8>::new();
        for term in [1e300, 1.0, 1e-300, -1e300, 0.0, -1.0] {
            sum.add(term);
        }
        assert_eq!(sum.rounded(), DoubleDouble::of(1e-300));
        sum.add_product(1e-150, -1e-150);
        assert!(sum.rounded().high.abs() < 1e-315);
    }

    #[test]
    fn sums_of_products_that_cancel_are_those_of_dyadic_numbers() {
        let mut draws = Uniform::new(7);
        let dyadic = |value| Dyadic::new(value).unwrap();
        for number in 0..2000 {
            let mut sum = ExactSum::<20>::new();
            let mut expected = dyadic(0.0);
            let mut add = |a: f64, b: f64| {
                sum.add_product(a, b);
                expected = &expected + &(&dyadic(a) * &dyadic(b));
            };
            for _ in 0..5 {
                let [a, b] = [(); 2].map(|()| draws.draw(-1.0, 1.0) * 2.0_f64.powf(draws.draw(-99.0, 99.0)));
                add(a, b);
                // All but the last bits of the product cancel, or all bits.
                add(-a, if number % 2 == 0 { b } else { b.next_up() });
            }
            let sum = sum.rounded();
            let error = &(&dyadic(sum.high) + &dyadic(sum.low)) - &expected;
            let relative = error.to_double_double(0).high / expected.to_double_double(0).high;
            assert!(relative.abs() < 12.0 * 2.0_f64.powi(-106) || (sum.high == 0.0 && number % 2 == 0), "{relative:e}");
        }
    }
}
