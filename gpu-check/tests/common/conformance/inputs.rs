//! Inputs of the probes: random rows from fixed seeds, and rows that are hard for one operation; and results within an
//! error.

use cpu::internals::sampling::uniform::Uniform;

use super::Number;

/// Number of random rows of a probe. It is large enough that two different formulas differ in many rows.
const ROWS: usize = 200;

/// Returns random rows with magnitudes from `10^low` to `10^high` and either sign.
pub fn random<T: Number, const N: usize>(low: f64, high: f64) -> Vec<[T; N]> {
    let mut draws = Uniform::new(30);
    let mut draw = || {
        let size = 10.0_f64.powf(draws.draw(low, high));
        T::of(if draws.canonical() < 0.5 { -size } else { size })
    };
    (0..ROWS).map(|_| [(); N].map(|()| draw())).collect()
}

/// Returns random rows of positive numbers with magnitudes from `10^low` to `10^high`.
pub fn positive<T: Number, const N: usize>(low: f64, high: f64) -> Vec<[T; N]> {
    random::<T, N>(low, high).into_iter().map(|row| row.map(T::abs)).collect()
}

/// Returns random rows of any 32 bits, and then all rows of `corners`.
pub fn words<const N: usize>(corners: &[u32]) -> Vec<[u32; N]> {
    let mut draws = Uniform::new(32);
    let mut draw = || draws.draw(0.0, 4_294_967_296.0) as u32;
    let mut rows: Vec<[u32; N]> = (0..ROWS).map(|_| [(); N].map(|()| draw())).collect();
    rows.extend(every(corners));
    rows
}

/// Returns every row whose numbers are among `numbers`.
pub fn every<T: Copy, const N: usize>(numbers: &[T]) -> Vec<[T; N]> {
    let count = numbers.len();
    let row = |index: usize| std::array::from_fn(|place| numbers[index / count.pow(place as u32) % count]);
    (0..count.pow(N as u32)).map(row).collect()
}

/// Returns zeros, and numbers of very different magnitudes that are not subnormal.
pub fn finite<T: Number>() -> Vec<T> {
    [0.0, -0.0, 1.0, -1.0, 0.1, -0.3, 1e-30, -1e-30, 1e30, -7e30, 3.0, 16_777_215.0].map(T::of).to_vec()
}

/// Returns the numbers of [`finite`], infinities and NaN.
pub fn of_every_kind<T: Number>() -> Vec<T> {
    let special = [f64::INFINITY, f64::NEG_INFINITY, f64::NAN].map(T::of);
    [finite(), special.to_vec()].concat()
}

/// Returns subnormal numbers of either sign.
pub fn subnormal<T: Number>() -> Vec<T> {
    [0.9, 0.75, -0.5, -0.1875, 0.001].map(|part| T::TINY * T::of(part)).to_vec()
}

/// Returns all numbers of `f32` from `low` to `high`.
pub fn between(low: f64, high: f64) -> Vec<f32> {
    let first = if f64::from(low as f32) < low { (low as f32).next_up() } else { low as f32 };
    std::iter::successors(Some(first), |number| Some(number.next_up()))
        .take_while(|number| f64::from(*number) <= high)
        .collect()
}

/// Returns the distance between the two neighbours in `f32` that enclose `x`, which section 15.7.4 of the WGSL
/// specification calls a unit in the last place. At a power of two this is the smaller of the two distances.
pub fn ulp(x: f64) -> f64 {
    let magnitude = x.abs().min(f64::from(f32::MAX));
    let near = magnitude as f32;
    let below = if f64::from(near) < magnitude || near == 0.0 { near } else { near.next_down() };
    f64::from(below.next_up()) - f64::from(below)
}

/// Returns the numbers within `units` units in the last place of `exact`, which must be accurate to 2^-45.
pub fn within(exact: f64, units: f64) -> Vec<f32> {
    // The bound itself has an error, because it is computed in `f64`.
    let error = units * ulp(exact) * (1.0 + 1.0 / f64::from(1 << 20));
    between(exact - error, exact + error)
}

/// Returns the two numbers of `f32` next to `exact`, or `exact` alone if it is one.
pub fn neighbours(exact: f64) -> Vec<f32> {
    let near = exact as f32;
    let other = if f64::from(near) < exact { near.next_up() } else { near.next_down() };
    if f64::from(near) == exact { vec![near] } else { vec![near, other] }
}
