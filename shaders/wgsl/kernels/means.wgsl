// Each invocation adds the samples of one pixel, in the order in which they are traced, and divides their sum by their
// number; twin of the loop over samples in cpu/src/reference.rs.

// The samples of one run, and where their sums start. `first_sample` is the number in its pixel of the first sample.
struct Accumulation {
    // The sum of the first pixel's samples in earlier runs, and zero, from which the sums of all other pixels start.
    // The zero is loaded: a driver that knew it would drop the first addition. But 0 + -0 is 0, and not -0.
    starts: array<PackedVec3, 2>,
    first_sample: u32,
    sample_count: u32,
    samples_per_pixel: u32,
    unused: u32,
}

@group(0) @binding(0) var<storage, read> accumulation: Accumulation;
@group(0) @binding(1) var<storage, read> samples: array<TracedSample>;
// The mean of each pixel of this run. For a last pixel whose samples are not complete, this is their sum so far.
@group(0) @binding(2) var<storage, read_write> means_of_pixels: array<PackedVec3>;

@compute @workgroup_size(64)
fn means(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= arrayLength(&means_of_pixels) {
        return;
    }
    // Samples are counted from the first sample of the first pixel.
    let begin = max(id.x * accumulation.samples_per_pixel, accumulation.first_sample);
    let pixel_end = (id.x + 1u) * accumulation.samples_per_pixel;
    let end = min(pixel_end, accumulation.first_sample + accumulation.sample_count);
    var sum = vec3_load(accumulation.starts[min(id.x, 1u)]);
    for (var sample = begin; sample < end; sample++) {
        sum = sum + vec3_load(samples[sample - accumulation.first_sample].color);
    }
    if end == pixel_end {
        sum = sum / real(accumulation.samples_per_pixel);
    }
    means_of_pixels[id.x] = vec3_store(sum);
}
