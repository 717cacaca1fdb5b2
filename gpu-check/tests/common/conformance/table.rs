//! The table of all probes, by topic. The numbers of sections are those of the WGSL specification,
//! <https://www.w3.org/TR/WGSL/>. IEEE 754 demands what is written, except where a comment says more.

use super::inputs::{
    between, every, finite, neighbours, of_every_kind, positive, random, subnormal, ulp, within, words,
};
use super::{Draft, Number, Probe};

/// Returns all probes, in the order of `docs/gpu/probes.csv`.
pub fn all() -> Vec<Probe> {
    let groups = [
        rewriting::<f32>(),
        rewriting::<f64>(),
        arithmetic(),
        subnormals::<f32>(),
        subnormals::<f64>(),
        comparison::<f32>(),
        comparison::<f64>(),
        conversion(),
        integer(),
        loops(),
    ];
    groups.into_iter().flatten().collect()
}

/// Formulas that drivers simplify by the laws of real numbers. 15.7.5: operations may be reordered such that the exact
/// result stays, and fused if the result is at least as accurate. 15.7.2: the sign of zero, infinities and NaN need not
/// be kept.
fn rewriting<T: Number>() -> Vec<Probe> {
    // The compiler of Rust must not add the two constants.
    let [zero, tenth, fifth] = [0.0, 0.1, 0.2].map(|number| T::of(std::hint::black_box(number)));
    let is_negative = |a: T| a.bits() >> (8 * size_of::<T>() - 1) != 0;
    // The rounding error of a sum, which is exact (Knuth, TAOCP 4.2.2, theorem B).
    let error_of_sum = |[a, b]: [T; 2]| {
        let s = a + b;
        let t = s - a;
        (a - (s - t)) + (b - t)
    };
    let (small, wide) = (|| positive::<T, 2>(-3.0, 3.0), || random::<T, 3>(-3.0, 3.0));
    vec![
        Draft::new("cancel-term", "(a + b) - a", small(), |[a, b]| (a + b) - a).or("rewritten: b", |[_, b]| b).done(),
        Draft::new("cancel-difference", "a - (a - b)", small(), |[a, b]| a - (a - b))
            .or("rewritten: b", |[_, b]| b)
            .done(),
        Draft::new("reorder-sum", "(a + b) + c", wide(), |[a, b, c]| (a + b) + c)
            .or("rewritten: a + (b + c)", |[a, b, c]| a + (b + c))
            .or("rewritten: (a + c) + b", |[a, b, c]| (a + c) + b)
            .done(),
        Draft::new("merge-constants", "(a + 0.1) + 0.2", random(-3.0, 3.0), move |[a]: [T; 1]| (a + tenth) + fifth)
            .or("rewritten: a + (0.1 + 0.2)", move |[a]| a + (tenth + fifth))
            .done(),
        Draft::new("error-of-sum", "(a - (s - t)) + (b - t)", random(-3.0, 3.0), error_of_sum)
            .after("let s = a + b;\nlet t = s - a;\n")
            .or("rewritten: 0", move |_| zero)
            .done(),
        Draft::new("contract", "a * b + c", random(-1.0, 1.0), |[a, b, c]: [T; 3]| a * b + c)
            .or("rewritten: fma(a, b, c)", |[a, b, c]| a.fused(b, c))
            .done(),
        Draft::new("factor-out", "a * b + a * c", wide(), |[a, b, c]| a * b + a * c)
            .or("rewritten: a * (b + c)", |[a, b, c]| a * (b + c))
            .or("rewritten: fma(a, b, a * c)", |[a, b, c]| a.fused(b, a * c))
            .or("rewritten: fma(a, c, a * b)", |[a, b, c]| a.fused(c, a * b))
            .done(),
        Draft::new("square-of-root", "sqrt(a) * sqrt(a)", positive(-3.0, 3.0), |[a]: [T; 1]| a.sqrt() * a.sqrt())
            .or("rewritten: a", |[a]| a)
            .done(),
        Draft::new("multiply-by-zero", "a * 0.0", every(&of_every_kind()), move |[a]: [T; 1]| a * zero)
            .or("rewritten: 0", move |_| zero)
            .or("rewritten: 0 with the sign of a", move |[a]| T::select(is_negative(a), -zero, zero))
            .done(),
        Draft::new("add-zero", "a + 0.0", every(&finite()), move |[a]: [T; 1]| a + zero)
            .or("rewritten: a", |[a]| a)
            .done(),
        Draft::new("negate-difference", "-(a - b)", every(&finite()), |[a, b]: [T; 2]| -(a - b))
            .or("rewritten: b - a", |[a, b]| b - a)
            .done(),
    ]
}

/// 15.7.4: sums and products are rounded correctly, up or down; a quotient has an error of 2.5 units in the last place
/// if |b| is from 2^-126 to 2^126; a root is as accurate as 1 / inverseSqrt(a). WGSL has no rule for f64.
fn arithmetic() -> Vec<Probe> {
    // The inverse root has an error of 2 units, and the quotient one of 2.5.
    let root_by_inverse = |a: f32| {
        let inverse = 1.0 / f64::from(a).sqrt();
        let error = 2.0 * ulp(inverse);
        let [low, high] = [1.0 / (inverse + error), 1.0 / (inverse - error)];
        between(low - 2.6 * ulp(low), high + 2.6 * ulp(high))
    };
    let wide = |[a, b]: [f32; 2]| [a, b].map(f64::from);
    vec![
        sum::<f32>().among("within error: rounded up or down", move |row| neighbours(wide(row).iter().sum())).done(),
        product::<f32>()
            .among("within error: rounded up or down", move |row| neighbours(wide(row).iter().product()))
            .done(),
        quotient::<f32>().among("within error: 2.5 ulp", move |row| within(wide(row)[0] / wide(row)[1], 2.5)).done(),
        root::<f32>().among("within error: 1 / inverseSqrt(a)", move |[a]| root_by_inverse(a)).done(),
        sum::<f64>().done(),
        product::<f64>().done(),
        quotient::<f64>().done(),
        root::<f64>().done(),
    ]
}

fn sum<T: Number>() -> Draft<T, T, 2> {
    Draft::new("sum", "a + b", random(-3.0, 3.0), |[a, b]| a + b)
}

fn product<T: Number>() -> Draft<T, T, 2> {
    Draft::new("product", "a * b", random(-3.0, 3.0), |[a, b]| a * b)
}

fn quotient<T: Number>() -> Draft<T, T, 2> {
    let by_inverse = |[a, b]: [T; 2]| a * (T::of(1.0) / b);
    Draft::new("divide", "a / b", random(-15.0, 15.0), |[a, b]| a / b).or("rewritten: a * (1 / b)", by_inverse)
}

fn root<T: Number>() -> Draft<T, T, 1> {
    Draft::new("root", "sqrt(a)", positive(-30.0, 30.0), |[a]: [T; 1]| a.sqrt())
}

/// Returns the number, or a zero of its sign if it is subnormal and `flush` is set.
fn flushed<T: Number>(number: T, flush: bool) -> T {
    let zero = T::select(number.wide() < 0.0, -T::of(0.0), T::of(0.0));
    T::select(flush && number.abs().less(T::TINY), zero, number)
}

/// Returns the results of `formula` if, for each of `choices`, its bits say whether the first input, the second input
/// and the result are flushed. A zero that replaces a number may have either sign.
fn flushing<T: Number>([a, b]: [T; 2], formula: fn(T, T) -> T, choices: std::ops::RangeInclusive<u8>) -> Vec<T> {
    let exact = formula(a, b);
    let results = choices.flat_map(|choice| {
        let [first, second, result] = [1, 2, 4].map(|bit| choice & bit != 0);
        let number = flushed(formula(flushed(a, first), flushed(b, second)), result);
        // The sign of a zero counts only if the formula as written gives a zero too.
        let is_new = number.wide() == 0.0 && exact.wide() != 0.0;
        [number, T::select(is_new, -number, number)]
    });
    results.collect()
}

/// 15.7.2: operations of 15.7.4 may flush subnormal inputs and results to zero, and a comparison its inputs. All other
/// operations must keep them.
fn subnormals<T: Number>() -> Vec<Probe> {
    let operation = |name, result, cases: Vec<[T; 2]>, formula: fn(T, T) -> T| {
        Draft::new(name, result, cases, move |[a, b]| formula(a, b))
            .among("rewritten: inputs flushed", move |case| flushing(case, formula, 3..=3))
            .among("rewritten: results flushed", move |case| flushing(case, formula, 4..=4))
            .among("rewritten: inputs and results flushed", move |case| flushing(case, formula, 7..=7))
            .among("rewritten: some numbers flushed", move |case| flushing(case, formula, 0..=7))
            .done()
    };
    // Subnormal results of normal inputs, normal results of subnormal inputs, and both subnormal.
    let normal = [1.5, -1.25, 1.0, 3.0].map(|factor| T::TINY * T::of(factor));
    let of_sum = every(&[&subnormal::<T>()[..], &normal].concat());
    let mut of_product: Vec<[T; 2]> = [0.7, 0.3, -0.01, 1.0, 2.0].map(|part| [T::TINY, T::of(part)]).to_vec();
    for small in subnormal::<T>() {
        of_product.extend([[small, T::of(0.5)], [small, T::of(1e10)], [T::of(-3.0), small], [T::of(1.0), small]]);
    }
    let single = every(&[subnormal::<T>(), finite()].concat());
    let pairs = || every::<T, 2>(&[subnormal::<T>(), vec![T::of(0.0), T::TINY]].concat());
    let less = |[a, b]: [T; 2]| u32::from(a.less(b));
    let both = |[a, b]: [T; 2]| [a, b].map(|number| flushed(number, true));
    vec![
        operation("subnormal-sum", "a + b", of_sum, |a, b| a + b),
        operation("subnormal-product", "a * b", of_product, |a, b| a * b),
        Draft::new("subnormal-copy", "a", single, |[a]: [T; 1]| a).done(),
        Draft::new("subnormal-less", "select(0u, 1u, a < b)", pairs(), less)
            .or("rewritten: inputs flushed", move |row| less(both(row)))
            .done(),
        Draft::new("subnormal-select", "select(a, b, b < a)", pairs(), |[a, b]| T::select(b.less(a), b, a))
            .or("rewritten: inputs of < flushed", move |[a, b]| T::select(less(both([b, a])) == 1, b, a))
            .done(),
    ]
}

/// 15.7.2: NaN may be assumed absent. IEEE 754: it is unordered, and not equal to itself. 17.3: `select` returns `b` if
/// the condition holds, and else `a`, whatever the other number is.
fn comparison<T: Number>() -> Vec<Probe> {
    const SIX: &str = "var bits = select(0u, 1u, a < b) + select(0u, 2u, a <= b);\n\
                       bits += select(0u, 4u, a > b) + select(0u, 8u, a >= b);\n\
                       bits += select(0u, 16u, a == b) + select(0u, 32u, a != b);\n";

    let six = |[a, b]: [T; 2]| {
        let bits = [a < b, a <= b, a > b, a >= b, a == b, a != b];
        bits.into_iter().enumerate().map(|(place, holds)| u32::from(holds) << place).sum::<u32>()
    };
    let is_nan = |number: &T| number.wide().is_nan();
    let pairs = || every::<T, 2>(&of_every_kind()).into_iter();
    let choices = pairs().flat_map(|[a, b]| [-1.0, 1.0].map(|c| [a, b, T::of(c)]));
    vec![
        Draft::new("compare", "bits", pairs().filter(move |row| !row.iter().any(is_nan)), six).after(SIX).done(),
        Draft::new("compare-nan", "bits", pairs().filter(move |row| row.iter().any(is_nan)), six)
            .after(SIX)
            .or("rewritten: a != b is false for NaN", move |row| six(row) & !32)
            .or("rewritten: unordered comparisons are true", |_| 0b10_1111)
            .among("rewritten: indeterminate value (assumes finite numbers)", |_| (0..64).collect())
            .done(),
        Draft::new("not-equal-itself", "select(0u, 1u, a != a)", every(&of_every_kind()), move |[a]: [T; 1]| {
            u32::from(is_nan(&a))
        })
        .or("rewritten: false", |_| 0)
        .done(),
        Draft::new("select", "select(a, b, c < 0.0)", choices, |[a, b, c]| T::select(c.less(T::of(0.0)), b, a)).done(),
    ]
}

/// 15.7.6: a conversion to f32 gives either neighbour, to u32 it rounds toward zero. 17.2: `bitcast` keeps the bits,
/// but may flush subnormal numbers (15.7.2).
fn conversion() -> Vec<Probe> {
    /// Ties, neighbours of ties and the largest numbers.
    const WORDS: [u32; 10] =
        [0, 1, 0x0100_0001, 0x0100_0003, 0x7fff_ffbf, 0x7fff_ffc0, 0x7fff_ffff, 0x8000_0000, 0x8000_0080, u32::MAX];
    /// Bits of zeros, subnormal and normal numbers, and infinities.
    const PATTERNS: [u32; 9] =
        [0, 0x8000_0000, 1, 0x807f_ffff, 0x0080_0000, 0x3f80_0000, 0xff7f_ffff, 0x7f80_0000, 0xff80_0000];

    let (unit, mut wide) = (f64::from(f32::EPSILON), random::<f64, 1>(-30.0, 30.0));
    let tie = 1.0 + unit / 2.0;
    wide.extend([tie, tie.next_down(), tie.next_up(), tie + unit, f32::MAX.into(), -0.0].map(|a| [a]));
    let numbers = words::<1>(&PATTERNS).into_iter().map(|[a]| [f32::from_bits(a)]).filter(|[a]| !a.is_nan());
    vec![
        Draft::new("u32-to-f32", "f32(a)", words(&WORDS), |[a]: [u32; 1]| a as f32)
            .among("within error: either neighbour", |[a]| neighbours(a.into()))
            .done(),
        Draft::new("u32-to-f64", "f64(a)", words(&WORDS), |[a]: [u32; 1]| f64::from(a)).done(),
        Draft::new("f32-to-u32", "u32(a)", positive(-1.0, 9.0), |[a]: [f32; 1]| a as u32).done(),
        Draft::new("f64-to-f32", "f32(a)", wide, |[a]: [f64; 1]| a as f32)
            .among("within error: either neighbour", |[a]| neighbours(a))
            .done(),
        Draft::new("bits-of-f32", "bitcast<u32>(a)", numbers, |[a]: [f32; 1]| a.to_bits())
            .among("rewritten: subnormal numbers flushed", |[a]| match a.is_subnormal() {
                true => vec![0, 0x8000_0000],
                false => vec![a.to_bits()],
            })
            .done(),
    ]
}

/// Integer arithmetic, of which f64 by integers consists. 8.7: it is modulo 2^32, a / 0 is a. 8.9: a shift is modulo
/// 32.
fn integer() -> Vec<Probe> {
    const CORNERS: [u32; 9] = [0, 1, 2, 7, 0x7fff_ffff, 0x8000_0000, 0x8000_0001, 0xffff_fffe, u32::MAX];

    let of_two = |name, result, formula: fn(u32, u32) -> u32| {
        Draft::new(name, result, words(&CORNERS), move |[a, b]: [u32; 2]| formula(a, b)).done()
    };
    let shift = |name, result, formula: fn(u32, u32) -> u32| {
        let cases = words::<1>(&CORNERS).into_iter().enumerate().map(|(index, [a])| [a, index as u32 % 100]);
        Draft::new(name, result, cases, move |[a, b]| formula(a, b)).done()
    };
    vec![
        of_two("u32-sum", "a + b", u32::wrapping_add),
        of_two("u32-difference", "a - b", u32::wrapping_sub),
        of_two("u32-product", "a * b", u32::wrapping_mul),
        of_two("u32-divide", "a / b", |a, b| a.checked_div(b).unwrap_or(a)),
        of_two("i32-less", "select(0u, 1u, i32(a) < i32(b))", |a, b| u32::from((a as i32) < b as i32)),
        shift("shift-left", "a << b", u32::wrapping_shl),
        shift("shift-right", "a >> b", u32::wrapping_shr),
        Draft::new("leading-zeros", "countLeadingZeros(a)", words(&CORNERS), |[a]: [u32; 1]| a.leading_zeros()).done(),
    ]
}

/// 9.4: a loop runs until its condition is false; no number of iterations is too large. Each step depends on the sum
/// before it, so that no compiler replaces the loop by a formula.
fn loops() -> Vec<Probe> {
    const ONE: &str = "var sum = 1u;\nfor (var i = 0u; i < a; i++) {\n    sum = (sum ^ i) * 0x01000193u;\n}\n";
    const NESTED: &str = "var sum = 1u;\nfor (var i = 0u; i < a; i++) {\n    for (var j = 0u; j < b; j++) {\n        \
                          sum = (sum ^ (i + j)) * 3u;\n    }\n}\n";
    const CONSECUTIVE: &str = "var sum = 1u;\nfor (var i = 0u; i < a; i++) { sum = (sum ^ i) * 3u; }\n\
                               for (var i = 0u; i < b; i++) { sum = (sum ^ i) * 5u; }\n";

    let counts = [0, 1, 1000, 65_534, 65_535, 65_536, 65_537, 70_000, 100_000, 200_000].map(|count| [count]);
    let nested = [[1, 1], [200, 300], [300, 200], [255, 257], [256, 256], [400, 400], [70_000, 1], [1, 70_000]];
    let consecutive = [[40_000, 20_000], [40_000, 40_000], [9, 90_000]];
    let steps = |sum: u32, count: u32, factor: u32| (0..count).fold(sum, |sum, i| (sum ^ i).wrapping_mul(factor));
    let of_nested =
        |[a, b]: [u32; 2]| (0..a).fold(1_u32, |sum, i| (0..b).fold(sum, |sum, j| (sum ^ (i + j)).wrapping_mul(3)));
    vec![
        Draft::new("loop-limit", "sum", counts, move |[a]: [u32; 1]| steps(1, a, 0x0100_0193)).after(ONE).done(),
        Draft::new("loop-limit-nested", "sum", nested, of_nested).after(NESTED).done(),
        Draft::new("loop-limit-consecutive", "sum", consecutive, move |[a, b]| steps(steps(1, a, 3), b, 5))
            .after(CONSECUTIVE)
            .done(),
    ]
}
