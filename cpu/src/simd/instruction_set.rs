//! The instruction sets: which of them the machine has, which is the fastest, and how to force another one.

use std::sync::LazyLock;

#[cfg(target_arch = "aarch64")]
use crate::simd::neon;
use crate::simd::{Kernel, Simd, portable::Portable};
#[cfg(target_arch = "x86_64")]
use crate::simd::{avx2, avx512};

/// The instruction sets for which kernels are compiled, from the simplest to the widest.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum InstructionSet {
    /// Lanes as arrays, for any machine. On x86-64 the compiler turns them into instructions of 128 bits.
    Portable,
    /// The 128-bit vectors of WebAssembly, without fused multiply-add. A WebAssembly module uses them if it was
    /// compiled for them.
    Simd128,
    /// The 128-bit vectors of 64-bit ARM processors (NEON), with fused multiply-add.
    Neon,
    /// Vectors of 256 bits, with fused multiply-add.
    Avx2,
    /// Vectors of 512 bits, but of 256 bits for kernels that [`Simd::run_promptly`] runs.
    Avx512,
    /// Vectors of 512 bits for all kernels, for machines on which comparisons into mask registers have a low latency.
    Avx512Throughout,
}

impl InstructionSet {
    /// All instruction sets, including those that this machine does not have.
    pub const ALL: [Self; 6] =
        [Self::Portable, Self::Simd128, Self::Neon, Self::Avx2, Self::Avx512, Self::Avx512Throughout];

    /// The environment variable that forces an instruction set. Its value is an [`InstructionSet::name`].
    pub const VARIABLE: &'static str = "RENDER_INSTRUCTION_SET";

    /// Returns the name of the instruction set, in lower case.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Portable => "portable",
            Self::Simd128 => "simd128",
            Self::Neon => "neon",
            Self::Avx2 => "avx2",
            Self::Avx512 => "avx512",
            Self::Avx512Throughout => "avx512-throughout",
        }
    }

    /// Whether this machine has the instruction set. The features are detected only once. Each uncertain ray runs a
    /// kernel of its own, and a detection would take a large part of the kernel's time.
    pub fn is_available(self) -> bool {
        static AVAILABLE: LazyLock<[bool; InstructionSet::ALL.len()]> =
            LazyLock::new(|| InstructionSet::ALL.map(InstructionSet::is_detected));
        AVAILABLE[self as usize]
    }

    /// Detects whether this machine has the instruction set.
    fn is_detected(self) -> bool {
        match self {
            Self::Portable => true,
            Self::Simd128 => cfg!(all(target_arch = "wasm32", target_feature = "simd128")),
            #[cfg(target_arch = "aarch64")]
            Self::Neon => neon::is_detected(),
            #[cfg(target_arch = "x86_64")]
            Self::Avx2 => avx2::is_detected(),
            #[cfg(target_arch = "x86_64")]
            Self::Avx512 | Self::Avx512Throughout => avx2::is_detected() && avx512::is_detected(),
            _ => false,
        }
    }

    /// Returns the instruction sets that this machine has, from the simplest to the widest.
    pub fn available() -> impl DoubleEndedIterator<Item = Self> {
        Self::ALL.into_iter().filter(|set| set.is_available())
    }

    /// Returns the fastest instruction set that this machine has.
    pub fn best() -> Self {
        Self::available()
            .filter(|&set| set != Self::Avx512Throughout || has_fast_masks())
            .max()
            .unwrap_or(Self::Portable)
    }

    /// Returns [`InstructionSet::Avx2`], the simplest instruction set with a fused multiply-add. If this machine lacks
    /// it, the result is [`InstructionSet::best`].
    pub fn fused() -> Self {
        if Self::Avx2.is_available() { Self::Avx2 } else { Self::best() }
    }

    /// Returns the instruction set that [`InstructionSet::VARIABLE`] names. If the variable is not set, or its value is
    /// not the name of a set that this machine has, the result is [`InstructionSet::best`].
    pub fn chosen() -> Self {
        Self::named().unwrap_or_else(|_| Self::best())
    }

    /// Returns the instruction set that [`InstructionSet::VARIABLE`] names, or [`InstructionSet::best`] if the variable
    /// is not set or empty. For programs that measure, which must not measure another set than the one that is named.
    ///
    /// # Errors
    /// A message, if the value is not the name of a set that this machine has.
    pub fn named() -> Result<Self, String> {
        std::env::var_os(Self::VARIABLE).filter(|name| !name.is_empty()).map_or_else(|| Ok(Self::best()), Self::of_name)
    }

    /// Returns the instruction set with this name, or a message if this machine has no such set.
    fn of_name(name: impl AsRef<std::ffi::OsStr>) -> Result<Self, String> {
        let name = name.as_ref();
        Self::available().find(|set| name == set.name()).ok_or_else(|| {
            let names: Vec<_> = Self::available().map(Self::name).collect();
            // The debug format escapes control characters.
            format!("{} is {name:?}, and this machine has {}", Self::VARIABLE, names.join(", "))
        })
    }

    /// Runs `kernel`, compiled for this instruction set. If this machine lacks it, `kernel` is compiled for the
    /// portable set.
    pub fn run<K: Kernel>(self, kernel: K) -> K::Output {
        let set = if self.is_available() { self } else { Self::Portable };
        match set {
            #[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
            Self::Simd128 => crate::simd::simd128::Simd128.run(kernel),
            #[cfg(target_arch = "aarch64")]
            // SAFETY: the machine has the instruction set, as `is_available` has just shown; likewise below.
            Self::Neon => unsafe { neon::Neon::new() }.run(kernel),
            #[cfg(target_arch = "x86_64")]
            // SAFETY: the machine has the instruction set, as `is_available` has just shown; likewise below.
            Self::Avx2 => unsafe { avx2::Avx2::new() }.run(kernel),
            #[cfg(target_arch = "x86_64")]
            // SAFETY: as above.
            Self::Avx512 => unsafe { avx512::Avx512::new(false) }.run(kernel),
            #[cfg(target_arch = "x86_64")]
            // SAFETY: as above.
            Self::Avx512Throughout => unsafe { avx512::Avx512::new(true) }.run(kernel),
            _ => Portable.run(kernel),
        }
    }
}

/// Whether comparisons into mask registers are as fast as those into vectors. On AMD's processors they are, by
/// measurement (docs/experiments.md). This is called only once for each picture, because `cpuid` takes microseconds
/// under a hypervisor.
fn has_fast_masks() -> bool {
    #[cfg(target_arch = "x86_64")]
    {
        let std::arch::x86_64::CpuidResult { ebx, ecx, edx, .. } = std::arch::x86_64::__cpuid(0);
        [ebx, edx, ecx].map(u32::to_le_bytes).concat() == b"AuthenticAMD"
    }
    #[cfg(not(target_arch = "x86_64"))]
    false
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_variable_of_these_tests_names_their_set() {
        let variable = std::env::var(InstructionSet::VARIABLE).unwrap_or_default();
        let expected = if variable.is_empty() { InstructionSet::best().name() } else { &variable };
        assert_eq!(InstructionSet::named().map(InstructionSet::name), Ok(expected));
    }

    #[test]
    fn every_set_of_the_machine_has_its_name_and_other_names_are_errors() {
        for set in InstructionSet::available() {
            assert_eq!(InstructionSet::of_name(set.name()), Ok(set));
        }
        assert!(InstructionSet::fused().is_available());
        for name in ["avx3", "AVX2", "avx2 ", "avx2\u{7}"] {
            let message = InstructionSet::of_name(name).expect_err("no set has this name");
            assert!(
                message.starts_with("RENDER_INSTRUCTION_SET is \"") && message.contains("has portable"),
                "{message}"
            );
            assert!(!message.contains('\u{7}'), "control characters are escaped: {message:?}");
        }
    }
}
