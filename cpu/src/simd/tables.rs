//! Macros that turn tables of operations into functions of a lane type, one line for each operation.

/// The functions of a trait, each always inlined: for the body of an `impl`.
macro_rules! functions {
    ($(fn $name:ident($($argument:tt)*) $(-> $result:ty)? $body:block)+) => {
        $(#[inline(always)]
        fn $name($($argument)*) $(-> $result)? $body)+
    };
}

/// The functions of a trait, each by intrinsics of `std::arch`: for the body of an `impl`.
///
/// A body is inside an `unsafe` block, so a body that reads or writes memory says why it may.
macro_rules! intrinsics {
    ($(fn $name:ident($($argument:tt)*) $(-> $result:ty)? { $($body:tt)* })+) => {
        $(#[inline(always)]
        fn $name($($argument)*) $(-> $result)? {
            // SAFETY: a lane exists only inside a kernel, which runs only where `run` has the proof that the machine
            // has the instruction set.
            unsafe { $($body)* }
        })+
    };
}

/// Arithmetic operators of a one-field lane type, each by intrinsics of `std::arch`.
macro_rules! operators {
    ($type:ident: $($trait:ident $name:ident($($argument:tt)*) { $($body:tt)* })+) => {
        $(impl std::ops::$trait for $type {
            type Output = Self;
            #[inline(always)]
            fn $name($($argument)*) -> Self {
                // SAFETY: as in `intrinsics`.
                Self(unsafe { $($body)* })
            }
        })+
    };
}

/// The features that kernels are compiled for: `is_detected` tests the machine for those that `compiled` enables.
macro_rules! features {
    ($($feature:tt),+) => {
        /// Whether this machine has all features that kernels are compiled for here.
        pub fn is_detected() -> bool {
            true $(&& is_x86_feature_detected!($feature))+
        }

        /// Runs `kernel`, compiled for the features as a function of its own.
        #[inline(never)]
        #[target_feature($(enable = $feature),+)]
        fn compiled<S: $crate::simd::Simd, K: $crate::simd::Kernel>(simd: S, kernel: K) -> K::Output {
            kernel.call(simd)
        }
    };
}

pub(super) use {features, functions, intrinsics, operators};
