//! Finds out how accurate the f32 arithmetic of a device is.

use super::verdict::Verdict;
use super::{native, probes};
use crate::running::Accuracy;
use crate::{Error, Gpu};

/// The probes of what WGSL does not demand to be as IEEE 754 defines it.
const PROBES: [&str; 5] = ["divide", "root", "subnormal-sum", "subnormal-product", "subnormal-less"];

/// Returns the accuracy of the f32 arithmetic of a device: that of IEEE 754 if all its results for the probes are.
///
/// # Errors
/// The errors of [`native::run`].
pub fn accuracy(gpu: &Gpu) -> Result<Accuracy, Error> {
    for probe in probes::all().iter().filter(|probe| PROBES.contains(&probe.name.as_str())) {
        if Verdict::of(probe, &native::run(gpu, probe)?) != Verdict::AsWritten {
            return Ok(Accuracy::Wgsl);
        }
    }
    Ok(Accuracy::Ieee)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_probe_exists() {
        let all = probes::all();
        assert!(PROBES.iter().all(|name| all.iter().any(|probe| probe.name == *name)));
    }
}
