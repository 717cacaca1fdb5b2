//! The macro `run_fused`, which runs the compensated and precise formulas of one ray with a fused multiply-add.

/// Runs an expression, whose inputs are references, with the instruction set
/// [`InstructionSet::fused`](crate::simd::instruction_set::InstructionSet::fused).
///
/// This is a macro, because a closure would be compiled without the instruction set. In a closure `mul_add` would call
/// a library function.
macro_rules! run_fused {
    (|$($name:ident: &$type:ty),+| -> $output:ty { $($body:tt)* }) => {{
        struct Work<'a>($(&'a $type),+);

        impl $crate::simd::Kernel for Work<'_> {
            type Output = $output;

            #[inline(always)]
            fn call<S: $crate::simd::Simd>(self, _: S) -> $output {
                let Self($($name),+) = self;
                $($body)*
            }
        }
        $crate::simd::instruction_set::InstructionSet::fused().run(Work($($name),+))
    }};
}

pub(crate) use run_fused;
