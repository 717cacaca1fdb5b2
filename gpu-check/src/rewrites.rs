//! Finds out how a driver rewrites formulas.
//!
//! Vulkan allows a driver to rewrite floating-point formulas by the laws of real numbers, unless the shader forbids it.
//! naga's shaders do not forbid it. [`observe`] finds out which laws a driver applies. [`require_barrier`] is a
//! self-test: if it passes, formulas can rely on the barrier of `exact.wgsl`.

use std::fmt;

use cpu::internals::sampling::uniform::Uniform;
use shaders::Library;

use crate::pipeline::{Content, Pipeline};
use crate::{Error, Formulas, Gpu, check, kernels, special};

/// Number of random cases. It is large enough that every rewriting changes at least one result.
const CASES: usize = 4096;
/// Number of inputs of a case, and of numbers of its result.
const NUMBERS: usize = 5;

/// The laws of real numbers that a driver applies to floating-point numbers, although they are not exact there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rewrites {
    /// Whether the driver replaces `(x + y) - x` by `y`.
    pub cancels_terms: bool,
    /// Whether the driver replaces `x y + x z` by `x (y + z)`.
    pub factors_out: bool,
    /// Whether the driver replaces `sqrt(x) sqrt(x)` by `x`.
    pub squares_roots: bool,
    /// Whether the driver replaces `x + 0` by `x`, although `-0 + 0` is `0`.
    pub drops_zeros: bool,
    /// Whether the driver replaces `x != x` by false, although it is true for NaN.
    pub forgets_nan: bool,
}

/// Returns the rewritings that the driver applies in the precision of `T`.
///
/// # Errors
/// The errors of [`Pipeline::new`] and [`Pipeline::run`].
pub fn observe<T: Formulas>(gpu: &Gpu, library: &Library) -> Result<Rewrites, Error> {
    let pipeline = Pipeline::new(gpu, &library.compose("kernels/rewrites", T::PRECISION)?, None)?;
    let mut draws = Uniform::new(7);
    let mut case = || {
        let [x, y, z] = [(); 3].map(|()| T::of(special::of_any_size(&mut draws, -3.0, 3.0).abs()));
        [x, y, z, T::of(-0.0), T::of(f64::NAN)]
    };
    let cases: Vec<T> = (0..CASES).flat_map(|_| case()).collect();
    let size = size_of_val(&cases[..]) as u64;
    let contents = [Content::Input(bytemuck::cast_slice(&cases)), Content::Output(size)];
    let run = pipeline.run(gpu, &contents, CASES as u64)?;
    let results: Vec<T> = bytemuck::pod_collect_to_vec(&run.outputs.concat());
    let mut differ = [false; NUMBERS];
    for (case, result) in cases.chunks(NUMBERS).zip(results.chunks(NUMBERS)) {
        let (x, y, z, zero) = (case[0], case[1], case[2], T::of(0.0));
        let as_written = [(x + y) - x, x * y + x * z, x.sqrt() * x.sqrt(), case[3] + zero, T::of(1.0)];
        for (place, expected) in as_written.into_iter().enumerate() {
            differ[place] |= !expected.same(result[place]);
        }
    }
    let [cancels_terms, factors_out, squares_roots, drops_zeros, forgets_nan] = differ;
    Ok(Rewrites { cancels_terms, factors_out, squares_roots, drops_zeros, forgets_nan })
}

/// Checks that the rounding errors of sums with the barrier have the bits that Rust computes.
///
/// # Errors
/// [`Error::BarrierBroken`] if a sum or an error differs, or the errors of [`Pipeline::new`] and [`Pipeline::run`].
pub fn require_barrier<T: Formulas>(gpu: &Gpu, library: &Library) -> Result<(), Error> {
    let kernel = kernels::KERNELS.iter().find(|kernel| kernel.module == "kernels/barrier").expect("it is listed");
    let pipeline = check::compile::<T>(gpu, library, kernel)?;
    let tally = check::check::<T>(gpu, &pipeline, kernel, &kernel.random_cases(CASES, 7))?;
    match tally.differing {
        0 => Ok(()),
        count => Err(Error::BarrierBroken { adapter: gpu.name().to_owned(), count, of: tally.cases }),
    }
}

impl fmt::Display for Rewrites {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let word = |rewritten| if rewritten { "rewritten" } else { "kept" };
        let Self { cancels_terms, factors_out, squares_roots, drops_zeros, forgets_nan } = *self;
        write!(f, "(x + y) - x is {}, x y + x z is {}, ", word(cancels_terms), word(factors_out))?;
        write!(f, "sqrt(x) sqrt(x) is {}, x + 0 is {}, ", word(squares_roots), word(drops_zeros))?;
        write!(f, "x != x is {}", word(forgets_nan))
    }
}
