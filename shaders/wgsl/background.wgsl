// The colour of a ray that hits no object: a gradient along y; twin of cpu/src/render/background.rs.

// Background: the two ends of the gradient, as linear colours: `dark` along +y and `light` along -y.
struct Background {
    dark: vec3<real>,
    light: vec3<real>,
}

// Background::color: returns `(1 - m) light + m dark` with `m = (unit(direction).y + 1) / 2`.
fn background_color(background: Background, direction: vec3<real>) -> vec3<real> {
    let m = (direction.y / vec3_length(direction) + real(1.0)) / real(2.0);
    return background.light * (real(1.0) - m) + background.dark * m;
}
