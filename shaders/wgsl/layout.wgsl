// The layout of the buffers. Every structure here has only scalar fields, so that it has no padding in f32 or in f64.
// The comment above a structure names the Rust type that has the same bytes; twin::packed writes them.

// cpu::Vec3<T>
struct PackedVec3 {
    x: real,
    y: real,
    z: real,
}

fn vec3_load(v: PackedVec3) -> vec3<real> {
    return vec3<real>(v.x, v.y, v.z);
}

fn vec3_store(v: vec3<real>) -> PackedVec3 {
    return PackedVec3(v.x, v.y, v.z);
}

// cpu::Ray<T>
struct PackedRay {
    origin: PackedVec3,
    direction: PackedVec3,
}

fn ray_load(ray: PackedRay) -> Ray {
    return Ray(vec3_load(ray.origin), vec3_load(ray.direction));
}

fn ray_store(ray: Ray) -> PackedRay {
    return PackedRay(vec3_store(ray.origin), vec3_store(ray.direction));
}

// gpu_check::sampled::TracedSample<T>: the linear colour of a sample, and the number of words that its path took from
// the stream of scatter vectors. `unused` makes the size a multiple of 8 bytes, as f64 needs it.
struct TracedSample {
    color: PackedVec3,
    words: u32,
    unused: u32,
}
