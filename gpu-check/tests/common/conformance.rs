//! Small programs in WGSL, called probes, that show how a driver calculates: the operations and rewritings on which the
//! exactness of the port depends.
//!
//! Each [`Probe`] lists the results that IEEE 754 and the WGSL specification allow, computed in Rust for each input. A
//! driver's results are as written, or follow one named allowed rewriting, or are within the allowed error. All other
//! results are a failure. [`table`] has the rows.

mod inputs;
mod table;

use std::fmt::Write;

use gpu_check::pipeline::Content;
use gpu_check::{Error, Float, Gpu, Pipeline};
use shaders::{Composition, Precision};

pub use table::all;

/// A number of Rust with the type of a number of WGSL.
pub trait Value: bytemuck::Pod {
    /// The type in WGSL.
    const NAME: &str;
    /// Whether both have the same bits, or both are NaN.
    fn is(self, other: Self) -> bool;
}

/// A floating-point type over which probes are generic.
pub trait Number: Float + Value {
    /// The smallest positive normal number.
    const TINY: Self;
    /// Returns `self * factor + term` with one rounding.
    fn fused(self, factor: Self, term: Self) -> Self;
}

macro_rules! number {
    ($type:ident) => {
        impl Value for $type {
            const NAME: &str = stringify!($type);
            fn is(self, other: Self) -> bool {
                self.same(other)
            }
        }
        impl Number for $type {
            const TINY: Self = Self::MIN_POSITIVE;
            fn fused(self, factor: Self, term: Self) -> Self {
                self.mul_add(factor, term)
            }
        }
    };
}

number!(f32);
number!(f64);

impl Value for u32 {
    const NAME: &str = "u32";
    fn is(self, other: Self) -> bool {
        self == other
    }
}

/// A program in WGSL that computes one number from up to three inputs, for each of its cases.
pub struct Probe {
    /// The name, unique among all probes.
    pub name: String,
    /// The expression whose value is the result.
    pub result: &'static str,
    /// The text of the program.
    pub text: String,
    /// The numbers of all cases, as they lie in a buffer.
    pub input: Vec<u8>,
    /// The readings of the program: what results that follow one are called, and such results. The first is "as
    /// written".
    pub readings: Vec<(&'static str, Vec<u8>)>,
    /// Returns the verdict on results.
    pub judge: Judge,
}

/// Returns the verdict on results, such as "as written".
pub type Judge = Box<dyn Fn(&[u8]) -> String>;

impl Probe {
    /// Returns the program in the form that naga validates.
    pub fn composition(&self) -> Composition {
        let precision = if self.needs_f64() { Precision::F64 } else { Precision::F32 };
        Composition::of_text(self.text.clone(), precision)
    }

    /// Runs the program on a device, and returns the verdict.
    pub fn verdict(&self, gpu: &Gpu) -> String {
        if self.needs_f64() && !gpu.has_f64() {
            return "not available (f64)".to_owned();
        }
        match self.run(gpu) {
            Ok(results) => (self.judge)(&results),
            Err(Error::Unwritten { count, .. }) => format!("failure: {count} not written"),
            Err(error) => format!("failure: {}", error.to_string().lines().next().unwrap_or_default()),
        }
    }

    fn run(&self, gpu: &Gpu) -> Result<Vec<u8>, Error> {
        let pipeline = Pipeline::new(gpu, &self.composition(), &[])?;
        let bytes = self.readings[0].1.len();
        // A result has 4 bytes at least, and the program ends further invocations.
        let contents = [Content::Input(&self.input), Content::Output(bytes as u64)];
        Ok(pipeline.run(gpu, &contents, bytes as u64 / 4)?.outputs.concat())
    }

    fn needs_f64(&self) -> bool {
        self.text.contains("f64")
    }
}

/// A reading: its name, and the results that it allows for a case.
type Reading<I, O, const N: usize> = (&'static str, Box<dyn Fn([I; N]) -> Vec<O>>);

/// A probe that is being built: `N` inputs of type `I`, called `a`, `b` and `c`, and a result of type `O`.
pub struct Draft<I, O, const N: usize> {
    name: &'static str,
    result: &'static str,
    statements: &'static str,
    cases: Vec<[I; N]>,
    readings: Vec<Reading<I, O, N>>,
}

impl<I: Value, O: Value, const N: usize> Draft<I, O, N> {
    /// Starts a probe of the expression `result`, which the function `as_written` calculates as it is written.
    pub fn new(
        name: &'static str,
        result: &'static str,
        cases: impl IntoIterator<Item = [I; N]>,
        as_written: impl Fn([I; N]) -> O + 'static,
    ) -> Self {
        let cases = cases.into_iter().collect();
        Self { name, result, statements: "", cases, readings: Vec::new() }.or("as written", as_written)
    }

    /// Sets the statements before the result.
    pub fn after(self, statements: &'static str) -> Self {
        Self { statements, ..self }
    }

    /// Allows what `formula` calculates.
    pub fn or(self, name: &'static str, formula: impl Fn([I; N]) -> O + 'static) -> Self {
        self.among(name, move |case| vec![formula(case)])
    }

    /// Allows several results for a case.
    pub fn among(mut self, name: &'static str, allowed: impl Fn([I; N]) -> Vec<O> + 'static) -> Self {
        self.readings.push((name, Box::new(allowed)));
        self
    }

    /// Returns the probe. Probes that differ only in their floating-point type have `-f64` at the end of the name.
    pub fn done(self) -> Probe {
        let needs_f64 = [I::NAME, O::NAME].contains(&"f64") && !self.name.contains("f64");
        let name = format!("{}{}", self.name, if needs_f64 { "-f64" } else { "" });
        let text = text(I::NAME, O::NAME, N, self.statements, self.result);
        // If a case allows several results, the cases get all of them in turn, the last one first.
        let following = |(name, allowed): &Reading<I, O, N>| {
            let result = |(index, case): (usize, &[I; N])| {
                let numbers = allowed(*case);
                numbers[(numbers.len() - 1 + index) % numbers.len()]
            };
            let results: Vec<O> = self.cases.iter().enumerate().map(result).collect();
            (*name, bytemuck::cast_slice(&results).to_vec())
        };
        let readings = self.readings.iter().map(following).collect();
        let input = self.cases.iter().flat_map(|case| bytemuck::cast_slice::<I, u8>(case).to_vec()).collect();
        Probe { name, result: self.result, text, input, readings, judge: Box::new(move |bytes| self.judge(bytes)) }
    }

    /// Returns the verdict on results. One reading must explain the results of all cases: a driver compiles the program
    /// once, so it cannot rewrite one case and not another.
    fn judge(&self, bytes: &[u8]) -> String {
        let results: Vec<O> = bytemuck::pod_collect_to_vec(bytes);
        let (mut least, mut name) = (usize::MAX, "");
        for (own, allowed) in &self.readings {
            let is_wrong = |(case, result): &(&[I; N], &O)| !allowed(**case).iter().any(|number| number.is(**result));
            let wrong = self.cases.iter().zip(&results).filter(is_wrong).count();
            (least, name) = if wrong < least { (wrong, *own) } else { (least, name) };
        }
        if least == 0 { name.to_owned() } else { format!("failure: {least} of {} wrong", self.cases.len()) }
    }
}

/// Returns the text of a program with `count` inputs.
fn text(input: &str, output: &str, count: usize, statements: &str, result: &str) -> String {
    let mut text = format!(
        "@group(0) @binding(0) var<storage, read> input: array<{input}>;\n\
         @group(0) @binding(1) var<storage, read_write> output: array<{output}>;\n\
         @compute @workgroup_size(64)\n\
         fn probe(@builtin(global_invocation_id) id: vec3<u32>) {{\n    \
             if id.x >= arrayLength(&output) {{ return; }}\n"
    );
    for (index, name) in ["a", "b", "c"].iter().take(count).enumerate() {
        let place = match (count, index) {
            (1, _) => "id.x".to_owned(),
            (_, 0) => format!("{count}u * id.x"),
            _ => format!("{count}u * id.x + {index}u"),
        };
        let _ = writeln!(text, "    let {name} = input[{place}];");
    }
    text.extend(statements.lines().map(|line| format!("    {line}\n")));
    let _ = write!(text, "    output[id.x] = {result};\n}}\n");
    text
}
