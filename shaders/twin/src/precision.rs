//! The number type of a composition.

use std::fmt;

/// The number type that `real` stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Precision {
    /// 32-bit floating point (`f32`), which every target has.
    F32,
    /// 64-bit floating point (`f64`), as in the renderer. Few targets have it.
    F64,
}

impl Precision {
    /// Both precisions.
    pub const ALL: [Self; 2] = [Self::F32, Self::F64];

    /// Returns the name of the module that defines `real` with this precision.
    #[must_use]
    pub const fn module(self) -> &'static str {
        match self {
            Self::F32 => "real_f32",
            Self::F64 => "real_f64",
        }
    }
}

impl fmt::Display for Precision {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::F32 => "f32",
            Self::F64 => "f64",
        })
    }
}
