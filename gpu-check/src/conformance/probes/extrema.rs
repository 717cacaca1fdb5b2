//! Minimum, maximum, limits to a range, and the choice between two numbers.

use crate::conformance::draft::Draft;
use crate::conformance::inputs::{all, between, finite, of_every_kind};
use crate::conformance::probe::Probe;
use crate::conformance::reading::{Allowed, Kind};
use crate::conformance::value::Number;

/// Text for zeros of different sign.
const ZEROS: &str = "IEEE 754: -0 is less than 0 for minimum. WGSL 17.5: b if b < a, and else a; 15.7.2: the sign of \
                     zero may be ignored";
/// Text for NaN.
const NAN: &str = "IEEE 754: minimumNumber gives the number, minimum gives NaN. WGSL 17.5: the number; 15.7.2: NaN may \
                   be assumed absent";

pub fn probes() -> Vec<Probe> {
    let mut probes = generic::<f32>();
    probes.extend(limits());
    probes.extend(generic::<f64>());
    probes
}

fn least<T: Number>(a: T, b: T) -> T {
    T::select(b.less(a), b, a)
}

fn greatest<T: Number>(a: T, b: T) -> T {
    T::select(a.less(b), b, a)
}

fn generic<T: Number>() -> Vec<Probe> {
    // One row comes twice, so that results with either zero in turn follow no other reading.
    let zeros = || all::<T, 2>(&[0.0, -0.0].map(T::of)).into_iter().chain([[-0.0, 0.0].map(T::of)]);
    let is_nan = |number: T| number.wide().is_nan();
    let numbers = || {
        let not_zero = |number: &T| number.wide() != 0.0;
        all::<T, 2>(&finite::<T>().into_iter().filter(not_zero).collect::<Vec<_>>())
    };
    // Some rows have no NaN, and for these the result is fixed.
    let with_nan = || {
        let nan = T::of(f64::NAN);
        let numbers = [1.0, -3.0, 1e30, f64::INFINITY].map(T::of);
        let ordinary = all::<T, 2>(&numbers);
        numbers.into_iter().flat_map(move |a| [[a, nan], [nan, a]]).chain(ordinary)
    };
    let has_nan = move |[a, b]: [T; 2]| is_nan(a) || is_nan(b);
    let other = move |[a, b]: [T; 2], both: fn(T, T) -> T| match (is_nan(a), is_nan(b)) {
        (true, _) => b,
        (false, true) => a,
        (false, false) => both(a, b),
    };
    let nan_or =
        move |row: [T; 2], both: fn(T, T) -> T| if has_nan(row) { T::of(f64::NAN) } else { both(row[0], row[1]) };
    let second_if = |[a, b]: [T; 2]| T::select(b.bits() >> (8 * size_of::<T>() - 1) != 0, b, a);
    let not_first_if = |[a, b]: [T; 2]| T::select(a.bits() >> (8 * size_of::<T>() - 1) != 0, b, a);
    let either = |[a, b]: [T; 2]| Allowed::any_of([a, b]);
    vec![
        Draft::new("min", "min(a, b)", numbers(), |[a, b]: [T; 2]| least(a, b)).rule(NAN).done(),
        Draft::new("max", "max(a, b)", numbers(), |[a, b]: [T; 2]| greatest(a, b)).rule(NAN).done(),
        Draft::new("min-of-zeros", "min(a, b)", zeros(), |[a, b]: [T; 2]| least(a, b))
            .rule(ZEROS)
            .rewriting("b", |[_, b]| b)
            .rewriting("-0 is less than 0", second_if)
            .reading("either zero", Kind::Rewriting, either)
            .done(),
        Draft::new("max-of-zeros", "max(a, b)", zeros(), |[a, b]: [T; 2]| greatest(a, b))
            .rule(ZEROS)
            .rewriting("b", |[_, b]| b)
            .rewriting("0 is greater than -0", not_first_if)
            .reading("either zero", Kind::Rewriting, either)
            .done(),
        Draft::new("min-with-nan", "min(a, b)", with_nan(), move |row| other(row, least))
            .rule(NAN)
            .rewriting("NaN", move |row| nan_or(row, least))
            .rewriting("b if b < a, else a", |[a, b]| least(a, b))
            .rewriting("a if a < b, else b", |[a, b]| least(b, a))
            .finite_math(has_nan)
            .done(),
        Draft::new("max-with-nan", "max(a, b)", with_nan(), move |row| other(row, greatest))
            .rule(NAN)
            .rewriting("NaN", move |row| nan_or(row, greatest))
            .rewriting("b if a < b, else a", |[a, b]| greatest(a, b))
            .rewriting("a if b < a, else b", |[a, b]| greatest(b, a))
            .finite_math(has_nan)
            .done(),
        Draft::new("select", "select(a, b, c < 0.0)", choices(), |[a, b, c]: [T; 3]| {
            T::select(c.less(T::of(0.0)), b, a)
        })
        .rule("WGSL 17.3: b if the condition holds, and else a, whatever the other number is")
        .done(),
    ]
}

/// Rows whose first two numbers are of every kind, and whose third number is of either sign.
fn choices<T: Number>() -> Vec<[T; 3]> {
    let pairs = all::<T, 2>(&of_every_kind());
    pairs.into_iter().flat_map(|[a, b]| [-1.0, 1.0].map(|c| [a, b, T::of(c)])).collect()
}

fn limits() -> Vec<Probe> {
    let sorted = || between::<f32, 3>(-9.0, 9.0).into_iter().map(|[a, b, c]| [a, b.min(c), b.max(c)]);
    let reversed = || sorted().map(|[a, low, high]| [a, high, low]);
    let limited = |[a, low, high]: [f32; 3]| least(greatest(a, low), high);
    let median = |[a, b, c]: [f32; 3]| greatest(least(a, b), least(greatest(a, b), c));
    let words = || between::<f32, 3>(-9.0, 9.0).into_iter().map(|row| row.map(|number| number as i32));
    vec![
        Draft::new("clamp", "clamp(a, b, c)", sorted(), limited)
            .rule("WGSL 15.7.4: min(max(a, b), c), or the median of the three")
            .done(),
        Draft::new("clamp-reversed", "clamp(a, b, c)", reversed(), limited)
            .rule("Here b > c. WGSL 15.7.4: min(max(a, b), c), or the median of the three")
            .rewriting("median", median)
            .done(),
        Draft::new("clamp-integer", "clamp(a, b, c)", words(), |[a, b, c]: [i32; 3]| a.max(b).min(c))
            .rule("WGSL 17.5: min(max(a, b), c), also if b > c")
            .done(),
        Draft::new("saturate", "saturate(a)", between(-1.0, 2.0), |[a]: [f32; 1]| a.clamp(0.0, 1.0))
            .rule("WGSL 17.5: clamp(a, 0, 1)")
            .done(),
    ]
}
