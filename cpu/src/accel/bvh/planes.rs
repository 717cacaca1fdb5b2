//! The planes of the boxes of a node, as numbers in lanes. The numbers of bounding spheres have the same form.

use crate::simd::SimdF32;

/// Maximum number of children of a node, and so the number of lanes. It is a multiple of every instruction set's number
/// of `f32` lanes.
pub const WIDTH: usize = 16;

/// The planes of 16 boxes: the lower planes along each axis, then the upper planes.
pub type Planes<P> = [[[P; WIDTH]; 3]; 2];

/// A number that stands for the coordinate of a plane.
pub trait PlaneNumber: Copy + Into<f64> {
    /// Returns the first numbers of `planes`, as many as `F` has lanes.
    fn load<F: SimdF32>(planes: &[Self]) -> F;
}

impl PlaneNumber for f32 {
    #[inline(always)]
    fn load<F: SimdF32>(planes: &[Self]) -> F {
        F::load(planes)
    }
}

impl PlaneNumber for u8 {
    #[inline(always)]
    fn load<F: SimdF32>(planes: &[Self]) -> F {
        F::load_bytes(planes)
    }
}
