//! What can go wrong between a shader and its numbers, and what to do about it.

use std::path::PathBuf;

/// Why there are no numbers.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// No adapter is the one to use.
    #[error(
        "no GPU adapter {wanted}{found}; on Debian: apt-get install mesa-vulkan-drivers (gives lavapipe, the default), \
         or set WGPU_ADAPTER_NAME to part of another adapter's name and WGPU_BACKEND to its interface, as vulkan"
    )]
    NoAdapter {
        /// What was looked for.
        wanted: String,
        /// What was there instead.
        found: String,
    },
    /// The adapter has no 64-bit numbers in shaders.
    #[error("{adapter} has no f64 in shaders (SHADER_F64); unset WGPU_ADAPTER_NAME to use lavapipe, which has it")]
    NoF64 {
        /// Its name.
        adapter: String,
    },
    /// The adapter gives no device.
    #[error("{adapter} gives no device: {cause}; unset WGPU_ADAPTER_NAME to use lavapipe")]
    NoDevice {
        /// Its name.
        adapter: String,
        /// The driver's words.
        cause: String,
    },
    /// The device is gone.
    #[error("the device was lost: {cause}; run again, and with WGPU_ADAPTER_NAME=llvmpipe if it happens again")]
    DeviceLost {
        /// The driver's words.
        cause: String,
    },
    /// The device has no memory left.
    #[error("the device is out of memory: {cause}; close other programs or render a smaller picture")]
    OutOfMemory {
        /// The driver's words.
        cause: String,
    },
    /// A buffer would be larger than the device's limit.
    #[error("{what} takes {bytes} bytes and the device binds at most {limit}; use fewer objects or a smaller depth")]
    TooLarge {
        /// The buffer's content.
        what: &'static str,
        /// Its size.
        bytes: u64,
        /// The limit.
        limit: u64,
    },
    /// One bounce of a ray would take more iterations than drivers allow.
    #[error("{objects} objects to a depth of {depth} are more than one run can loop over ({limit} in all); use fewer")]
    TooManyIterations {
        /// Spheres and cylinders.
        objects: u64,
        /// Most surfaces that a ray may meet.
        depth: u64,
        /// Most iterations of all loops of an invocation.
        limit: u64,
    },
    /// The work did not end in time.
    #[error(
        "the device did not finish a run within {seconds} seconds, which takes some seconds at most; has a loop no end?"
    )]
    Timeout {
        /// How long it was waited for.
        seconds: u64,
    },
    /// The driver refuses what passed naga.
    #[error("the driver refuses: {cause}")]
    Refused {
        /// wgpu's words.
        cause: String,
    },
    /// A kernel left places of its output as they were.
    #[error("the kernel [{kernel}] did not write {count} of the numbers it should have written")]
    Unwritten {
        /// Its name.
        kernel: String,
        /// How many.
        count: usize,
    },
    /// The driver rewrites formulas in spite of the barrier.
    #[error("{adapter} breaks the barrier against rewriting: {count} of {of} sums differ; its bits prove nothing")]
    BarrierBroken {
        /// Its name.
        adapter: String,
        /// Sums that differ.
        count: usize,
        /// Sums compared.
        of: usize,
    },
    /// What was asked for on the command line does not fit the shader or the picture.
    #[error("{message}")]
    Request {
        /// What, in words.
        message: String,
    },
    /// The shader is wrong.
    #[error(transparent)]
    Shader(#[from] shaders::Error),
    /// The configuration, the scene or the picture is wrong, or a file cannot be written.
    #[error("{}", String::from_utf8_lossy(&.0.message_for_terminal()))]
    Scene(#[from] cpu::Error),
    /// A file cannot be read or written.
    #[error("{}: {cause}", cpu::internals::input::text::escape(path.as_os_str().as_encoded_bytes()))]
    File {
        /// Its name.
        path: PathBuf,
        /// The system's words.
        cause: std::io::Error,
    },
}
