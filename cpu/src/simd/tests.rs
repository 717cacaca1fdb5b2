//! Compares every operation of every instruction set, lane by lane, with the operation on a single number.

pub(crate) mod positive_nan;

use crate::math::real::Real;
use crate::simd::instruction_set::InstructionSet;
use crate::simd::*;

/// Numbers for which instruction sets could differ.
const AWKWARD: [f64; 12] = [
    0.0,
    -0.0,
    1.0,
    -1.5,
    1.0 / 3.0,
    f64::MIN_POSITIVE,
    -5e-324,
    f64::MAX,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::NAN,
    1.0 + f64::EPSILON,
];

/// Returns 16 of `numbers`, from index `first` on. After the last number the first one follows again.
fn some<T: Copy>(numbers: &[T], first: usize) -> [T; 16] {
    std::array::from_fn(|lane| numbers[(first + lane) % numbers.len()])
}

/// Returns the bits of a number, or `None` for NaN, whose bits are not specified.
fn bits(number: f64) -> Option<u64> {
    (!number.is_nan()).then(|| number.to_bits())
}

/// A kernel that checks the operations of an instruction set on `f64` lanes, and returns their number.
struct Doubles;

impl Kernel for Doubles {
    type Output = usize;

    #[inline(always)]
    fn call<S: Simd>(self, _: S) -> usize {
        for first in 0..AWKWARD.len() {
            for second in 0..AWKWARD.len() {
                let (left, right) = (some(&AWKWARD, first), some(&AWKWARD, second));
                let (x, y) = (S::F64::load(&left), S::F64::load(&right));
                same(x + y, |lane| left[lane] + right[lane]);
                same(x - y, |lane| left[lane] - right[lane]);
                same(x * y, |lane| left[lane] * right[lane]);
                same(x / y, |lane| left[lane] / right[lane]);
                same(-x, |lane| -left[lane]);
                same(x.abs(), |lane| left[lane].abs());
                same(x.sqrt(), |lane| left[lane].sqrt());
                same(x.mul_add(y, x), |lane| left[lane].mul_add(right[lane], left[lane]));
                same(S::F64::of(right[0]), |_| right[0]);
                let mut loosely = [0.0; 16];
                x.mul_add_loosely(y, x).store(&mut loosely);
                for (&actual, (l, r)) in loosely.iter().zip(left.into_iter().zip(right)).take(S::F64::LANES) {
                    assert!([l.mul_add(r, l), l * r + l].map(bits).contains(&bits(actual)), "{l:e} {r:e}: {actual:e}");
                }
                let (less, less_equal) = (x.less(y), x.less_equal(y));
                let expected = |test: fn(&f64, &f64) -> bool| -> u32 {
                    (0..S::F64::LANES).map(|lane| u32::from(test(&left[lane], &right[lane])) << lane).sum()
                };
                let [picked, not_above] = [less, less_equal].map(S::F64::bits);
                assert_eq!([picked, not_above], [expected(f64::lt), expected(f64::le)]);
                assert_eq!(S::F64::bits(!(less | less_equal)), !not_above & ((1 << S::F64::LANES) - 1));
                assert_eq!(S::F64::bits(less & less_equal), picked);
                same(S::F64::select(less, x, y), |lane| if picked >> lane & 1 == 1 { left[lane] } else { right[lane] });
                same(x.flipped_by(y), |lane| if right[lane] < 0.0 { -left[lane] } else { left[lane] });
            }
        }
        for bits in 0..1_u32 << S::F64::LANES {
            let these = some(&AWKWARD[..9], 0);
            let selected: Vec<usize> = (0..S::F64::LANES).filter(|lane| bits >> lane & 1 == 1).collect();
            let mut place = [7.0; 16];
            S::F64::load(&these).store_selected(bits, &mut place);
            for (at, &lane) in selected.iter().enumerate() {
                assert_eq!(place[at].to_bits(), these[lane].to_bits(), "{bits:b}");
            }
            assert!(place[S::F64::LANES..].iter().all(|&number| number == 7.0), "stored beyond the lanes");
        }
        S::F64::LANES
    }
}

/// Checks that lane `i` holds the bits of `expected(i)`, or that both are NaN.
#[inline(always)]
fn same<V: SimdF64>(lanes: V, expected: impl Fn(usize) -> f64) {
    let mut actual = [0.0; 16];
    lanes.store(&mut actual);
    for (lane, &number) in actual.iter().enumerate().take(V::LANES) {
        assert_eq!(bits(number), bits(expected(lane)), "lane {lane}: {number:e} for {:e}", expected(lane));
    }
}

/// A kernel that checks the operations of an instruction set on `f32` lanes, and returns their number.
struct Singles;

impl Kernel for Singles {
    type Output = usize;

    #[inline(always)]
    fn call<S: Simd>(self, _: S) -> usize {
        let awkward = AWKWARD.map(|number| number as f32);
        for first in 0..awkward.len() {
            for second in 0..awkward.len() {
                let (left, right) = (some(&awkward, first), some(&awkward, second));
                let (x, y) = (S::F32::load(&left), S::F32::load(&right));
                let bits = |number: f32| (!number.is_nan()).then(|| number.to_bits());
                let stored = |lanes: S::F32| {
                    let mut place = [0.0; 16];
                    lanes.store(&mut place);
                    place
                };
                let results = [x + y, x - y, x * y, x.min(y), x.max(y), S::F32::splat(right[0])].map(stored);
                let (fused, at_most) = (stored(x.mul_add(y, x)), x.less_equal(y));
                let negative = stored(x.negative_mul_add(y, x));
                for lane in 0..S::F32::LANES {
                    let (l, r) = (left[lane], right[lane]);
                    let (least, most) = (if l < r { l } else { r }, if l > r { l } else { r });
                    let expected = [l + r, l - r, l * r, least, most, right[0]];
                    assert_eq!(results.map(|lanes| bits(lanes[lane])), expected.map(bits), "{l:e}, {r:e}");
                    let allowed = [l.mul_add(r, l), l * r + l].map(bits);
                    assert!(allowed.contains(&bits(fused[lane])), "{l:e} {r:e} + {l:e} is not {:e}", fused[lane]);
                    let allowed = [(-l).mul_add(r, l), l - l * r].map(bits);
                    let actual = negative[lane];
                    assert!(allowed.contains(&bits(actual)), "{l:e} - {l:e} {r:e} is not {actual:e}");
                    assert_eq!(at_most >> lane & 1 == 1, l <= r, "{l:e}, {r:e}");
                }
                assert_eq!(at_most >> S::F32::LANES.min(31), 0);
            }
        }
        let mut bytes = [0; 16];
        for first in 0..=u8::MAX {
            for (lane, byte) in bytes.iter_mut().enumerate() {
                *byte = first.wrapping_add(17 * lane as u8);
            }
            let mut numbers = [0.0; 16];
            S::F32::load_bytes(&bytes).store(&mut numbers);
            assert_eq!(numbers[..S::F32::LANES], bytes.map(f32::from)[..S::F32::LANES]);
        }
        S::F32::LANES
    }
}

#[test]
fn every_set_does_in_each_lane_what_is_done_alone() {
    let lanes = |set: InstructionSet| (set.run(Doubles), set.run(Singles));
    let expected = [(4, 4), (2, 4), (4, 4), (4, 8), (8, 16), (8, 16)];
    for (set, expected) in InstructionSet::ALL.into_iter().zip(expected) {
        if set.is_available() {
            assert_eq!(lanes(set), expected, "{}", set.name());
        }
    }
}
