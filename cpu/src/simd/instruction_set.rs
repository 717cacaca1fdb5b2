//! Which instruction set: what the machine has, what is the fastest, and how to force another.

use std::sync::LazyLock;

use crate::simd::portable::Portable;
use crate::simd::{Kernel, Simd};
#[cfg(target_arch = "x86_64")]
use crate::simd::{avx2, avx512};

/// The instruction sets that kernels are compiled for, the plainest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum InstructionSet {
    /// Arrays, for any machine; on x86-64 the compiler makes 128 bits of them.
    Portable,
    /// 256 bits with fused multiply-add.
    Avx2,
    /// 512 bits, but 256 for work on one ray after the other among a handful of objects.
    Avx512,
    /// 512 bits throughout, for machines on which comparisons into mask registers are quick.
    Avx512Throughout,
}

impl InstructionSet {
    /// All of them, whether this machine has them or not.
    pub const ALL: [Self; 4] = [Self::Portable, Self::Avx2, Self::Avx512, Self::Avx512Throughout];

    /// The environment variable that forces one of them, by [`InstructionSet::name`].
    pub const VARIABLE: &'static str = "RENDER_INSTRUCTION_SET";

    /// Its name in lower case.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Portable => "portable",
            Self::Avx2 => "avx2",
            Self::Avx512 => "avx512",
            Self::Avx512Throughout => "avx512-throughout",
        }
    }

    /// Whether this machine has it. Asked of the machine once: a single ray in doubt is a kernel of its own, of which
    /// asking for all features would be a quarter.
    #[must_use]
    pub fn is_available(self) -> bool {
        static AVAILABLE: LazyLock<[bool; InstructionSet::ALL.len()]> =
            LazyLock::new(|| InstructionSet::ALL.map(InstructionSet::is_found));
        AVAILABLE[self as usize]
    }

    /// Asks the machine.
    fn is_found(self) -> bool {
        #[cfg(target_arch = "x86_64")]
        return match self {
            Self::Portable => true,
            Self::Avx2 => avx2::is_found(),
            Self::Avx512 | Self::Avx512Throughout => avx2::is_found() && avx512::is_found(),
        };
        #[cfg(not(target_arch = "x86_64"))]
        return matches!(self, Self::Portable);
    }

    /// The fastest that this machine has.
    #[must_use]
    pub fn best() -> Self {
        let available = Self::ALL.into_iter().filter(|set| set.is_available());
        available.filter(|&set| set != Self::Avx512Throughout || has_quick_masks()).max().unwrap_or(Self::Portable)
    }

    /// The plainest with fused multiply-add in one instruction; the best where none has: for a few exact products.
    #[must_use]
    pub fn fused() -> Self {
        if Self::Avx2.is_available() { Self::Avx2 } else { Self::best() }
    }

    /// What [`InstructionSet::VARIABLE`] names, where it is set to one that this machine has; else the best.
    #[must_use]
    pub fn chosen() -> Self {
        let named = std::env::var_os(Self::VARIABLE);
        Self::ALL
            .into_iter()
            .find(|set| named.as_ref().is_some_and(|name| name == set.name()) && set.is_available())
            .unwrap_or_else(Self::best)
    }

    /// Runs `kernel` compiled for it; for the portable one when this machine lacks it.
    pub fn run<K: Kernel>(self, kernel: K) -> K::Output {
        let set = if self.is_available() { self } else { Self::Portable };
        match set {
            #[cfg(target_arch = "x86_64")]
            // SAFETY: the machine has the instruction set, as was just asked; likewise below.
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

/// Whether comparisons into mask registers take no longer than those into vectors: on AMD's machines they do not, by
/// measurement (docs/experiments.md). Asked once: under a hypervisor the instruction that tells takes microseconds.
fn has_quick_masks() -> bool {
    #[cfg(target_arch = "x86_64")]
    {
        static IS_AMD: LazyLock<bool> = LazyLock::new(|| {
            let std::arch::x86_64::CpuidResult { ebx, ecx, edx, .. } = std::arch::x86_64::__cpuid(0);
            [ebx, edx, ecx].map(u32::to_le_bytes).concat() == b"AuthenticAMD"
        });
        *IS_AMD
    }
    #[cfg(not(target_arch = "x86_64"))]
    false
}
