//! A program in WGSL with its inputs and the readings that are allowed.

use std::fmt::Write;

use shaders::{Composition, Precision};

use super::reading::Reading;
use super::value::Type;

/// Largest number of lines of a probe's program.
pub const MAX_LINES: usize = 20;

/// Names of the inputs in the program.
pub const NAMES: [&str; 3] = ["a", "b", "c"];

/// A program in WGSL that computes one number from up to three inputs, for each of its cases.
#[derive(Debug)]
pub struct Probe {
    /// The name, unique among all probes.
    pub name: String,
    /// The topic in tables.
    pub group: &'static str,
    /// What IEEE 754 and WGSL say about the program.
    pub rule: &'static str,
    /// Type of the inputs.
    pub input: Type,
    /// Type of the result.
    pub output: Type,
    /// Statements before the result. Each line ends with a line end.
    pub statements: &'static str,
    /// The expression whose value is the result.
    pub result: &'static str,
    /// Whether an implementation may refuse the program, because it uses what no specification defines.
    pub may_be_refused: bool,
    /// The inputs.
    pub cases: Vec<Vec<f64>>,
    /// The reading of the program as written.
    pub as_written: Reading,
    /// The other allowed readings.
    pub others: Vec<Reading>,
}

impl Probe {
    /// Returns the text of the program.
    #[must_use]
    pub fn text(&self) -> String {
        let (input, output) = (self.input.name(), self.output.name());
        let mut text = format!(
            "@group(0) @binding(0) var<storage, read> input: array<{input}>;\n\
             @group(0) @binding(1) var<storage, read_write> output: array<{output}>;\n\
             @compute @workgroup_size(64)\n\
             fn probe(@builtin(global_invocation_id) id: vec3<u32>) {{\n    \
                 if id.x >= arrayLength(&output) {{ return; }}\n"
        );
        let count = self.cases.first().map_or(1, Vec::len);
        for (index, name) in NAMES.iter().take(count).enumerate() {
            let place = match (count, index) {
                (1, _) => "id.x".to_owned(),
                (_, 0) => format!("{count}u * id.x"),
                _ => format!("{count}u * id.x + {index}u"),
            };
            let _ = writeln!(text, "    let {name} = input[{place}];");
        }
        for line in self.statements.lines() {
            let _ = writeln!(text, "    {line}");
        }
        let _ = write!(text, "    output[id.x] = {};\n}}\n", self.result);
        text
    }

    /// Whether the program uses `f64`.
    #[must_use]
    pub fn needs_f64(&self) -> bool {
        self.input == Type::F64 || self.output == Type::F64
    }

    /// Returns the program in the form that naga validates.
    #[must_use]
    pub fn composition(&self) -> Composition {
        let precision = if self.needs_f64() { Precision::F64 } else { Precision::F32 };
        Composition::of_text(self.text(), precision).allow_transcendental_f64()
    }

    /// Returns the reading that explains most results, and the indices of the cases that it does not explain.
    #[must_use]
    pub fn nearest(&self, results: &[f64]) -> (&Reading, Vec<usize>) {
        let with_wrong = |reading| (reading, Reading::wrong(reading, &self.cases, results));
        let nearer =
            |one: (_, Vec<usize>), other: (_, Vec<usize>)| if other.1.len() < one.1.len() { other } else { one };
        self.others.iter().map(with_wrong).fold(with_wrong(&self.as_written), nearer)
    }

    /// Returns the bytes of the inputs, case after case.
    #[must_use]
    pub fn input_bytes(&self) -> Vec<u8> {
        self.input.to_bytes(self.cases.iter().flatten().copied())
    }

    /// Returns the number of bytes of the results.
    #[must_use]
    pub fn output_size(&self) -> usize {
        self.cases.len() * self.output.size()
    }
}
