//! Records the calls of a composition's functions, so that each result can be compared with that of another program.
//!
//! Each function with a result gets another name, and a wrapper takes its place. The wrapper calls the function and
//! writes one record into a buffer of its own: the function's index, the depth of the call (1 for a call outside of
//! other recorded calls), the arguments and the result. A record is written when the call returns, so the calls inside
//! a function come before it. Lines keep their numbers.

use std::ops::Range;

use naga::{Function, Handle, Module, ScalarKind, Type, TypeInner};

use crate::limits::tokens;
use crate::validate::bindings;
use crate::{Composition, Error};

/// The name of a result in a wrapper.
const RESULT: &str = "call_trace_result";
/// Largest number of numbers in the arguments or in the result of a recorded function.
const MOST_NUMBERS: usize = 64;

/// A composition that records its calls, and the functions that it records.
#[derive(Clone, Debug)]
pub struct CallTrace {
    /// The composition with the wrappers at its end.
    pub composition: Composition,
    /// Number of lines that are not those of the trace.
    pub own_lines: usize,
    /// The recorded functions. A record begins with an index in this list.
    pub functions: Vec<Recorded>,
    /// The number of the buffer with the records in group 0. It is an array of `real`. Its first number is the index of
    /// the number after the last record, and the first record is at index 1. It must be zero before a run. Records for
    /// which there is no room are left out. Only one invocation may call functions.
    pub binding: u32,
}

/// A function whose calls are recorded.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Recorded {
    /// The name of the function.
    pub name: String,
    /// The first and the last line of the function, in the composition.
    pub lines: [usize; 2],
    /// Names of the parameters.
    parameters: Vec<String>,
    /// The numbers in the arguments. Integers and truth values are numbers too.
    pub arguments: Vec<Number>,
    /// The numbers in the result.
    pub results: Vec<Number>,
}

impl Composition {
    /// Returns this composition with a record of all calls of functions. Functions whose arguments or results are
    /// pointers or arrays, or have more than 64 numbers, are not recorded, nor are those without a result.
    ///
    /// # Errors
    /// The errors of [`Composition::validate`], also if the text already has names that begin with `call_trace`.
    pub fn with_call_trace(&self) -> Result<CallTrace, Error> {
        let module = self.validate()?.module;
        let (mut functions, mut wrappers, mut renamed) = (Vec::new(), String::new(), Vec::new());
        for (handle, function) in module.functions.iter() {
            let range = module.functions.get_span(handle).to_range();
            if let Some(declaration) = range.and_then(|range| Declaration::find(self.source(), &range))
                && let Some(recorded) = Recorded::new(&module, function, self.source(), &declaration)
            {
                let signature = self.source()[declaration.start..declaration.body].trim_end();
                wrappers.push_str(&recorded.wrapper(signature, functions.len()));
                renamed.push(declaration.after_name);
                functions.push(recorded);
            }
        }
        // From the last place to the first, so that the places stay valid.
        renamed.sort_unstable();
        let mut source = self.source().to_owned();
        renamed.iter().rev().for_each(|place| source.insert_str(*place, "_called"));
        let binding = bindings(&module).map(|binding| binding.number + 1).max().unwrap_or(0);
        let composition = self.changed(source, &(buffer(binding) + &wrappers));
        composition.validate()?;
        Ok(CallTrace { composition, own_lines: self.source().lines().count(), functions, binding })
    }
}

/// Returns the buffer with the records, and the state of the trace.
fn buffer(binding: u32) -> String {
    format!(
        "
@group(0) @binding({binding}) var<storage, read_write> call_trace: array<real>;
var<private> call_trace_next: u32 = 1u;
var<private> call_trace_depth: u32;
"
    )
}

impl Recorded {
    /// Returns the description of `function`, or `None` if its calls are not recorded.
    fn new(module: &Module, function: &Function, source: &str, declaration: &Declaration) -> Option<Self> {
        let (mut arguments, mut results, mut parameters) = (Vec::new(), Vec::new(), Vec::new());
        for argument in &function.arguments {
            let name = argument.name.clone()?;
            numbers(module, argument.ty, &name, &mut arguments)?;
            parameters.push(name);
        }
        numbers(module, function.result.as_ref()?.ty, RESULT, &mut results)?;
        let line = |place: usize| source[..place].matches('\n').count() + 1;
        let lines = [line(declaration.start), line(declaration.end)];
        Some(Self { name: function.name.clone()?, lines, parameters, arguments, results })
    }

    /// Returns the text of the wrapper with this signature. `index` is that of the function in the list. A record for
    /// which there is no room counts too, so that no later record stands in its place.
    fn wrapper(&self, signature: &str, index: usize) -> String {
        let Self { name, parameters, arguments, results, .. } = self;
        let head = [index.to_string(), "call_trace_depth".to_owned()].map(|number| format!("real({number})"));
        let values: Vec<_> =
            head.into_iter().chain(arguments.iter().chain(results).map(|number| number.value.clone())).collect();
        let write = |(at, value): (usize, &String)| format!("        call_trace[call_trace_next + {at}u] = {value};\n");
        let writes: String = values.iter().enumerate().map(write).collect();
        let (parameters, count) = (parameters.join(", "), values.len());
        format!(
            "
{signature} {{
    call_trace_depth++;
    let {RESULT} = {name}_called({parameters});
    let call_trace_end = call_trace_next + {count}u;
    if call_trace_end <= arrayLength(&call_trace) {{
{writes}        call_trace[0] = real(call_trace_end);
    }}
    call_trace_next = call_trace_end;
    call_trace_depth--;
    return {RESULT};
}}
"
        )
    }
}

/// A number of an argument or of a result.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Number {
    /// The name of the number, such as `ray.origin.x`. The numbers of a result have names that begin with
    /// `call_trace_result`.
    pub name: String,
    /// The expression that gives the number as a `real`.
    value: String,
}

impl Number {
    /// Returns the name for users, in which a result is called `result`.
    #[must_use]
    pub fn shown(&self) -> String {
        self.name.replacen(RESULT, "result", 1)
    }
}

/// Appends the numbers of a value of the type `ty`, which `path` names. Returns `None` if the type is not one of
/// numbers, truth values, vectors and structures, or if there are too many numbers.
fn numbers(module: &Module, ty: Handle<Type>, path: &str, list: &mut Vec<Number>) -> Option<()> {
    let mut push = |kind: ScalarKind, name: String| {
        let value = match kind {
            ScalarKind::Bool => format!("select(real(0), real(1), {name})"),
            ScalarKind::Float => name.clone(),
            _ => format!("real({name})"),
        };
        list.push(Number { name, value });
    };
    match &module.types[ty].inner {
        TypeInner::Scalar(scalar) => push(scalar.kind, path.to_owned()),
        TypeInner::Vector { size, scalar } => {
            let components = ["x", "y", "z", "w"].iter().take(*size as usize);
            components.for_each(|component| push(scalar.kind, format!("{path}.{component}")));
        }
        TypeInner::Struct { members, .. } => {
            for member in members {
                numbers(module, member.ty, &format!("{path}.{}", member.name.as_deref()?), list)?;
            }
        }
        _ => return None,
    }
    (list.len() <= MOST_NUMBERS).then_some(())
}

/// The places of a function's declaration in a text.
struct Declaration {
    /// The place of the word `fn`.
    start: usize,
    /// The place after the name.
    after_name: usize,
    /// The place of the bracket before the first statement.
    body: usize,
    /// The place of the bracket after the last statement.
    end: usize,
}

impl Declaration {
    /// Returns the places of the declaration that `range` covers, with its attributes.
    fn find(source: &str, range: &Range<usize>) -> Option<Self> {
        let mut tokens = tokens(&source.as_bytes()[range.clone()]).map(|(offset, token)| (range.start + offset, token));
        let start = tokens.find(|(_, token)| *token == b"fn")?.0;
        let (at_name, name) = tokens.next()?;
        let body = tokens.find(|(_, token)| *token == b"{")?.0;
        Some(Self { start, after_name: at_name + name.len(), body, end: tokens.last()?.0 })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Library, Precision};

    #[test]
    fn every_function_with_a_result_is_recorded_in_both_precisions() {
        for root in ["kernels/image", "kernels/steps", "kernels/samples", "kernels/cylinder"] {
            for precision in Precision::ALL {
                let composition = Library::standard().compose(root, precision).expect("it exists");
                let trace = composition.with_call_trace().expect("it is valid");
                let module = composition.validate().expect("it is valid").module;
                let with_result = module.functions.iter().filter(|(_, function)| function.result.is_some()).count();
                assert_eq!(trace.functions.len(), with_result, "{root}");
            }
        }
    }

    #[test]
    fn a_record_names_its_numbers_and_lines() {
        let composition = Library::standard().compose("kernels/sphere", Precision::F64).expect("it exists");
        let CallTrace { composition: traced, functions, binding, .. } =
            composition.with_call_trace().expect("it is valid");
        assert_eq!(binding, 2, "the kernel has two buffers");
        let recorded = functions.iter().find(|function| function.name == "ray_at").expect("it is called");
        let names = |numbers: &[Number]| numbers.iter().map(|number| number.name.clone()).collect::<Vec<_>>().join(" ");
        assert_eq!(
            names(&recorded.arguments),
            "ray.origin.x ray.origin.y ray.origin.z ray.direction.x ray.direction.y ray.direction.z lambda"
        );
        assert_eq!(names(&recorded.results), "call_trace_result.x call_trace_result.y call_trace_result.z");
        let lines: Vec<_> = composition.source().lines().collect();
        let [first, last] = recorded.lines;
        assert!(lines[first - 1].starts_with("fn ray_at(") && lines[last - 1] == "}" && last == first + 2);
        // All lines have the same origins as before.
        assert_eq!(traced.origin(first), composition.origin(first));
        assert!(traced.source().lines().nth(first - 1).is_some_and(|line| line.starts_with("fn ray_at_called(")));
    }

    #[test]
    fn comments_and_names_that_only_contain_the_name_are_no_declarations() {
        let source = "// fn f(\n/* fn f( */ fn ff(x: u32) -> u32 { return x; }\nfn f( // no { here\n x: u32) -> u32 { \
        if x > 0u { return ff(x); } return 1u; }\n@compute @workgroup_size(1) fn main() { _ = f(1u); }\n";
        let composition = Composition::of_file("my.wgsl", format!("alias real = f32;\n{source}"), Precision::F32);
        let trace = composition.with_call_trace().expect("it is valid");
        let places: Vec<_> = trace.functions.iter().map(|function| (function.name.as_str(), function.lines)).collect();
        assert_eq!(places, [("ff", [3, 3]), ("f", [4, 5])]);
    }

    #[test]
    fn pointers_are_not_recorded() {
        let source = "alias real = f32;\nfn add(p: ptr<function, u32>) -> u32 { *p += 1u; return *p; }\n\
        @compute @workgroup_size(1) fn main() { var x = 1u; _ = add(&x); }\n";
        let trace = Composition::of_file("my.wgsl", source.to_owned(), Precision::F32).with_call_trace();
        assert_eq!(trace.map(|trace| trace.functions.len()), Ok(0));
    }
}
