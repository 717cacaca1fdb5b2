//! What all tests on a device share.

use gpu_check::Gpu;

/// The device, its driver and version printed; without one the test fails with the line that says what to install.
pub fn gpu() -> Gpu {
    let gpu = Gpu::open().unwrap_or_else(|error| panic!("{error}"));
    println!("{gpu}");
    gpu
}
