//! Numbers of the types of WGSL, held as bits.

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
        match self {
            Self::F64 => 8,
            _ => 4,
        }
    }

    /// Returns the value of `bits` as `f64`, which is exact.
    #[must_use]
    pub fn value(self, bits: u64) -> f64 {
        match self {
            Self::F32 => f64::from(f32::of_bits(bits)),
            Self::F64 => f64::of_bits(bits),
            Self::U32 => f64::from(u32::of_bits(bits)),
        }
    }

    /// Whether both numbers have the same bits, or both are NaN. IEEE 754 does not tell which bits NaN has.
    #[must_use]
    pub fn same(self, one: u64, other: u64) -> bool {
        one == other || (self.value(one).is_nan() && self.value(other).is_nan())
    }

    /// Returns the number as text. The text of a floating-point number ends with its bits.
    #[must_use]
    pub fn show(self, bits: u64) -> String {
        match self {
            Self::F32 => format!("{:?} (0x{bits:08x})", f32::of_bits(bits)),
            Self::F64 => format!("{:?} (0x{bits:016x})", f64::of_bits(bits)),
            Self::U32 => format!("{bits}"),
        }
    }

    /// Returns the bytes of the numbers, as they lie in a buffer.
    #[must_use]
    pub fn to_bytes(self, numbers: impl Iterator<Item = u64>) -> Vec<u8> {
        numbers.flat_map(|bits| bits.to_le_bytes().into_iter().take(self.size())).collect()
    }

    /// Returns the numbers of a buffer. Bytes after the last whole number are ignored.
    #[must_use]
    pub fn of_bytes(self, bytes: &[u8]) -> Vec<u64> {
        let number = |chunk: &[u8]| chunk.iter().rev().fold(0, |bits, byte| bits << 8 | u64::from(*byte));
        bytes.chunks_exact(self.size()).map(number).collect()
    }
}

/// A number in Rust that has the same bits as a number of WGSL.
pub trait Bits: Copy + 'static {
    /// The type in WGSL.
    const TYPE: Type;
    /// Returns the bits. Unused upper bits are zero.
    fn to_word(self) -> u64;
    /// Returns the number with these bits. Unused upper bits are ignored.
    fn of_bits(bits: u64) -> Self;
}

macro_rules! bits {
    ($type:ty, $name:expr, |$number:ident| $to:expr, |$bits:ident| $of:expr) => {
        impl Bits for $type {
            const TYPE: Type = $name;
            fn to_word(self) -> u64 {
                let $number = self;
                $to
            }
            fn of_bits($bits: u64) -> Self {
                $of
            }
        }
    };
}

bits!(f32, Type::F32, |number| u64::from(number.to_bits()), |bits| Self::from_bits(bits as u32));
bits!(f64, Type::F64, |number| number.to_bits(), |bits| Self::from_bits(bits));
bits!(u32, Type::U32, |number| u64::from(number), |bits| bits as Self);

/// A floating-point type over which probes are generic.
pub trait Number: Float + Bits {
    /// The smallest positive normal number.
    const TINY: Self;
    /// Returns `self * factor + term` with one rounding.
    fn fused(self, factor: Self, term: Self) -> Self;
    /// Whether the number is subnormal.
    fn is_tiny(self) -> bool;
}

macro_rules! number {
    ($type:ty) => {
        impl Number for $type {
            const TINY: Self = Self::MIN_POSITIVE;
            fn fused(self, factor: Self, term: Self) -> Self {
                self.mul_add(factor, term)
            }
            fn is_tiny(self) -> bool {
                self.is_subnormal()
            }
        }
    };
}

number!(f32);
number!(f64);
