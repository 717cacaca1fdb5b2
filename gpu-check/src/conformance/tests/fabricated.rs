//! Results of wrong formulas, which must be failures: none of them is as written or an allowed rewriting.

use super::super::probe::Probe;
use super::super::probes;
use super::super::value::Bits;
use super::super::verdict::{Outcome, Verdict};

/// The probes, and the number of wrong formulas that were tried.
struct Probes(Vec<Probe>, usize);

impl Probes {
    /// Checks that the results of `wrong` are a failure of the probe of this name.
    #[track_caller]
    fn fail<I: Bits, O: Bits, const N: usize>(&mut self, name: &str, wrong: impl Fn([I; N]) -> O) {
        let probe = self.0.iter().find(|probe| probe.name == name).expect("there is a probe of this name");
        assert_eq!((probe.input, probe.output, probe.cases[0].len()), (I::TYPE, O::TYPE, N), "{name}");
        let result = |case: &Vec<u64>| wrong(std::array::from_fn(|index| I::of_bits(case[index]))).to_word();
        let verdict = Verdict::of(probe, &Outcome::Results(probe.cases.iter().map(result).collect()));
        assert!(verdict.is_failure(), "{name}: {verdict}");
        self.1 += 1;
    }
}

#[test]
fn results_of_wrong_formulas_are_failures() {
    let mut probes = Probes(probes::all(), 0);
    formulas(&mut probes);
    functions(&mut probes);
    numbers(&mut probes);
    programs(&mut probes);
    assert_eq!(probes.1, 55);
}

fn formulas(probes: &mut Probes) {
    // This one passed for a rewriting when only "differs from the formula as written" was asked.
    probes.fail("cancel-term", |[a, b]: [f32; 2]| (a + b) + a);
    probes.fail("cancel-term-f64", |[a, b]: [f64; 2]| (a + b) + a);
    probes.fail("cancel-term", |[a, _]: [f32; 2]| a);
    probes.fail("cancel-difference", |[a, b]: [f32; 2]| (a + b) - a);
    probes.fail("reorder-sum", |[a, b, c]: [f32; 3]| (a + b) - c);
    probes.fail("error-of-sum", |[a, b]: [f32; 2]| a + b);
    probes.fail("error-of-sum-barrier-f64", |[a, b, _]: [f64; 3]| -(a - ((a + b) - b)));
    probes.fail("reorder-product", |[a, b, c]: [f32; 3]| (a * b) + c);
    probes.fail("factor-out", |[a, b, c]: [f32; 3]| a * (b - c));
    probes.fail("factor-out-f64", |[a, b, c]: [f64; 3]| b * (a + c));
    probes.fail("contract", |[a, b, c]: [f32; 3]| a * b - c);
    probes.fail("fma", |[a, b, c]: [f32; 3]| a * c + b);
    probes.fail("square-of-root", |[a]: [f32; 1]| a * a);
    probes.fail("root-of-square", |[a]: [f32; 1]| a);
    probes.fail("subtract-itself", |[a]: [f32; 1]| a + a);
    probes.fail("divide-by-itself", |[_]: [f32; 1]| 0.0_f32);
    probes.fail("multiply-by-zero", |[a]: [f32; 1]| a);
    probes.fail("add-zero", |[a]: [f32; 1]| -a);
    probes.fail("negate-difference", |[a, b]: [f32; 2]| a - b);
    probes.fail("merge-constants", |[a]: [f32; 1]| a + 0.1);
}

fn functions(probes: &mut Probes) {
    let off = |number: f32, units: i32| f32::from_bits((number.to_bits() as i32 + units) as u32);
    probes.fail("divide", move |[a, b]: [f32; 2]| off(a / b, 4));
    probes.fail("divide-f64", |[a, b]: [f64; 2]| (a / b).next_up());
    probes.fail("root", move |[a]: [f32; 1]| off(a.sqrt(), 12));
    probes.fail("root-f64", |[a]: [f64; 1]| f64::from((a as f32).sqrt()));
    probes.fail("inverse-root", move |[a]: [f32; 1]| off(1.0 / a.sqrt(), -4));
    probes.fail("remainder", |[a, b]: [f32; 2]| a.rem_euclid(b));
    probes.fail("sin", |[a]: [f32; 1]| a.sin() + 0.001);
    probes.fail("exp", |[a]: [f32; 1]| a.exp() * 1.001);
    probes.fail("log", |[a]: [f32; 1]| a.ln() + 1e-3);
    probes.fail("log2", |[a]: [f32; 1]| a.ln());
    probes.fail("pow", |[a, b]: [f32; 2]| b.powf(a));
    probes.fail("sin-f64", |[a]: [f64; 1]| f64::from((a as f32).sin()));
    probes.fail("exp-f64", |[_]: [f64; 1]| 0.0_f64);
}

fn numbers(probes: &mut Probes) {
    probes.fail("round-half-even", |[a]: [f32; 1]| a.round());
    probes.fail("floor", |[a]: [f32; 1]| a.trunc());
    probes.fail("sum", |[a, b]: [f32; 2]| (a + b).next_up().next_up());
    probes.fail("sign", |[a]: [f32; 1]| a.signum());
    probes.fail("f32-to-i32", |[a]: [f32; 1]| a.round() as i32);
    // Rust limits to 2^31 - 1, and x86 gives the smallest number for all that is out of range. WGSL has another rule.
    probes.fail("f32-to-i32-range", |[a]: [f32; 1]| a as i32);
    probes.fail("f32-to-i32-range", |[a]: [f32; 1]| if a.abs() < 2_147_483_648.0 { a as i32 } else { i32::MIN });
    probes.fail("f32-to-u32-range", |[a]: [f32; 1]| a as u32);
    probes.fail("f64-to-f32", |[a]: [f64; 1]| (a as f32).next_up().next_up());
    probes.fail("bits-through-f32", |[a]: [u32; 1]| a & 0x7fff_ffff);
    probes.fail("min", |[a, b]: [f32; 2]| a.max(b));
    probes.fail("max-with-nan", |[a, _]: [f32; 2]| a);
    probes.fail("compare-nan", |[a, b]: [f32; 2]| if a.is_nan() || b.is_nan() { 64_u32 } else { 0 });
    probes.fail("select", |[a, b, c]: [f32; 3]| a + f32::from(u8::from(c < 0.0)) * (b - a));
    probes.fail("subnormal-copy", |[a]: [f32; 1]| if a.is_subnormal() { 0.0 } else { a });
    probes.fail("subnormal-sum", |[a, b]: [f32; 2]| a - b);
}

fn programs(probes: &mut Probes) {
    probes.fail("i32-remainder", |[a, b]: [i32; 2]| a.wrapping_rem_euclid(b));
    probes.fail("i32-divide-by-zero", |_: [i32; 2]| -1_i32);
    probes.fail("shift-left", |[a, b]: [u32; 2]| a.checked_shl(b).unwrap_or(0));
    probes.fail("shift-right-signed", |[a, b]: [u32; 2]| a.wrapping_shr(b) as i32);
    probes.fail("array-load", |[a]: [u32; 1]| if a < 4 { 0_u32 } else { 99 });
    probes.fail("loop-limit", |[a]: [u32; 1]| {
        (0..a.min(65_535)).fold(1_u32, |sum, step| (sum ^ step).wrapping_mul(0x0100_0193))
    });
}
