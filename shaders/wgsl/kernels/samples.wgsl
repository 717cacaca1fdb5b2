// A part of a picture with random numbers: each invocation traces one sample.

@compute @workgroup_size(64)
fn samples(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= picture.sample_count {
        return;
    }
    trace_sample(id.x);
    // The renderer reports an error for a sample that still has the bits of an output that was not written.
    if closest_hit_gave_up {
        traced_samples[id.x].color = vec3_store(vec3<real>(UNWRITTEN));
        sample_paths[id.x].ended = 1u;
    }
}
