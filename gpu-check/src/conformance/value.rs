//! Numbers of the types of WGSL. Each is held as `f64`, which has all of them exactly.

use crate::Float;

/// The type of a probe's inputs or results.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Type {
    /// 32-bit floating point.
    F32,
    /// 64-bit floating point, an extension of naga.
    F64,
    /// Unsigned 32-bit integer.
    U32,
}

impl Type {
    /// Returns the type's name in WGSL.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::F32 => "f32",
            Self::F64 => "f64",
            Self::U32 => "u32",
        }
    }

    /// Returns the size of a number in a buffer, in bytes.
    #[must_use]
    pub const fn size(self) -> usize {
        if matches!(self, Self::F64) { 8 } else { 4 }
    }

    /// Returns the number as text. The text of a floating-point number ends with its bits.
    #[must_use]
    pub fn show(self, number: f64) -> String {
        match self {
            Self::F32 => format!("{:?} (0x{:08x})", number as f32, (number as f32).to_bits()),
            Self::F64 => format!("{number:?} (0x{:016x})", number.to_bits()),
            Self::U32 => number.to_string(),
        }
    }

    /// Returns the bytes of the numbers, as they lie in a buffer.
    #[must_use]
    pub fn to_bytes(self, numbers: impl Iterator<Item = f64>) -> Vec<u8> {
        match self {
            Self::F32 => numbers.flat_map(|number| (number as f32).to_le_bytes()).collect(),
            Self::F64 => numbers.flat_map(f64::to_le_bytes).collect(),
            Self::U32 => numbers.flat_map(|number| (number as u32).to_le_bytes()).collect(),
        }
    }

    /// Returns the numbers of a buffer.
    #[must_use]
    pub fn of_bytes(self, bytes: &[u8]) -> Vec<f64> {
        let words = || bytemuck::pod_collect_to_vec::<_, u32>(bytes).into_iter();
        match self {
            Self::F32 => words().map(|bits| f64::from(f32::from_bits(bits))).collect(),
            Self::F64 => bytemuck::pod_collect_to_vec(bytes),
            Self::U32 => words().map(f64::from).collect(),
        }
    }
}

/// A number of Rust with the type of a number of WGSL.
pub trait Value: Copy + 'static {
    /// The type in WGSL.
    const TYPE: Type;
    /// Returns the number as `f64`, which is exact.
    fn to_f64(self) -> f64;
    /// Returns the number of this value, which must be of this type.
    fn of_f64(value: f64) -> Self;
}

macro_rules! value {
    ($type:ty, $name:expr) => {
        impl Value for $type {
            const TYPE: Type = $name;
            fn to_f64(self) -> f64 {
                self.into()
            }
            fn of_f64(value: f64) -> Self {
                value as Self
            }
        }
    };
}

value!(f32, Type::F32);
value!(f64, Type::F64);
value!(u32, Type::U32);

/// A floating-point type over which probes are generic.
pub trait Number: Float + Value {
    /// The smallest positive normal number.
    const TINY: Self;
    /// Returns `self * factor + term` with one rounding.
    fn fused(self, factor: Self, term: Self) -> Self;
}

macro_rules! number {
    ($type:ty) => {
        impl Number for $type {
            const TINY: Self = Self::MIN_POSITIVE;
            fn fused(self, factor: Self, term: Self) -> Self {
                self.mul_add(factor, term)
            }
        }
    };
}

number!(f32);
number!(f64);
