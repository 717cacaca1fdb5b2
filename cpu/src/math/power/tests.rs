use super::*;
use crate::math::{double_double::DoubleDouble, real::Real};
use crate::sampling::uniform::Uniform;

/// Numbers of all magnitudes, and near 1.
fn numbers(draws: &mut Uniform, round: usize) -> f64 {
    match round % 3 {
        0 => draws.draw(0.0, 1.0),
        1 => 1.0 + draws.draw(-1.0, 1.0) * 0.5_f64.powi((round % 50) as i32),
        _ => 10.0_f64.powf(draws.draw(-307.0, 308.0)),
    }
}

#[test]
fn special_values_are_those_of_c() {
    let infinity = f64::INFINITY;
    let powers = [power(-2.0, 3.0), power(-2.0, 2.0), power(0.0, 0.5), power(-infinity, 3.0), power(0.5, infinity)];
    assert_eq!(powers, [-8.0, 4.0, 0.0, -infinity, 0.0]);
    let values = [0.0, -0.0, 0.5, -0.5, 1.0, -1.0, 1.5, -2.0, f64::INFINITY, f64::NEG_INFINITY, f64::NAN];
    for base in values {
        for exponent in [0.5, 1.0, 2.0, 3.0, 2.5, 9007199254740991.0, 9007199254740992.0, 1e300, f64::INFINITY] {
            let (ours, system) = (power(base, exponent), base.powf(exponent));
            assert!(ours.to_bits() == system.to_bits() || ours.is_nan() && system.is_nan(), "{base:e}^{exponent:e}");
        }
        assert!([0.0, -0.0, -1.0, f64::NAN].iter().all(|&exponent| power(base, exponent).is_nan()), "{base}");
    }
}

#[test]
fn exact_powers_and_ties_are_found() {
    assert_eq!([power(4.0, 0.5), power(27.0, 3.0), power(3.0, 33.0)], [2.0, 19683.0, 5559060566555523.0]);
    // 3^34 has 54 bits: it is halfway between two numbers.
    assert_eq!(power(3.0, 34.0), 16677181699666568.0);
    assert!(is_equal(3.0, 34.0, Midpoint { integer: 16677181699666569, exponent: 0 }));
    // The root of a square of 54 bits: (2^53 + 1)^2 has 107 bits, but 94906267^2 has 53.
    assert_eq!(power(94906265.0 * 94906265.0, 0.5), 94906265.0);
    // The square of a number of 27 bits plus a half is halfway where it has 54 bits.
    let half = 94906265.5_f64;
    assert_eq!(power(half, 2.0), half * half);
    let square = Midpoint { integer: 189812531 * 189812531, exponent: -2 };
    assert_eq!(compare(half, 2.0, square, 192), Some(Ordering::Equal));
    // The smallest positive number is twice 2^-1075, which is halfway to zero.
    assert_eq!([power(2.0_f64.powi(-215), 5.0), power(2.0_f64.powi(-537), 2.0)], [0.0, 5e-324]);
    assert_eq!(compare(2.0_f64.powi(-215), 5.0, Midpoint { integer: 1, exponent: -1075 }, 192), Some(Ordering::Equal));
    assert_eq!(power(2.0_f64.powi(-1074), 1.0 / 1074.0), 0.5_f64.powf(1074.0 * (1.0 / 1074.0)));
}

#[test]
fn the_quick_power_is_that_of_integers() {
    let mut draws = Uniform::new(5);
    let mut certain = 0;
    for round in 0..3_000 {
        let (base, exponent) =
            (numbers(&mut draws, round), draws.draw(0.0, 1.0) * 2.0_f64.powi((round % 9) as i32 - 4));
        let quick = quick::power(base, exponent);
        let (Quick::Certain(candidate) | Quick::Candidate(candidate)) = quick;
        certain += usize::from(matches!(quick, Quick::Certain(_)));
        // A wrong candidate does not matter.
        for start in [candidate, candidate.next_up(), candidate.next_down()] {
            assert_eq!(decided(base, exponent, start), candidate, "{base:e}^{exponent:e}");
        }
    }
    assert!(certain > 2_900, "{certain} certain");
}

#[test]
fn tables_and_series_keep_the_laws_of_logarithms_and_powers() {
    let of = DoubleDouble::of;
    let is_near = |a: DoubleDouble, b: DoubleDouble, bits: i32| (a - b).high.abs() < 0.5_f64.powi(bits);
    assert!(is_near(of(3.0) * tables::reciprocal(3), of(1.0), 104));
    // The logarithm of 8/9 is twice that of 4/3, less that of 2.
    let of_4_3 = tables::logarithm(96);
    assert!(is_near(tables::logarithm(144), of_4_3 + of_4_3 - tables::LN_2, 103));
    assert_eq!(tables::logarithm(128), of(0.0));
    let quarter = tables::exponential(16);
    assert_eq!((quarter * quarter * quarter * quarter).high, std::f64::consts::E);
    assert!(is_near(tables::exponential(-16) * quarter, of(1.0), 100));
    assert!(is_near(quick::ln_of_parts(-1, 96, of(0.0)), of_4_3 - tables::LN_2, 103));
    // 4/3 times 1 + 1/256 is 257/192.
    assert!((quick::ln_of_parts(0, 96, of(1.0 / 256.0)).high - (257.0_f64 / 192.0).ln()).abs() < 1e-15);
    assert!(is_near(quick::exp_of_rest(of(0.0), 16), quarter, 100));
    assert!(is_near(quick::exp_of_rest(of(1.0 / 128.0), -1) * quick::exp_of_rest(of(1.0 / 128.0), 0), of(1.0), 80));
}
