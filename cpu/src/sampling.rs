//! The two streams of random numbers. One gives the samples their positions in the pixels, the other one gives surfaces
//! their random vectors.
//!
//! `draw_order` has the rule that orders all draws. [`uniform`] draws one number as C++ does, and [`block`] draws many
//! at a time. [`scatter_vectors`] draws random vectors one after the other, for the reference. `draw_order` and
//! `scatter_stream` have the two streams in the form that the real renderer uses. Uses [`math`](crate::math) and
//! [`simd`](crate::simd). Begin with [`uniform`].

pub mod block;
pub(crate) mod draw_order;
pub mod scatter_stream;
pub mod scatter_vectors;
pub mod uniform;
