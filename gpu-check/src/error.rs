//! The errors for which a shader gives no results. The messages tell what the user can do.

use std::path::PathBuf;

/// The reason why a shader gives no results.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// No adapter has the wanted name.
    #[error(
        "no GPU adapter {wanted}{found}; on Debian: apt-get install mesa-vulkan-drivers (gives lavapipe, the default), \
         or set WGPU_ADAPTER_NAME to part of another adapter's name and WGPU_BACKEND to its interface, as vulkan"
    )]
    NoAdapter {
        /// Text that describes the wanted adapter.
        wanted: String,
        /// Text that lists the existing adapters.
        found: String,
    },
    /// The adapter returns an error instead of a device.
    #[error("{adapter} gives no device: {cause}; unset WGPU_ADAPTER_NAME to use lavapipe")]
    NoDevice {
        /// The adapter's name.
        adapter: String,
        /// The driver's message.
        cause: String,
    },
    /// The device was lost, for example because the driver stopped it.
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
        /// Text that describes the content of the buffer.
        what: &'static str,
        /// Size of the buffer in bytes.
        bytes: u64,
        /// Largest number of bytes that the device can bind.
        limit: u64,
    },
    /// One bounce of a ray would take more iterations than drivers allow.
    #[error("{objects} objects to a depth of {depth} are more than one run can loop over ({limit} in all); use fewer")]
    TooManyIterations {
        /// Number of spheres and cylinders.
        objects: u64,
        /// The maximum depth: the number of rays that a sample may send, the camera ray included. If the last of them
        /// hits an object, the sample is black.
        depth: u64,
        /// Largest number of iterations of all loops of an invocation together.
        limit: u64,
    },
    /// The device did not finish a run within the time limit.
    #[error(
        "the device did not finish a run within {seconds} seconds, which takes some seconds at most; has a loop no end?"
    )]
    Timeout {
        /// The time limit in seconds.
        seconds: u64,
    },
    /// The driver refuses a shader that naga accepts.
    #[error("the driver refuses: {cause}")]
    Refused {
        /// wgpu's message.
        cause: String,
    },
    /// A kernel did not write all numbers of its output.
    #[error("the kernel [{kernel}] did not write {count} of the numbers it should have written")]
    Unwritten {
        /// The name of the kernel's module.
        kernel: String,
        /// Number of results that were not written.
        count: usize,
    },
    /// An option of the command line does not fit the shader or the picture.
    #[error("{message}")]
    Request {
        /// The message: which option does not fit, and why.
        message: String,
    },
    /// naga finds an error in the shader.
    #[error(transparent)]
    Shader(#[from] shaders::Error),
    /// A file cannot be written.
    #[error("{}", String::from_utf8_lossy(&.0.message(|text| cpu::internals::input::text::escape(text).into_bytes())))]
    Output(#[from] output::Error),
    /// The configuration, the scene or the picture is wrong.
    #[error("{}", String::from_utf8_lossy(&.0.message_for_terminal()))]
    Scene(#[from] cpu::Error),
    /// A file or folder cannot be read or written.
    #[error("{}: {cause}", cpu::internals::input::text::escape(path.as_os_str().as_encoded_bytes()))]
    File {
        /// The path of the file.
        path: PathBuf,
        /// The error of the system.
        cause: std::io::Error,
    },
}

impl From<twin::Error> for Error {
    fn from(error: twin::Error) -> Self {
        match error {
            twin::Error::Scene(error) => Self::Scene(error),
            twin::Error::TooDeep { depth } => Self::TooLarge {
                what: "the materials that attenuate each path",
                bytes: depth.saturating_mul(4),
                limit: u64::from(u32::MAX),
            },
        }
    }
}
