//! Numbers and vectors that are hard for floating-point formulas, and random ones of all magnitudes.

use cpu::Vec3;
use stability::random::Random;

/// Numbers for edge cases: zeros, subnormal, very small and very large numbers of f64 and of f32, ordinary numbers, and
/// infinity.
pub const NUMBERS: [f64; 21] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    0.5,
    1e-3,
    1e-8,
    -3.0,
    5e-324,    // smallest of f64
    -2.2e-308, // largest subnormals of f64
    1e-45,     // smallest of f32
    -1.17e-38, // largest subnormals of f32
    1e-30,
    1e-160,
    1e8,
    -1e12,
    1e30,
    3.4e38, // largest of f32
    1e160,
    -1.79e308, // largest of f64
    f64::INFINITY,
];

/// Directions for edge cases: along axes, with tiny, huge or very different components, the null vector, and one with
/// NaN.
pub const DIRECTIONS: [[f64; 3]; 22] = [
    [0.0, 0.0, 1.0],
    [0.0, 0.0, -2.0],
    [0.0, 1.0, 0.0],
    [-0.0, -1.0, -0.0],
    [1.0, 0.0, 0.0],
    [-3.0, 0.0, 0.0],
    [1.0, 1.0, 0.0],
    [0.0, -1.0, 1.0],
    [0.0, 1.0, 1.0],
    [3.0, -4.0, 0.0],
    [1.0, 2.0, -2.0],
    [1.0, 1e-8, 0.0],
    [-1.0, -1e-8, 0.0],
    [1.0, 1e-9, 1e-9],
    [0.0, 0.0, 1e-300],
    [1e-40, 1e-40, 1e-40],
    [5e-324, 0.0, 0.0],
    [1e-5, -1e-5, 2e-5],
    [0.0, 0.0, 1e150],
    [1e30, 1e30, 1e30],
    [0.0, 0.0, 0.0],
    [f64::NAN, 1.0, 0.0],
];

/// Returns all pairs of [`NUMBERS`].
pub fn pairs() -> impl Iterator<Item = (f64, f64)> {
    NUMBERS.into_iter().flat_map(|one| NUMBERS.map(|other| (one, other)))
}

/// Returns a random direction. In one of eight, a component is zero.
pub fn direction(random: &mut Random) -> Vec3 {
    let mut components = random.unit().to_array();
    if random.below(8) == 0 {
        components[random.below(3)] = 0.0;
    }
    components.into()
}

/// Returns a random number of either sign with a magnitude between `10^low` and `10^high`.
pub fn any_size(random: &mut Random, low: f64, high: f64) -> f64 {
    random.sign() * random.decades(low, high)
}

/// Returns a random bool that is true with the probability `1 / times`.
pub fn once_in(random: &mut Random, times: f64) -> bool {
    random.uniform(0.0, times) < 1.0
}

/// One or more rows of numbers, to which vectors and numbers are appended.
#[derive(Debug, Default)]
pub struct Row(pub Vec<f64>);

impl Row {
    /// Appends the three components of a vector.
    pub fn vector(&mut self, vector: impl Into<Vec3>) -> &mut Self {
        self.0.extend(vector.into().to_array());
        self
    }

    /// Appends a number.
    pub fn number(&mut self, number: f64) -> &mut Self {
        self.0.push(number);
        self
    }
}

/// Returns the rows that `edges` appends, and `count` random ones, of which `random` appends each.
pub fn rows(count: usize, seed: u64, edges: fn(&mut Row), random: fn(&mut Random, &mut Row)) -> Vec<f64> {
    let (mut rows, mut generator) = (Row::default(), Random::new(seed));
    edges(&mut rows);
    (0..count).for_each(|_| random(&mut generator, &mut rows));
    rows.0
}
