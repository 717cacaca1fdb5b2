//! What the path tracing loop is compiled for: one trait in place of three type parameters.

use crate::accel::find::Accelerator;
use crate::layout::Layout;
use crate::render::prepared::Prepared;
use crate::simd::Simd;

/// An instruction set, a layout and an acceleration structure, with a scene prepared for them.
pub trait Context<'a>: 'a {
    /// The instruction set.
    type Simd: Simd;
    /// The layout.
    type Layout: Layout;
    /// The acceleration structure.
    type Accel: Accelerator + 'a;

    /// The proof that the machine has the instruction set.
    fn simd(&self) -> Self::Simd;
    /// The prepared scene.
    fn prepared(&self) -> &'a Prepared<Self::Layout>;
    /// The acceleration structure over its objects.
    fn accel(&self) -> &'a Self::Accel;
}

/// The only [`Context`].
pub struct Compiled<'a, S, L: Layout, A> {
    pub simd: S,
    pub prepared: &'a Prepared<L>,
    pub accel: &'a A,
}

impl<'a, S: Simd, L: Layout + 'a, A: Accelerator> Context<'a> for Compiled<'a, S, L, A> {
    type Simd = S;
    type Layout = L;
    type Accel = A;

    #[inline(always)]
    fn simd(&self) -> S {
        self.simd
    }
    #[inline(always)]
    fn prepared(&self) -> &'a Prepared<L> {
        self.prepared
    }
    #[inline(always)]
    fn accel(&self) -> &'a A {
        self.accel
    }
}
