//! The macro `run_fused`, which runs the compensated and precise formulas of one ray with a fused multiply-add.

/// Runs a block of code that is compiled for the instruction set
/// [`InstructionSet::fused`](crate::simd::instruction_set::InstructionSet::fused), and returns its result. A call looks
/// like a closure: `run_fused!(|a: &f64, b: &f64| -> f64 { a.mul_add(*b, 1.0) })`. Here `a` and `b` must be variables
/// of the caller, both of type `&f64`. The block can use no other variables of the caller.
///
/// This is a macro and no closure (see [`Kernel::call`](crate::simd::Kernel::call)). In a closure `mul_add` would call
/// a slow library function.
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
