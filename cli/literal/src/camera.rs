//! The size of the picture and the window of the camera (statement, sections 2.2 and 3.1).

use cpu::internals::{Camera, math::tangent::tangent};
use cpu::{Config, Size};

use crate::rules::Rules;

/// Returns width and height of the picture.
pub fn size(config: &Config, rules: &Rules) -> [u64; 2] {
    let [across, down] = config.aspect_ratio.map(|side| side as f64);
    let ratio = [across / down, (across / down).floor().max(1.0), down / across][rules.or("aspect", 0.0) as usize];
    let height = config.image_width as f64 / ratio;
    let height = [height.floor(), height.ceil(), height.round()][rules.or("height", 0.0) as usize];
    [config.image_width, height.max(1.0) as u64]
}

/// Returns the window of a picture of `size` pixels.
pub fn window(config: &Config, size: Size, rules: &Rules) -> Camera {
    let (position, north) = (config.camera_position, config.camera_north);
    let (width, height) = (size.width() as f64, size.height() as f64);
    let [across, down] = config.aspect_ratio.map(|side| side as f64);
    let focal = (position - config.camera_target) * rules.or("focal-sign", 1.0);
    let degrees = config.field_of_view;
    let fov = if rules.has("fov-degrees") { degrees } else { degrees * std::f64::consts::PI / 180.0 };
    let angle = fov / rules.or("fov-divisor", 2.0);
    // The correctly rounded tangent is only for the angles of a camera.
    let tangent = if angle < 1.57 { tangent(angle) } else { angle.tan() };
    let distance = if rules.has("focal-distance") { 1.0 } else { focal.length() };
    let window_height = rules.or("window-factor", 2.0) * tangent * distance;
    let ratio = [width / height, across / down, (width / height).floor()][rules.or("ratio", 0.0) as usize];
    let horizontal = [window_height, window_height / ratio];
    let vertical = [window_height * ratio, window_height];
    let [window_width, window_height] = if rules.has("fov-horizontal") { horizontal } else { vertical };
    let backward = if rules.has("focal-raw") { focal } else { focal.unit() };
    let right = north.cross(backward) * rules.or("cross-sign", 1.0);
    let u = if rules.has("u-raw") { right } else { right.unit() };
    let v = backward.cross(u);
    let horizontal = u * (window_width * rules.or("right-sign", 1.0));
    let vertical = v * (window_height * rules.or("down-sign", -1.0));
    let less = rules.or("less", 0.0);
    let (delta_x, delta_y) = (horizontal / (width - less), vertical / (height - less));
    let corner = position - focal * rules.or("origin-sign", 1.0) - (horizontal + vertical) * rules.or("corner", 0.5);
    let origin = corner + (delta_x + delta_y) * rules.or("origin-half", 0.5);
    Camera { position, origin: if rules.has("printed-q") { position } else { origin }, delta_x, delta_y }
}
