// A picture in deterministic mode: one ray through the middle of each pixel; twin of `render_linear` in
// cpu/src/render.rs.

@compute @workgroup_size(64)
fn image(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= picture.pixel_count {
        return;
    }
    let pixel = picture.first_pixel + id.x;
    let row = real(pixel / picture.width);
    let column = real(pixel % picture.width);
    let offset = vec2<real>(picture.offset_x, picture.offset_y);
    trace_path(camera_ray(picture_camera(), row, column, offset), id.x);
    // The renderer reports an error for a pixel that still has the bits of an output that was not written.
    if closest_hit_gave_up {
        pixels[id.x] = vec3_store(vec3<real>(UNWRITTEN));
        paths[id.x].ended = 1u;
    }
}
