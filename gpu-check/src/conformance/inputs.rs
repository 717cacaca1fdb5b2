//! Inputs of the probes: random rows from fixed seeds, and rows that are hard for one operation.

use cpu::internals::sampling::uniform::Uniform;

use super::value::Number;
/// Number of random rows of a probe. It is large enough that two different formulas differ in many rows.
const ROWS: usize = 200;

/// Returns a random number of either sign with a magnitude between `10^low` and `10^high`.
pub fn of_any_size(draws: &mut Uniform, low: f64, high: f64) -> f64 {
    let size = 10.0_f64.powf(draws.draw(low, high));
    if draws.canonical() < 0.5 { -size } else { size }
}

/// Returns random rows with magnitudes from `10^low` to `10^high` and either sign.
pub fn random<T: Number, const N: usize>(low: f64, high: f64) -> Vec<[T; N]> {
    let mut draws = Uniform::new(30);
    (0..ROWS).map(|_| [(); N].map(|()| T::of(of_any_size(&mut draws, low, high)))).collect()
}

/// Returns random rows of positive numbers with magnitudes from `10^low` to `10^high`.
pub fn positive<T: Number, const N: usize>(low: f64, high: f64) -> Vec<[T; N]> {
    random::<T, N>(low, high).into_iter().map(|row| row.map(T::abs)).collect()
}

/// Returns random rows of numbers between `low` and `high`.
pub fn between<T: Number, const N: usize>(low: f64, high: f64) -> Vec<[T; N]> {
    let mut draws = Uniform::new(31);
    (0..ROWS).map(|_| [(); N].map(|()| T::of(draws.draw(low, high)))).collect()
}

/// Returns random rows of any 32 bits, and then all rows of `corners`.
pub fn words<const N: usize>(corners: &[u32]) -> Vec<[u32; N]> {
    let mut draws = Uniform::new(32);
    let mut rows: Vec<[u32; N]> =
        (0..ROWS).map(|_| [(); N].map(|()| draws.draw(0.0, 4_294_967_296.0) as u32)).collect();
    rows.extend(all(corners));
    rows
}

/// Returns every row whose numbers are among `numbers`.
pub fn all<T: Copy, const N: usize>(numbers: &[T]) -> Vec<[T; N]> {
    let count = numbers.len();
    let row = |index: usize| std::array::from_fn(|place| numbers[index / count.pow(place as u32) % count]);
    (0..count.pow(N as u32)).map(row).collect()
}

/// Returns numbers of every kind: zeros, subnormal and normal numbers, infinities and NaN.
pub fn of_every_kind<T: Number>() -> Vec<T> {
    let mut numbers = finite::<T>();
    numbers.extend([f64::INFINITY, f64::NEG_INFINITY, f64::NAN].map(T::of));
    numbers
}

/// Returns zeros, and numbers of very different magnitudes that are not subnormal.
pub fn finite<T: Number>() -> Vec<T> {
    [0.0, -0.0, 1.0, -1.0, 0.1, -0.3, 1e-30, -1e-30, 1e30, -7e30, 3.0, 16_777_215.0].map(T::of).to_vec()
}

/// Returns subnormal numbers of either sign.
pub fn subnormal<T: Number>() -> Vec<T> {
    let parts = [0.9, 0.75, -0.5, -0.1875, 0.001];
    parts.map(|part| T::TINY * T::of(part)).to_vec()
}
