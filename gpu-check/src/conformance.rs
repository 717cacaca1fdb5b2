//! Small programs in WGSL, called probes, that show how a driver calculates.
//!
//! Each [`probe::Probe`] is a program of at most 20 lines with its inputs. It lists which results IEEE 754 and the WGSL
//! specification allow, computed in Rust for each input. The [`verdict`] on a driver is that its results are as
//! written, or follow one named allowed rewriting, or are within the allowed error. All other results are a failure.
//!
//! - [`value`] has the types of numbers, and [`ulp`] measures errors;
//! - [`reading`] is one allowed way to calculate a program, and [`draft`] builds probes;
//! - [`inputs`] and [`probes`] are the inputs and the list of all probes;
//! - [`native`] runs a probe through wgpu, and [`isolated`] runs all in a separate process;
//! - [`outcome`] is what a driver made of a probe;
//! - [`report`] writes verdicts as a table, and as text that can be sent to the authors of a driver;
//! - [`csv`] is the table that several machines fill;
//! - [`args`] is the command line of the program `conformance`.
//!
//! The numbers of sections are those of the WGSL specification, <https://www.w3.org/TR/WGSL/>.

pub mod args;
pub mod csv;
pub mod draft;
pub mod inputs;
pub mod isolated;
pub mod native;
pub mod outcome;
pub mod probe;
pub mod probes;
pub mod reading;
pub mod report;
pub mod ulp;
pub mod value;
pub mod verdict;

#[cfg(test)]
mod tests;
