// module: kernels/image
//
// The line above says which module of shaders/wgsl this file stands in for: here the picture itself, one pixel an
// invocation. Copy any other file from there and change it, and the rest stays as it is. `real` is f64, or f32 with
// --f32. Run
//
//     cargo run -p gpu-check --bin shader-lab -- THIS_FILE --config CONFIG --scene SCENE --out OUT.png --watch
//
// and save this file as often as you like.

// The colour of a surface whose unit normal is `n`. Change this: swap components, or make it one colour.
fn my_color(n: vec3<real>) -> vec3<real> {
    return n * real(0.5) + vec3<real>(real(0.5));
}

@compute @workgroup_size(64)
fn image(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= picture.pixel_count {
        return;
    }
    // Which pixel, and the ray through its middle.
    let pixel = picture.first_pixel + id.x;
    let row = real(pixel / picture.width);
    let column = real(pixel % picture.width);
    let ray = camera_ray(picture_camera(), row, column, vec2<real>(picture.offset_x, picture.offset_y));

    // What it meets: `surface.hit` has the point, the normal that faces the ray, and whether the ray comes from
    // outside.
    let surface = closest_hit(ray);
    if surface.some {
        pixels[id.x] = vec3_store(my_color(vec3_unit(surface.hit.normal)));
    } else {
        pixels[id.x] = vec3_store(background_color(picture_background(), ray.direction));
    }
}
