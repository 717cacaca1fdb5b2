// The rays through the projection window's pixels; twin of cpu/src/geometry/camera.rs.
//
// The CPU computes the window, because that needs a tangent, and the tangent of a driver is not exact.

// Camera: the point where all camera rays start, the middle of the top left pixel, and the steps to the next pixels to
// the right and below.
struct Camera {
    position: vec3<real>,
    origin: vec3<real>,
    delta_x: vec3<real>,
    delta_y: vec3<real>,
}

// Camera::ray: returns the ray through the point `offset` pixels from the middle of pixel (`row`, `column`).
fn camera_ray(camera: Camera, row: real, column: real, offset: vec2<real>) -> Ray {
    let x = offset.x;
    let y = offset.y;
    let window_point = camera.origin + camera.delta_x * (column + x) + camera.delta_y * (row + y);
    return Ray(camera.position, window_point - camera.position);
}
