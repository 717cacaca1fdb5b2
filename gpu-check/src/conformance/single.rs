//! Finds out how accurate the f32 arithmetic of a device is.

use super::probe::Probe;
use super::verdict::Verdict;
use super::{native, probes};
use crate::Gpu;
use crate::running::Accuracy;

/// The probes of what WGSL does not demand to be as IEEE 754 defines it.
const PROBES: [&str; 7] = ["sum", "product", "divide", "root", "subnormal-sum", "subnormal-product", "subnormal-less"];

/// Returns the accuracy of the f32 arithmetic of a device: that of IEEE 754 if all its results for the probes are.
#[must_use]
pub fn accuracy(gpu: &Gpu) -> Accuracy {
    let is_as_written = |probe: &Probe| Verdict::of(probe, &native::run(gpu, probe)) == Verdict::AsWritten;
    let all = probes::all();
    let mut chosen = all.iter().filter(|probe| PROBES.contains(&probe.name.as_str()));
    if chosen.all(is_as_written) { Accuracy::Ieee } else { Accuracy::Wgsl }
}
