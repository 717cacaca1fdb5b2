//! Traces the samples of a picture on a device, run after run, and adds them to the means of the pixels.

use std::marker::PhantomData;
use std::time::Duration;

use cpu::{Size, Vec3};
use shaders::{Features, Library};

use super::streams::{Limits, Streams, samples_of_a_run};
use super::{Convention, Recording};
use crate::head::{Part, head};
use crate::packed::Packed;
use crate::pipeline::{Content, MAX_INVOCATIONS};
use crate::ray_loop::{MAX_ITERATIONS, RayLoop, steps};
use crate::renderer::{BATCH, LEAST_BATCH, TESTS};
use crate::{Error, Float, Gpu, Picture, Pipeline};

/// Number of words behind those of a run's samples, for each surface that a path may hit. A path in f32 may take more
/// words than it took in f64.
const SPARE_WORDS: u64 = 48;
/// Largest number of words behind those of a run's samples.
const MOST_SPARE_WORDS: u64 = 1 << 16;

/// Two pipelines that render pictures with random numbers, in one precision and with one set of features:
/// `kernels/samples` traces samples, and `kernels/means` adds those of each pixel.
#[derive(Debug)]
pub struct SampleRenderer<'a, T> {
    gpu: &'a Gpu,
    samples: Pipeline,
    means: Pipeline,
    features: Features,
    /// Whether rays find their closest hit in a hierarchy of boxes.
    in_hierarchy: bool,
    precision: PhantomData<T>,
}

/// The means of a picture with random numbers, and the samples whose paths took another number of words than recorded.
#[derive(Clone, Debug)]
pub struct SampledRendering<T> {
    /// Number of columns and rows.
    pub size: Size,
    /// The mean colours before quantisation, row by row from the top left.
    pub pixels: Vec<Vec3<T>>,
    /// Number of samples whose paths took another number of words than recorded.
    pub disagreeing: u64,
    /// The first of these samples: its number, the recorded number of words, and the number on the device.
    pub first_disagreeing: Option<(u64, u32, u32)>,
    /// The time that the device needed, without the transfers.
    pub time: Duration,
}

impl<'a, T: Float> SampleRenderer<'a, T> {
    /// Compiles both kernels from `library`, with the constants of `features`. `own` has the names and values of
    /// constants that a replaced module declares; they are for `kernels/samples`.
    ///
    /// # Errors
    /// The errors of [`Pipeline::new`].
    pub fn new(gpu: &'a Gpu, library: &Library, features: &Features, own: &[(&str, f64)]) -> Result<Self, Error> {
        let constants = [&features.constants()[..], own].concat();
        let samples = Pipeline::new(gpu, &library.compose("kernels/samples", T::PRECISION)?, &constants)?;
        let means = Pipeline::new(gpu, &library.compose("kernels/means", T::PRECISION)?, &[])?;
        let in_hierarchy = library.has_hierarchy();
        Ok(Self { gpu, samples, means, features: *features, in_hierarchy, precision: PhantomData })
    }

    /// Renders `picture` with the random numbers of `recording`, which is a recording of this picture.
    ///
    /// # Errors
    /// The errors of [`Pipeline::run`], and [`Error::TooManyIterations`].
    pub fn render(&self, picture: &Picture<T>, recording: &Recording) -> Result<SampledRendering<T>, Error> {
        self.render_from(picture, recording, Streams::new(recording), |_, _| ())
    }

    /// Renders as [`Self::render`] does, with the words of `streams`. After each run it calls `tell` with the number of
    /// finished samples and the number of all samples.
    ///
    /// # Errors
    /// The errors of [`Self::render`].
    pub fn render_from(
        &self,
        picture: &Picture<T>,
        recording: &Recording,
        mut streams: Streams,
        mut tell: impl FnMut(u64, u64),
    ) -> Result<SampledRendering<T>, Error> {
        let mut rendering = SampledRendering {
            size: picture.size,
            pixels: Vec::new(),
            disagreeing: 0,
            first_disagreeing: None,
            time: Duration::ZERO,
        };
        let ray_loop = RayLoop::new(picture, self.in_hierarchy);
        let limits = self.limits(&ray_loop, recording);
        let mut start_of_sum = Vec3::splat(T::of(0.0));
        let (per_pixel, total) = (u64::from(recording.samples_per_pixel), recording.words.len() as u64);
        let mut first = 0;
        while first < total {
            let counts = &recording.words[first as usize..];
            let counts = &counts[..samples_of_a_run(counts, limits)];
            let part = Part::Samples {
                first_pixel: (first / per_pixel) as u32,
                first_sample: (first % per_pixel) as u32,
                count: counts.len() as u32,
                samples_per_pixel: recording.samples_per_pixel,
                convention: recording.convention as u32,
            };
            let words = streams.next_run(counts, self.spare());
            let traced = self.trace(picture, &ray_loop, &part, &words, &mut rendering.time)?;
            let actual = traced.chunks_exact(TracedSample::<T>::SIZE).map(TracedSample::<T>::words);
            rendering.note_words(first, counts, actual);
            // Samples are counted from the first sample of the first pixel.
            let end = first % per_pixel + counts.len() as u64;
            let mut sums = self.add(&part, start_of_sum, &traced, end.div_ceil(per_pixel), &mut rendering.time)?;
            let unfinished = if end.is_multiple_of(per_pixel) { None } else { sums.pop() };
            start_of_sum = unfinished.unwrap_or(Vec3::splat(T::of(0.0)));
            rendering.pixels.extend(sums);
            first += counts.len() as u64;
            tell(first, total);
        }
        Ok(rendering)
    }
}

impl<T: Float> SampleRenderer<'_, T> {
    /// Returns the number of spare words of a run.
    fn spare(&self) -> u64 {
        (SPARE_WORDS * u64::from(self.features.max_depth)).clamp(SPARE_WORDS, MOST_SPARE_WORDS)
    }

    /// Returns the limits of one run.
    fn limits(&self, ray_loop: &RayLoop, recording: &Recording) -> Limits {
        let binding = self.gpu.binding_limit();
        let entries = (binding / size_of::<[u32; 2]>() as u64).saturating_sub(self.spare());
        let depth = u64::from(self.features.max_depth);
        let tests = (ray_loop.tests() * depth).max(1);
        let widest = (depth * size_of::<u32>() as u64).max(path_size::<T>());
        let samples = BATCH.min(MAX_INVOCATIONS).min(binding / widest).min((TESTS / tests).max(LEAST_BATCH));
        // The loop of `kernels/means` adds the samples of a pixel.
        let is_long = u64::from(recording.samples_per_pixel) > MAX_ITERATIONS;
        Limits { samples: if is_long { samples.min(MAX_ITERATIONS) } else { samples }, entries }
    }

    /// Traces the samples of `part` and returns the bytes of their [`TracedSample`]s. Adds the device's time to `time`.
    fn trace(
        &self,
        picture: &Picture<T>,
        ray_loop: &RayLoop,
        part: &Part,
        words: &[[u32; 2]],
        time: &mut Duration,
    ) -> Result<Vec<u8>, Error> {
        let &Part::Samples { count, convention, .. } = part else { return Ok(Vec::new()) };
        let depth = self.features.max_depth;
        let surfaces = ray_loop.surfaces_of_a_run(depth, tries_of(convention))?;
        let heads: Vec<_> = steps(depth, surfaces).iter().map(|depths| head(picture, part, depths)).collect();
        let samples = u64::from(count);
        let own = [
            Content::Scratch(samples * u64::from(depth) * size_of::<u32>() as u64),
            Content::Output(samples * TracedSample::<T>::SIZE as u64),
            Content::Scratch(samples * path_size::<T>()),
            Content::Input(bytemuck::cast_slice(words)),
        ];
        let run = self.samples.run(self.gpu, &ray_loop.contents(Content::Inputs(&heads), &own), samples)?;
        *time += run.time;
        Ok(run.outputs.concat())
    }

    /// Adds the samples of `part`, whose bytes are `traced`, to sums that start from `start` in the first pixel.
    /// Returns the mean of each of the `pixels` pixels that the run touches. If the samples of the last pixel are not
    /// complete, its entry is their sum.
    fn add(
        &self,
        part: &Part,
        start: Vec3<T>,
        traced: &[u8],
        pixels: u64,
        time: &mut Duration,
    ) -> Result<Vec<Vec3<T>>, Error> {
        let &Part::Samples { first_sample, count, samples_per_pixel, .. } = part else { return Ok(Vec::new()) };
        let mut accumulation = Vec::new();
        [start, Vec3::splat(T::of(0.0))].iter().for_each(|vector| vector.pack(&mut accumulation));
        [first_sample, count, samples_per_pixel, 0].iter().for_each(|number| number.pack(&mut accumulation));
        let means = Content::Output(pixels * size_of::<Vec3<T>>() as u64);
        let run = self.means.run(self.gpu, &[Content::Input(&accumulation), Content::Input(traced), means], pixels)?;
        *time += run.time;
        let numbers = bytemuck::pod_collect_to_vec::<u8, T>(&run.outputs.concat());
        Ok(numbers.chunks_exact(3).map(|rgb| Vec3::new(rgb[0], rgb[1], rgb[2])).collect())
    }
}

impl<T> SampledRendering<T> {
    /// Compares the numbers of words that the samples from number `first` on took with the recorded numbers `counts`.
    fn note_words(&mut self, first: u64, counts: &[u32], actual: impl Iterator<Item = u32>) {
        for ((sample, recorded), actual) in (first..).zip(counts).zip(actual) {
            if *recorded != actual {
                self.disagreeing += 1;
                self.first_disagreeing.get_or_insert((sample, *recorded, actual));
            }
        }
    }
}

/// The structure `TracedSample` of `layout.wgsl`: three numbers, and two of 32 bits.
struct TracedSample<T>(PhantomData<T>);

impl<T> TracedSample<T> {
    /// Size in bytes.
    const SIZE: usize = 3 * size_of::<T>() + 2 * size_of::<u32>();

    /// Returns the number of words that the sample with these bytes took.
    fn words(bytes: &[u8]) -> u32 {
        let at = 3 * size_of::<T>();
        bytemuck::pod_read_unaligned(&bytes[at..at + size_of::<u32>()])
    }
}

/// Returns the size in bytes of the structure `PackedSamplePath` of `trace_samples.wgsl`.
const fn path_size<T>() -> u64 {
    (6 * size_of::<T>() + 4 * size_of::<u32>()) as u64
}

/// Returns the largest number of vectors that the convention with this number chooses a scatter vector from.
fn tries_of(convention: u32) -> u64 {
    Convention::ALL.into_iter().find(|one| *one as u32 == convention).map_or(0, Convention::tries)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn structures_have_the_size_of_their_twins<T: Float>() {
        let composition = Library::standard().compose("kernels/samples", T::PRECISION).expect("it exists");
        let shader = composition.validate().expect("it is valid");
        assert_eq!(shader.size_of("TracedSample"), Some(TracedSample::<T>::SIZE as u32));
        assert_eq!(shader.size_of("PackedSamplePath"), Some(path_size::<T>() as u32));
    }

    #[test]
    fn buffers_have_no_padding_in_either_precision() {
        structures_have_the_size_of_their_twins::<f32>();
        structures_have_the_size_of_their_twins::<f64>();
    }
}
