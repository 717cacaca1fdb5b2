// A part of a picture with random numbers: each invocation traces one sample.

@compute @workgroup_size(64)
fn samples(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= picture.sample_count {
        return;
    }
    trace_sample(id.x);
}
