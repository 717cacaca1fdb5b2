//! Why a shader gives no results, and what the user can do about it.

use std::path::PathBuf;

/// Why a shader gives no results.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// No adapter has the name that is asked for.
    #[error(
        "no GPU adapter {wanted}{found}; on Debian: apt-get install mesa-vulkan-drivers (gives lavapipe, the default), \
         or set WGPU_ADAPTER_NAME to part of another adapter's name and WGPU_BACKEND to its interface, as vulkan"
    )]
    NoAdapter {
        /// The adapter that is asked for, in words.
        wanted: String,
        /// The adapters that there are, in words.
        found: String,
    },
    /// The adapter has no 64-bit numbers in shaders.
    #[error("{adapter} has no f64 in shaders (SHADER_F64); unset WGPU_ADAPTER_NAME to use lavapipe, which has it")]
    NoF64 {
        /// The adapter's name.
        adapter: String,
    },
    /// The adapter gives no device.
    #[error("{adapter} gives no device: {cause}; unset WGPU_ADAPTER_NAME to use lavapipe")]
    NoDevice {
        /// The adapter's name.
        adapter: String,
        /// The driver's message.
        cause: String,
    },
    /// The device is gone.
    #[error("the device was lost: {cause}; run again, and with WGPU_ADAPTER_NAME=llvmpipe if it happens again")]
    DeviceLost {
        /// The driver's message.
        cause: String,
    },
    /// The device has no memory left.
    #[error("the device is out of memory: {cause}; close other programs or render a smaller picture")]
    OutOfMemory {
        /// The driver's message.
        cause: String,
    },
    /// A buffer would be larger than the device's limit.
    #[error("{what} takes {bytes} bytes and the device binds at most {limit}; use fewer objects or a smaller depth")]
    TooLarge {
        /// The buffer's content.
        what: &'static str,
        /// Size of the buffer in bytes.
        bytes: u64,
        /// Most bytes of a binding.
        limit: u64,
    },
    /// One bounce of a ray would take more iterations than drivers allow.
    #[error("{objects} objects to a depth of {depth} are more than one run can loop over ({limit} in all); use fewer")]
    TooManyIterations {
        /// Number of spheres and cylinders.
        objects: u64,
        /// Most surfaces that a path may hit.
        depth: u64,
        /// Most iterations of all loops of an invocation.
        limit: u64,
    },
    /// The work did not end in time.
    #[error(
        "the device did not finish a run within {seconds} seconds, which takes some seconds at most; has a loop no end?"
    )]
    Timeout {
        /// How long the program waited.
        seconds: u64,
    },
    /// The driver refuses a shader that naga accepts.
    #[error("the driver refuses: {cause}")]
    Refused {
        /// wgpu's message.
        cause: String,
    },
    /// A kernel did not write a part of its output.
    #[error("the kernel [{kernel}] did not write {count} of the numbers it should have written")]
    Unwritten {
        /// The kernel's module.
        kernel: String,
        /// How many numbers it did not write.
        count: usize,
    },
    /// The driver rewrites formulas in spite of the barrier.
    #[error("{adapter} breaks the barrier against rewriting: {count} of {of} sums differ; its bits prove nothing")]
    BarrierBroken {
        /// The adapter's name.
        adapter: String,
        /// Sums that differ.
        count: usize,
        /// Sums compared.
        of: usize,
    },
    /// An option of the command line does not fit the shader or the picture.
    #[error("{message}")]
    Request {
        /// Which option, and why.
        message: String,
    },
    /// The shader is wrong.
    #[error(transparent)]
    Shader(#[from] shaders::Error),
    /// A file cannot be written.
    #[error("{}", String::from_utf8_lossy(&.0.message(|text| cpu::internals::input::text::escape(text).into_bytes())))]
    Output(#[from] output::Error),
    /// The configuration, the scene or the picture is wrong.
    #[error("{}", String::from_utf8_lossy(&.0.message_for_terminal()))]
    Scene(#[from] cpu::Error),
    /// A file cannot be read or written.
    #[error("{}: {cause}", cpu::internals::input::text::escape(path.as_os_str().as_encoded_bytes()))]
    File {
        /// The file's name.
        path: PathBuf,
        /// The error of the system.
        cause: std::io::Error,
    },
}
