//! Results of wrong formulas, which must be failures: none of them is as written or an allowed rewriting.

use super::super::outcome::Outcome;
use super::super::probe::Probe;
use super::super::probes;
use super::super::value::Bits;
use super::super::verdict::Verdict;

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
    numbers(&mut probes);
    probes.fail("shift-left", |[a, b]: [u32; 2]| a.checked_shl(b).unwrap_or(0));
    probes.fail("i32-less", |[a, b]: [u32; 2]| u32::from(a.wrapping_sub(b) as i32 > 0));
    probes.fail("loop-limit", |[a]: [u32; 1]| {
        (0..a.min(65_535)).fold(1_u32, |sum, step| (sum ^ step).wrapping_mul(0x0100_0193))
    });
    assert_eq!(probes.1, 35);
}

fn formulas(probes: &mut Probes) {
    // A test that only compares with the formula as written would take this formula for a rewriting.
    probes.fail("cancel-term", |[a, b]: [f32; 2]| (a + b) + a);
    probes.fail("cancel-term-f64", |[a, b]: [f64; 2]| (a + b) + a);
    probes.fail("cancel-term", |[a, _]: [f32; 2]| a);
    probes.fail("cancel-difference", |[a, b]: [f32; 2]| (a + b) - a);
    probes.fail("reorder-sum", |[a, b, c]: [f32; 3]| (a + b) - c);
    probes.fail("merge-constants", |[a]: [f32; 1]| a + 0.1);
    probes.fail("error-of-sum", |[a, b]: [f32; 2]| a + b);
    probes.fail("error-of-sum-barrier-f64", |[a, b, _]: [f64; 3]| -(a - ((a + b) - b)));
    probes.fail("contract", |[a, b, c]: [f32; 3]| a * b - c);
    probes.fail("factor-out", |[a, b, c]: [f32; 3]| a * (b - c));
    probes.fail("factor-out-f64", |[a, b, c]: [f64; 3]| b * (a + c));
    probes.fail("square-of-root", |[a]: [f32; 1]| a * a);
    probes.fail("multiply-by-zero", |[a]: [f32; 1]| a);
    probes.fail("add-zero", |[a]: [f32; 1]| -a);
    probes.fail("negate-difference", |[a, b]: [f32; 2]| a - b);
}

fn numbers(probes: &mut Probes) {
    let off = |number: f32, units: i32| f32::from_bits((number.to_bits() as i32 + units) as u32);
    probes.fail("sum", |[a, b]: [f32; 2]| (a + b).next_up().next_up());
    probes.fail("product-f64", |[a, b]: [f64; 2]| f64::from((a * b) as f32));
    probes.fail("divide", move |[a, b]: [f32; 2]| off(a / b, 4));
    probes.fail("divide-f64", |[a, b]: [f64; 2]| (a / b).next_up());
    probes.fail("root", move |[a]: [f32; 1]| off(a.sqrt(), 12));
    probes.fail("root-f64", |[a]: [f64; 1]| f64::from((a as f32).sqrt()));
    probes.fail("sin-f64", |[a]: [f64; 1]| f64::from((a as f32).sin()));
    probes.fail("exp-f64", |[_]: [f64; 1]| 0.0_f64);
    probes.fail("u32-to-f32", |[a]: [u32; 1]| a as i32 as f32);
    probes.fail("f32-to-u32", |[a]: [f32; 1]| a.round() as u32);
    probes.fail("f64-to-f32", |[a]: [f64; 1]| (a as f32).next_up().next_up());
    probes.fail("bits-of-f32", |[a]: [f32; 1]| a.to_bits() & 0x7fff_ffff);
    probes.fail("compare", |[a, b]: [f32; 2]| u32::from(a < b));
    probes.fail("compare-nan", |[_, _]: [f32; 2]| 64_u32);
    probes.fail("select", |[a, b, c]: [f32; 3]| a + f32::from(u8::from(c < 0.0)) * (b - a));
    probes.fail("subnormal-copy", |[a]: [f32; 1]| if a.is_subnormal() { 0.0 } else { a });
    probes.fail("subnormal-sum", |[a, b]: [f32; 2]| a - b);
}
