//! Opens the device for all tests that need one.

#[allow(dead_code, reason = "not every test program prints the table")]
pub mod conformance;

use std::time::Duration;

use conformance::Probe;
use gpu_check::Gpu;

/// The probes of what WGSL does not demand to be as IEEE 754 defines it.
const F32_PROBES: [&str; 7] =
    ["sum", "product", "divide", "root", "subnormal-sum", "subnormal-product", "subnormal-less"];

/// How accurate the f32 operations of a device are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Accuracy {
    /// As IEEE 754 defines them: rounded correctly, with numbers below the normal ones.
    Ieee,
    /// As accurate as WGSL demands (section 15.7.4, Floating Point Accuracy).
    Wgsl,
}

/// Opens the device, and prints its name, driver and version. If there is no device, the test fails with a message that
/// tells what to install.
pub fn gpu() -> Gpu {
    let gpu = Gpu::open().unwrap_or_else(|error| panic!("{error}"));
    println!("{gpu}");
    // On a busy machine lavapipe takes minutes for what takes seconds on an idle one.
    gpu.with_patience(Duration::from_secs(3600))
}

/// Returns the accuracy of the device's f32 arithmetic, and prints it: that of IEEE 754 if the results of all probes
/// have it. Only with that of IEEE 754 can f32 have the bits of Rust.
#[allow(dead_code, reason = "not every test compares f32")]
pub fn accuracy(gpu: &Gpu) -> Accuracy {
    let is_as_written = |probe: &Probe| probe.verdict(gpu) == "as written";
    let all = conformance::all();
    let mut chosen = all.iter().filter(|probe| F32_PROBES.contains(&probe.name.as_str()));
    let accuracy = if chosen.all(is_as_written) { Accuracy::Ieee } else { Accuracy::Wgsl };
    println!("f32 has the accuracy of {accuracy:?}");
    // Else a fault of a probe would switch off the comparisons of f32 bits unseen.
    assert!(accuracy == Accuracy::Ieee || !gpu.is_lavapipe(), "lavapipe has the arithmetic of IEEE 754");
    accuracy
}
