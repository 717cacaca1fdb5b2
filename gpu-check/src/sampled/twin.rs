//! The twin of `trace_samples.wgsl` and `kernels/means.wgsl` in Rust: a picture with random numbers, in any precision.
//! With f32 it gives the bits that the f32 shader must give.

use cpu::Vec3;

use super::streams::{Streams, Words, halves};
use super::{Convention, Recording};
use crate::{Float, Picture};

/// The largest number of vectors that a scatter vector is chosen from, as in `scatter_vectors.wgsl`.
pub const MAX_TRIES: u64 = 100;

/// Returns the mean colours of `picture`, with the words of `streams`. Every path starts at its recorded place in the
/// stream of scatter vectors, also if the path before it takes another number of words in this precision. Calls `tell`
/// after each pixel with the number of finished pixels.
pub fn means<T: Float>(
    picture: &Picture<T>,
    recording: &Recording,
    streams: Streams,
    mut tell: impl FnMut(usize),
) -> Vec<Vec3<T>> {
    let Streams { mut jitter, mut scatter } = streams;
    let width = picture.size.width();
    let mut means = Vec::with_capacity(picture.size.pixels());
    for counts in recording.words.chunks(recording.samples_per_pixel as usize) {
        let [row, column] = [means.len() / width, means.len() % width].map(|number| T::of(number as f64));
        let mut sum = Vec3::splat(T::of(0.0));
        for count in counts {
            let half = T::of(0.5);
            let offset = [(); 2].map(|()| draw(&mut jitter, -half, half));
            let mut own = scatter.clone();
            let ray = picture.camera.ray(row, column, offset);
            sum = sum + picture.color_along(ray, |extent| scatter_vector(&mut own, recording.convention, extent));
            for _ in 0..*count {
                scatter.next_word();
            }
        }
        means.push(sum / T::of(f64::from(recording.samples_per_pixel)));
        tell(means.len());
    }
    means
}

/// Returns the next scatter vector, as `scatter_vector_next` does.
fn scatter_vector<T: Float>(stream: &mut Words, convention: Convention, extent: T) -> Vec3<T> {
    let mut in_cube = |half: T| Vec3::from([(); 3].map(|()| draw(stream, -half, half)));
    if convention == Convention::Statement {
        return in_cube(extent);
    }
    for _ in 0..MAX_TRIES {
        let vector = in_cube(T::of(1.0));
        let length_squared = vector.dot(vector);
        if T::of(1e-160).less(length_squared) && length_squared.less_equal(T::of(1.0)) {
            return vector / length_squared.sqrt() * extent;
        }
    }
    Vec3::splat(T::of(0.0))
}

/// Returns the next number in `[low, high)`, as `uniform_draw` does.
fn draw<T: Float>(stream: &mut Words, low: T, high: T) -> T {
    canonical(halves(stream.next_word()).map(|half| T::of(f64::from(half)))) * (high - low) + low
}

/// Converts the lower and the upper half of a word to a number in `[0, 1)`, as `uniform_canonical` does.
pub(crate) fn canonical<T: Float>([lower, upper]: [T; 2]) -> T {
    let quotient = (upper * T::of(4_294_967_296.0) + lower) / T::of(18_446_744_073_709_551_616.0);
    if quotient < T::BELOW_ONE { quotient } else { T::BELOW_ONE }
}
