//! The number type that a composition is for.

use std::fmt;

/// What `real` stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Precision {
    /// 32 bits: every target has it.
    F32,
    /// 64 bits, as in the renderer; few targets have it.
    F64,
}

impl Precision {
    /// Both precisions.
    pub const ALL: [Self; 2] = [Self::F32, Self::F64];

    /// The module that defines `real`.
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
