//! The errors of a quadratic, and what follows for its roots.

use cpu::internals::exact::{error_bound::BoundConstants, error_bound::NUMERATOR_WEIGHT};

/// The errors of a quadratic `a lambda^2 - 2 h lambda + c` and of its discriminant, in units of `u`.
pub struct QuadraticErrors {
    /// The constants of the filter.
    pub constants: BoundConstants,
    /// The constant in the code for the error of the discriminant.
    pub constant: f64,
    /// The file that has it.
    pub file: &'static str,
    /// Relative to `|d|^2` for a sphere, and to `|d| |d'|` for a cylinder, where `d'` is the part of `d` across the
    /// axis: each term of first order has a factor `|d'|`.
    pub a: f64,
    /// Relative to `|d| |O - C|`.
    pub h: f64,
    /// Relative to `|O - C|^2`, and to `r^2`.
    pub c: [f64; 2],
    /// Relative to `M = |d|^2 (|O - C|^2 + r^2)`.
    pub discriminant: f64,
}

impl QuadraticErrors {
    /// Returns what the numerator `n = h -+ sqrt(D)` needs, times `sqrt(D)`, relative to `M`.
    ///
    /// `sqrt(D) <= |d| r` and `sqrt(D) <= sqrt(M)`, up to the error of `D`, which adds less than 10^-5. The error of
    /// `h` times `sqrt(D)` is at most `e |d|^2 |O - C| r <= e M / 2`. The error of the root times `sqrt(D)` is at most
    /// that of `D`, and one rounding. The rounding of the difference is at most `|h| sqrt(D) + D <= (1/2 + 1) M`.
    ///
    /// This needs `D >= 0`. If `D < 0`, there is no hit, and a root that is too small is the right answer. The
    /// comparison itself rounds twice, and the computed `M` has an error of some 10 u. The constants exceed the needs
    /// by more than that.
    #[must_use]
    pub fn numerator(&self) -> f64 {
        self.discriminant + 1.0 + self.h / 2.0 + 1.5
    }

    /// Returns the largest relative error of an accepted lambda, where `M + w n^2 < k n sqrt(D)` with the
    /// weight `w = 4`.
    ///
    /// The errors of the coefficients move a root by at most `(lambda^2 Ea + 2 lambda Eh + Ec) / (2 sqrt(D))`. Its
    /// evaluation adds `(h^2 + a |c| + D) / (2 sqrt(D)) + sqrt(D) + 2 n` roundings. Relative to lambda, and times `n
    /// sqrt(D)`, the sum is at most `A M + B n sqrt(M) + C n^2`, plus `2 n sqrt(D)`. By the condition it is at most `k`
    /// times the largest value of `(A + B t + C t^2) / (1 + w t^2)`, plus 2.
    ///
    /// `h^2 + a |c| + 3 D` is `4 D <= 4 a r^2` if `c < 0`, and otherwise `2 h^2 + 2 D <= 2 a (|O - C|^2 + r^2)`. For a
    /// cylinder `Ea` is relative to `|d| |d'|`. As `n <= |d'| (|O - C| + r)`, `Ea` adds to `B`, and not to `C`:
    /// `across` is what it adds.
    #[must_use]
    pub fn lambda(&self, across: f64) -> f64 {
        let [q, p] = self.c.map(|error| error / 2.0);
        let a = (q + 1.0).max(p + 2.0);
        let (b, c) = if across > 0.0 { (self.h + across, 0.0) } else { (self.h, self.a / 2.0) };
        // The smallest s with A + B t + C t^2 <= s (1 + w t^2) for all t has B^2 = 4 (s - A) (w s - C).
        let w = NUMERATOR_WEIGHT;
        let (sum, product) = (a + c / w, (a * c - b * b / 4.0) / w);
        let largest = (sum + (sum * sum - 4.0 * product).sqrt()) / 2.0;
        largest * self.constants.condition_limit + 2.0
    }
}
