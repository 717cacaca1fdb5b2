//! Macros that turn a table of operations into the functions of a lane type. The table has one line for each operation.

/// Defines functions in the body of an `impl`. The bodies of the functions call intrinsics of `std::arch`.
///
/// Each body is inside an `unsafe` block. So a body that reads or writes memory has a comment that says why this is
/// sound.
macro_rules! intrinsics {
    ($(fn $name:ident($($argument:tt)*) $(-> $result:ty)? { $($body:tt)* })+) => {
        $(#[inline(always)]
        fn $name($($argument)*) $(-> $result)? {
            // SAFETY: lanes exist only inside a kernel. A kernel runs only if `run` has the proof that the machine has
            // the instruction set.
            unsafe { $($body)* }
        })+
    };
}

/// Implements arithmetic operators for a lane type with one field. Their bodies call intrinsics of `std::arch`.
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

/// Takes the macro that detects a processor feature, and the features for which kernels are compiled, and defines two
/// functions. `compiled` runs a kernel with these features enabled. `is_detected` tells whether the machine has all of
/// them.
macro_rules! features {
    ($detected:ident: $($feature:tt),+) => {
        /// Whether this machine has all features that `compiled` enables.
        pub(super) fn is_detected() -> bool {
            true $(&& std::arch::$detected!($feature))+
        }

        /// Runs `kernel` in a separate function that is compiled with the features.
        #[inline(never)]
        #[target_feature($(enable = $feature),+)]
        fn compiled<S: $crate::simd::Simd, K: $crate::simd::Kernel>(simd: S, kernel: K) -> K::Output {
            kernel.call(simd)
        }
    };
}

pub(super) use {features, intrinsics, operators};
