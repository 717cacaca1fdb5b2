// Converts linear colours to the bytes of a picture: the mean, gamma, and four bytes for each pixel.

struct Development {
    pixel_count: u32,
    // The number of samples in each sum.
    samples: u32,
    gamma: f32,
    // Whether the colours are shown as they are, from `low` to `high`, as a probed value needs it.
    is_scaled: u32,
    low: f32,
    high: f32,
}

@group(0) @binding(0) var<storage, read> development: Development;
@group(0) @binding(1) var<storage, read> colors: array<f32>;
@group(0) @binding(2) var<storage, read_write> bytes: array<u32>;

// Returns the byte of a channel, as cpu/src/image/quantize.rs defines it, but in f32.
fn byte_of(sum: f32) -> u32 {
    if development.is_scaled != 0u {
        return u32(255.0 * clamp((sum - development.low) / (development.high - development.low), 0.0, 1.0));
    }
    let mean = clamp(sum / f32(development.samples), 0.0, 1.0);
    return u32(floor(255.0 * pow(mean, 1.0 / development.gamma)));
}

@compute @workgroup_size(64)
fn develop(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= development.pixel_count {
        return;
    }
    let first = 3u * id.x;
    bytes[id.x] = byte_of(colors[first]) | (byte_of(colors[first + 1u]) << 8u) | (byte_of(colors[first + 2u]) << 16u)
        | (255u << 24u);
}
