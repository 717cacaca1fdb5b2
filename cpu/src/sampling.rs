//! The two streams of random numbers: where a sample lies in its pixel, and how a surface scatters.
//!
//! [`uniform`] draws one number as C++ does, [`block`] many at a time; [`scatter_vectors`] are the conventions of the
//! random vectors, one after the other; `pixel_jitter` and `scatter_stream` are the streams as the renderer uses them.
//! Uses [`math`](crate::math) and [`simd`](crate::simd). Begin with [`uniform`].

pub mod block;
pub(crate) mod pixel_jitter;
pub(crate) mod scatter_stream;
pub mod scatter_vectors;
pub mod uniform;
