//! The two streams of random numbers: where a sample lies in its pixel, and how a surface scatters.
//!
//! `draw_order` has the rule that orders all draws. [`uniform`] draws one number as C++ does, [`block`] many at a time.
//! [`scatter_vectors`] has the conventions of the random vectors, drawn one after the other. `draw_order` and
//! `scatter_stream` have the streams as the renderer uses them.
//! Uses [`math`](crate::math) and [`simd`](crate::simd). Begin with [`uniform`].

pub mod block;
pub(crate) mod draw_order;
pub(crate) mod scatter_stream;
pub mod scatter_vectors;
pub mod uniform;
