//! Polynomials with coefficients that are not negative, in variables that are not negative. They bound magnitudes.
//!
//! A variable is the magnitude of a number, of a vector's component, or the length of a vector.

use std::collections::BTreeMap;

/// A variable: the family of a vector or number, and the component: 0 to 2, or [`LENGTH`].
pub type Variable = (u8, u8);

/// The component that stands for the length of a vector, or for the magnitude of a number.
pub const LENGTH: u8 = 3;

/// A product of variables in order. A variable that occurs twice is a square.
pub type Monomial = Vec<Variable>;

/// A sum of monomials, each with a positive coefficient.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Polynomial(pub BTreeMap<Monomial, f64>);

/// A factor that covers the rounding of a coefficient: fewer than 2^20 operations lead to one.
const OUTWARD: f64 = 1.0 + f64::EPSILON * 1_048_576.0;

impl Polynomial {
    /// Returns the polynomial that is this constant.
    #[must_use]
    pub fn constant(value: f64) -> Self {
        Self(if value == 0.0 { BTreeMap::new() } else { BTreeMap::from([(Vec::new(), value)]) })
    }

    /// Returns the product of these variables.
    #[must_use]
    pub fn of(variables: impl Into<Monomial>) -> Self {
        let mut variables = variables.into();
        variables.sort_unstable();
        Self(BTreeMap::from([(variables, 1.0)]))
    }

    /// Whether this is one product of variables.
    #[must_use]
    pub fn is_monomial(&self) -> bool {
        self.0.len() == 1 && self.0.iter().all(|(monomial, &factor)| factor == 1.0 && !monomial.is_empty())
    }

    /// Returns the sum.
    #[must_use]
    pub fn plus(mut self, other: &Self) -> Self {
        for (monomial, coefficient) in &other.0 {
            *self.0.entry(monomial.clone()).or_default() += coefficient;
        }
        self
    }

    /// Returns the product with a factor that is not negative.
    #[must_use]
    pub fn scaled(mut self, factor: f64) -> Self {
        if factor == 0.0 {
            return Self::default();
        }
        self.0.values_mut().for_each(|coefficient| *coefficient *= factor);
        self
    }

    /// Returns the product.
    #[must_use]
    pub fn times(&self, other: &Self) -> Self {
        let mut product = Self::default();
        for (left, a) in &self.0 {
            for (right, b) in &other.0 {
                let mut monomial = [left.as_slice(), right].concat();
                monomial.sort_unstable();
                *product.0.entry(monomial).or_default() += a * b;
            }
        }
        product
    }

    /// Returns the polynomial in which the variables of a family are measured in another unit: each is `factor` times
    /// the variable of the result.
    #[must_use]
    pub fn scaled_by(mut self, family: u8, factor: f64) -> Self {
        for (monomial, coefficient) in &mut self.0 {
            let power = monomial.iter().filter(|variable| variable.0 == family).count();
            *coefficient *= factor.powi(power as i32);
        }
        self
    }

    /// Whether each coefficient is at least that of `other`, up to the rounding of coefficients.
    #[must_use]
    pub fn covers(&self, other: &Self) -> bool {
        other.0.iter().all(|(monomial, &most)| self.0.get(monomial).is_some_and(|&own| own * OUTWARD >= most))
    }

    /// Returns the coefficient of a polynomial that is one monomial.
    #[must_use]
    pub fn coefficient(&self, of: &Self) -> f64 {
        of.0.keys().filter_map(|monomial| self.0.get(monomial)).sum()
    }

    /// Returns the sum of the coefficients.
    #[must_use]
    pub fn sum(&self) -> f64 {
        self.0.values().sum()
    }

    /// Returns a polynomial that is at least as large, in lengths of vectors where it has products of components.
    ///
    /// Monomials that differ only in the components of two vectors `x` and `y` are a form `sum C_ij x_i y_j`. It is at
    /// most `|x| |y|` times the norm of `C`, which is at most the root of its largest row sum times its largest column
    /// sum. For a dot product, where `C` is diagonal, this is Cauchy and Schwarz's inequality.
    #[must_use]
    pub fn in_lengths(&self) -> Self {
        let mut forms: BTreeMap<(Monomial, [u8; 2]), [[f64; 3]; 3]> = BTreeMap::new();
        let mut result = Self::default();
        for (monomial, &coefficient) in &self.0 {
            let components: Vec<_> = monomial.iter().filter(|variable| variable.1 != LENGTH).collect();
            if let [&(x, i), &(y, j)] = components[..] {
                let rest = monomial.iter().copied().filter(|variable| variable.1 == LENGTH).collect();
                forms.entry((rest, [x, y])).or_default()[usize::from(i)][usize::from(j)] += coefficient;
            } else {
                *result.0.entry(monomial.clone()).or_default() += coefficient;
            }
        }
        for ((mut monomial, [x, y]), form) in forms {
            let sum =
                |of: &dyn Fn(usize, usize) -> f64| (0..3).map(|i| (0..3).map(|j| of(i, j)).sum()).fold(0.0, f64::max);
            let (rows, columns): (f64, f64) = (sum(&|i, j| form[i][j]), sum(&|i, j| form[j][i]));
            monomial.extend([(x, LENGTH), (y, LENGTH)]);
            monomial.sort_unstable();
            *result.0.entry(monomial).or_default() += (rows * columns).sqrt() * OUTWARD;
        }
        result
    }

    /// Returns the polynomial in which lengths of families, and components of their vectors, are replaced by lengths
    /// that are at least as large, or by 1 for a family that is mapped to `None`.
    #[must_use]
    pub fn enlarged(&self, larger: &[(u8, Option<u8>)]) -> Self {
        let mut result = Self::default();
        for (monomial, &coefficient) in &self.0 {
            let replaced = |&(family, component): &Variable| match larger.iter().find(|(old, _)| *old == family) {
                Some((_, new)) => new.map(|new| (new, LENGTH)),
                None => Some((family, component)),
            };
            let mut monomial: Monomial = monomial.iter().filter_map(replaced).collect();
            monomial.sort_unstable();
            *result.0.entry(monomial).or_default() += coefficient;
        }
        result
    }

    /// Returns the smallest factor that this method finds with `self <= factor * size + rest`, and the rest: the
    /// monomials that it cannot compare with `size`.
    ///
    /// A monomial `m` with `m^2 = s t`, where `s` and `t` are monomials of `size`, is at most `(s + t) / 2`, because
    /// the arithmetic mean is at least the geometric one.
    #[must_use]
    pub fn relative_to(&self, size: &Self) -> (f64, Self) {
        let mut carried: BTreeMap<&Monomial, f64> = BTreeMap::new();
        let mut rest = Self::default();
        for (monomial, &coefficient) in &self.0 {
            if let Some((same, _)) = size.0.get_key_value(monomial) {
                *carried.entry(same).or_default() += coefficient;
                continue;
            }
            let square = Self::of([monomial.as_slice(), monomial].concat());
            let pair = size.0.keys().find_map(|first| {
                let second = size.0.keys().find(|second| Self::of([first.as_slice(), second].concat()) == square)?;
                Some([first, second])
            });
            match pair {
                Some(pair) => pair.into_iter().for_each(|half| *carried.entry(half).or_default() += coefficient / 2.0),
                None => _ = rest.0.insert(monomial.clone(), coefficient),
            }
        }
        let factor = carried.into_iter().map(|(monomial, carried)| carried / size.0[monomial]).fold(0.0, f64::max);
        assert!(!self.0.values().any(|coefficient| coefficient.is_nan()), "{self:?}");
        (factor * OUTWARD, rest)
    }
}
