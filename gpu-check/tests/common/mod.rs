//! Opens the device for all tests that need one.

use gpu_check::Gpu;

/// Opens the device, and prints its name, driver and version. If there is no device, the test fails with a message that
/// tells what to install.
pub fn gpu() -> Gpu {
    let gpu = Gpu::open().unwrap_or_else(|error| panic!("{error}"));
    println!("{gpu}");
    gpu
}
