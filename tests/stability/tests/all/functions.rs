//! The tangent and the power against arithmetic of 256 bits of another library, and dyadic numbers against 1,200 bits.
//!
//! `RENDER_CASES` is the number of random arguments of each function; tests/extensive takes ten million of both.

use std::cmp::Ordering;

use cpu::internals::math::dyadic::{Dyadic, sign_with_sqrt, sign_with_two_sqrts};
use cpu::internals::math::{power::power, tangent::tangent};
use dashu_float::FBig;
use dashu_float::round::mode::HalfEven;
use stability::random::Random;

type Big = FBig<HalfEven, 2>;

const BITS: usize = 256;

fn cases() -> usize {
    std::env::var("RENDER_CASES").map_or(4_000, |text| text.parse().expect("RENDER_CASES is a number"))
}

/// Returns `value` with 256 bits.
fn big(value: f64) -> Big {
    with_bits(value, BITS)
}

fn with_bits(value: f64, bits: usize) -> Big {
    Big::try_from(value).expect("the value is finite").with_precision(bits).value()
}

fn magnitude(value: Big) -> Big {
    if value < Big::ZERO { -value } else { value }
}

/// Whether `result` is `exact`, correctly rounded. `exact` is wrong by much less than `2^-200` of itself, so a number
/// that is nearer than that to a midpoint is a tie. It must have been rounded to an even fraction.
fn is_nearest(result: f64, exact: &Big) -> bool {
    let tolerance = exact.clone() >> 200;
    // Beyond the largest number the next one would be 2^1024.
    let upper = if result == f64::MAX { big(2.0_f64.powi(1023)) * big(2.0) } else { big(result.next_up()) };
    [big(result.next_down()), upper].into_iter().all(|neighbour| {
        let farther = magnitude(&neighbour - exact) - magnitude(big(result) - exact);
        farther > tolerance || farther > -tolerance.clone() && result.to_bits().is_multiple_of(2)
    })
}

fn check_power(base: f64, exponent: f64) {
    let result = power(base, exponent);
    let exact = (big(base).ln() * big(exponent)).exp();
    assert!(is_nearest(result, &exact), "{base:e}^{exponent:e} is not {result:e}");
}

fn check_tangent(angle: f64) {
    let result = tangent(angle);
    assert!(is_nearest(result, &big(angle).tan()), "tan {angle:e} is not {result:e}");
}

#[test]
fn tangents_are_correctly_rounded() {
    for degrees in 1..1800 {
        // The angle of a field of view, as the camera computes it.
        check_tangent(f64::from(degrees) / 10.0 * std::f64::consts::PI / 180.0 / 2.0);
    }
    let mut random = Random::new(11);
    for _ in 0..cases() {
        check_tangent(random.uniform(0.0, std::f64::consts::FRAC_PI_2));
        // tan x = x + x^3 / 3 + ... is near a number or a midpoint if x is small.
        check_tangent(random.decades(-9.0, -3.0));
        check_tangent(std::f64::consts::FRAC_PI_2 - random.decades(-16.0, -3.0));
    }
}

#[test]
fn the_tangent_of_every_small_angle_is_the_angle() {
    // Between powers of two, `tan x - x` grows with `x` and half a unit in the last place is constant, so the largest
    // number decides. Subnormal numbers have the unit of the first normal ones.
    for exponent in (1..=1023 - 26).rev() {
        let largest = f64::from_bits(exponent << 52).next_down();
        let (exact, is_small) = (big(largest).tan(), exponent <= 1023 - 27);
        assert!(is_small == is_nearest(largest, &exact) && is_nearest(tangent(largest), &exact), "{largest:e}");
    }
}

#[test]
fn powers_are_correctly_rounded() {
    let mut random = Random::new(12);
    for _ in 0..cases() {
        // Means and the exponents of usual gammas.
        let gamma = random.decades(-1.0, 1.0);
        check_power(random.uniform(0.0, 1.0), 1.0 / gamma);
        // Every magnitude whose power is a normal number.
        let (base, size) = (random.decades(-300.0, 300.0), random.uniform(-300.0, 300.0));
        let exponent = size / base.log10();
        if exponent > 0.0 {
            check_power(base, exponent);
        }
    }
}

#[test]
fn powers_near_midpoints_are_correctly_rounded() {
    let mut checked = 0;
    // (1 + k e)^y = 1 + y k e + ..., where e is a unit in the last place: half of these are near a midpoint.
    for steps in 1..300_u64 {
        for exponent in [0.25, 0.5, 1.5, 2.5, 3.5] {
            for base in [f64::from_bits(1.0_f64.to_bits() + steps), f64::from_bits(1.0_f64.to_bits() - steps)] {
                check_power(base, exponent);
                checked += 1;
            }
        }
    }
    // Squares and cubes of short numbers are midpoints, or exact, or neither.
    let mut random = Random::new(13);
    for round in 0..1_500 {
        let short = (random.uniform(1.0, 2.0) * 2.0_f64.powi(round % 27)).floor();
        for exponent in [1.0, 2.0, 3.0, 0.5] {
            check_power(short, exponent);
            check_power(short * short, exponent / 2.0);
            checked += 2;
        }
    }
    assert!(checked > 10_000, "{checked} powers were checked");
}

/// Checks the sign of a number that is zero, or far above `2^-1000`.
fn check_sign(sign: Ordering, exact: &Big, of: [f64; 5]) {
    let is_zero = magnitude(exact.clone()) < Big::ONE >> 1000;
    let expected = if is_zero { Ordering::Equal } else { exact.cmp(&Big::ZERO) };
    assert_eq!(sign, expected, "{of:?}");
}

#[test]
fn sums_products_and_signs_of_dyadic_numbers_are_right() {
    let (mut random, mut zeros) = (Random::new(15), 0);
    for round in 0..cases() {
        // Half of the numbers are short, so that sums of square roots may vanish.
        let mut number = || match round % 2 {
            0 => random.decades(-9.0, 9.0) * random.uniform(-1.0, 1.0),
            _ => random.below(17) as f64 - 8.0,
        };
        let [y, z, d, e] = [number(), number(), number(), number()];
        let [d, e] = if round % 2 == 0 { [d.abs(), e.abs()] } else { [d * d, e * e] };
        let one_root = -y * d.sqrt();
        let (x, two_roots) = (-y * z, one_root - z * e.sqrt());
        let exact = |value: f64| Dyadic::new(value).expect("the value is finite");
        let big = |value: f64| with_bits(value, 1200);
        let of = [x, y, z, d, e];
        let sum = &(&exact(y) * &exact(z)) + &exact(x);
        check_sign(sum.sign(), &(big(y) * big(z) + big(x)), of);
        zeros += usize::from(sum.sign() == Ordering::Equal);
        let [of_y, of_z] = [big(y) * big(d).sqrt(), big(z) * big(e).sqrt()];
        check_sign(sign_with_sqrt(&exact(one_root), &exact(y), &exact(d)), &(big(one_root) + &of_y), of);
        let sign = sign_with_two_sqrts(&exact(two_roots), (&exact(y), &exact(d)), (&exact(z), &exact(e)));
        check_sign(sign, &(big(two_roots) + of_y + of_z), of);
    }
    assert!(zeros > cases() / 3 && zeros < cases(), "{zeros}");
}

#[test]
fn a_neighbour_of_the_nearest_number_is_not_taken_for_it() {
    let exact = big(2.0).sqrt();
    let nearest = 2.0_f64.sqrt();
    assert!(
        is_nearest(nearest, &exact)
            && !is_nearest(nearest.next_up(), &exact)
            && !is_nearest(nearest.next_down(), &exact)
    );
    // A tie.
    let tie = big(1.0) + big(f64::EPSILON / 2.0);
    assert!(is_nearest(1.0, &tie) && !is_nearest(1.0_f64.next_up(), &tie));
}
