//! Finds the first function in which WGSL leaves Rust.
//!
//! One pixel of a picture runs once with a trace of all its calls ([`shaders::call_trace`]).
//! Rust repeats every call with the arguments that WGSL had ([`twins`]). A call comes after the calls inside it, so the
//! first call with another result is the innermost one: its own statements are wrong, or those of a function inside it
//! that has no twin. If every call has Rust's result, the difference is in what stands around the calls.

mod arguments;
pub mod calls;
pub mod report;
pub mod twins;

use std::collections::BTreeSet;

use shaders::{CallTrace, Features, Library};

use crate::reader::Reader;
use crate::{Error, Float, Gpu, Picture};
use calls::{Call, Tracer};

/// The first difference of a pixel.
#[derive(Clone, Debug, PartialEq)]
pub enum FirstDifference<T> {
    /// A call with another result than in Rust.
    Call {
        /// The name of the function.
        function: String,
        /// Names of the functions inside it that have no twin. One of them may be the wrong one.
        inside: Vec<String>,
        /// Names and values of the arguments.
        arguments: Vec<(String, T)>,
        /// The first number of the result that differs.
        number: Unequal<T>,
    },
    /// Every call with a twin has the result of Rust, but other arguments are passed, there are more or fewer calls, or
    /// what is stored differs.
    Rest {
        /// Names of the functions without a twin that are called outside of others. One of them may be the wrong one.
        without_twin: Vec<String>,
    },
}

/// A first difference, and the trace of the composition in which it is.
pub type Located<T> = (CallTrace, FirstDifference<T>);

/// A number by Rust and by WGSL.
#[derive(Clone, Debug, PartialEq)]
pub struct Unequal<T> {
    /// The name of the number.
    pub name: String,
    /// Rust's value.
    pub cpu: T,
    /// The value in WGSL.
    pub wgsl: T,
}

/// Returns the first difference of the pixel at `index` in deterministic mode, or `None` if there is none. `own` has
/// the names and values of constants that a replaced module declares.
///
/// # Errors
/// [`Error::TooManyIterations`] if the path needs more than one run, or the errors of [`crate::Pipeline::run`].
pub fn of_pixel<T: Float>(
    gpu: &Gpu,
    library: &Library,
    (features, own): (&Features, &[(&str, f64)]),
    picture: &Picture<T>,
    index: usize,
) -> Result<Option<Located<T>>, Error> {
    let constants = [&features.constants()[..], own].concat();
    let tracer = Tracer::new(gpu, library, "kernels/image", &constants)?;
    let picture = Picture { max_depth: features.max_depth, ..picture.clone() };
    let (calls, color) = tracer.pixel(&picture, index)?;
    let expected = picture.color(index).to_array();
    let is_same = expected.iter().zip(&color).all(|(one, other)| one.same(*other));
    let found = first_wrong_call(&picture, &tracer, &calls).or_else(|| (!is_same).then(|| rest(&tracer, &calls)));
    Ok(found.map(|found| (tracer.into_trace(), found)))
}

/// Returns the names of those functions of `calls` that have no twin, each once.
fn without_twin<'a, T: Float>(tracer: &Tracer<'_, T>, calls: impl Iterator<Item = &'a Call<T>>) -> Vec<String> {
    let functions: BTreeSet<_> = calls.map(|call| call.function).filter(|at| tracer.twin(*at).is_none()).collect();
    functions.into_iter().map(|at| tracer.trace().functions[at].name.clone()).collect()
}

/// Returns the difference of calls among which none is wrong.
fn rest<T: Float>(tracer: &Tracer<'_, T>, calls: &[Call<T>]) -> FirstDifference<T> {
    FirstDifference::Rest { without_twin: without_twin(tracer, calls.iter().filter(|call| call.depth == 1)) }
}

/// Returns the first call whose result is not that of its twin.
fn first_wrong_call<T: Float>(
    picture: &Picture<T>,
    tracer: &Tracer<'_, T>,
    calls: &[Call<T>],
) -> Option<FirstDifference<T>> {
    calls.iter().enumerate().find_map(|(at, call)| {
        let function = &tracer.trace().functions[call.function];
        let expected = tracer.twin(call.function)?(Some(picture), Reader(&call.arguments))?;
        let place = expected
            .iter()
            .zip(&call.results)
            .position(|(expected, result)| expected.is_some_and(|expected| !expected.same(*result)))?;
        let inside = without_twin(tracer, calls[..at].iter().rev().take_while(|inner| inner.depth > call.depth));
        let names = function.arguments.iter().map(|number| number.name.clone());
        Some(FirstDifference::Call {
            function: function.name.clone(),
            inside,
            arguments: names.zip(call.arguments.iter().copied()).collect(),
            number: Unequal { name: function.results[place].shown(), cpu: expected[place]?, wgsl: call.results[place] },
        })
    })
}
