//! The errors for which a scene has no form for a device.

/// The reason why a scene has no form for a device.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The configuration makes no picture.
    #[error("{}", String::from_utf8_lossy(&.0.message_for_terminal()))]
    Scene(#[from] cpu::Error),
    /// The maximum depth does not fit in 32 bits, and no device could hold the list of a path's surfaces.
    #[error("a max_depth of {depth} is too large for a device; use a smaller one")]
    TooDeep {
        /// The maximum depth of the configuration.
        depth: u64,
    },
}
