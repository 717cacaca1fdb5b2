// A picture of the value that a shader gives to `probe`. The image kernel sets `probed`, and this one stores it instead
// of the colour.
@compute @workgroup_size(64)
fn probe_image(@builtin(global_invocation_id) id: vec3<u32>) {
    image(id);
    if id.x < picture.pixel_count {
        pixels[id.x] = PackedVec3(real(probed.x), real(probed.y), real(probed.z));
    }
}
