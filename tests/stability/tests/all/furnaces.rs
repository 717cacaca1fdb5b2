//! Tests with scenes whose radiance is known without rendering, and with scenes that must give the picture of another
//! scene.

use cpu::reference::intersect::Exact;
use cpu::{Aos, Config, Image, Layout, Scatter, Scene};

type Pixels = <Aos as Layout>::Image;

fn render(config: &str, scene: &str, scatter: Scatter) -> Pixels {
    let config = Config::parse(config.as_bytes()).expect("the configuration is valid");
    let scene = Scene::parse(scene.as_bytes()).expect("the scene is valid");
    cpu::reference::render_with::<_, Exact>(&config, &scene, scatter).expect("it renders")
}

fn bytes(image: &Pixels) -> Vec<[u8; 3]> {
    let pixel = |index| image.pixel(index);
    (0..image.size().pixels()).map(pixel).map(|color| [color.red, color.green, color.blue]).collect()
}

const WHITE: &str = "background_dark_color: 1 1 1\nbackground_light_color: 1 1 1\n";

#[test]
fn white_objects_under_a_white_sky_cannot_be_seen() {
    // A ray that wrongly hits its own surface again would reach the maximum depth and be black. The ground is as large
    // as the earth.
    let config = format!(
        "{WHITE}image_width: 60\naspect_ratio: 1 1\ncamera_position: 0 1 -6\ncamera_target: 0 0.5 0\n\
         field_of_view: 60\nsamples_per_pixel: 8\nmax_depth: 200\n"
    );
    let scene = "matte: white 1 1 1\nmetal: mirror 1 1 1 0.5\nsphere: 0 -6371000 0 6371000 white\n\
        sphere: 0 0.75 0 0.7 white\nsphere: 1.5 0.5 0.5 0.4 mirror\ncylinder: -1.5 1 0 0.4 0.5 1 0 white\n";
    let image = render(&config, scene, Scatter::Published);
    let dark = bytes(&image).into_iter().filter(|&pixel| pixel != [255; 3]).count();
    assert_eq!(dark, 0, "pixels of {} have lost light", image.size().pixels());
}

#[test]
fn no_light_leaks_into_a_closed_room() {
    // All rays start inside and none may leave, so no ray hits the background. Near its rim a cylinder has hits below
    // the least lambda, which the specification ignores. The cylinder is so large that no ray starts there.
    for (room, radius) in
        [("sphere: 0 0 0 5", 5.0), ("sphere: 0 0 0 5e5", 5e5), ("cylinder: 0 0 0 5e5 3e5 4e5 5e5", 5e5)]
    {
        let config = format!(
            "{WHITE}image_width: 40\naspect_ratio: 1 1\ncamera_position: 0 0 {}\nfield_of_view: 120\n\
             samples_per_pixel: 4\nmax_depth: 20\n",
            -radius / 4.0
        );
        let scene = format!("matte: white 1 1 1\n{room} white\n");
        let image = render(&config, &scene, Scatter::Published);
        let lit = bytes(&image).into_iter().filter(|&pixel| pixel != [0; 3]).count();
        assert_eq!(lit, 0, "{room}: pixels of {} see the sky", image.size().pixels());
    }
}

#[test]
fn the_furnace_tells_when_light_is_lost() {
    // Controls for the two tests above: a grey object under the white background is visible, and light comes in if the
    // room is not closed.
    let config = format!("{WHITE}image_width: 20\naspect_ratio: 1 1\ncamera_position: 0 0 -3\nsamples_per_pixel: 2\n");
    let grey = render(&config, "matte: grey .9 .9 .9\nsphere: 0 0 0 1 grey\n", Scatter::Published);
    assert!(bytes(&grey).into_iter().any(|pixel| pixel != [255; 3]));
    let open = render(&config, "matte: white 1 1 1\nsphere: 0 0 9 1 white\n", Scatter::Published);
    assert!(bytes(&open).into_iter().any(|pixel| pixel != [0; 3]));
}

/// Returns a configuration and a scene of spheres, with all lengths multiplied by `scale`, a power of two.
fn scaled(scale: f64) -> (String, String) {
    let place = |[x, y, z]: [f64; 3]| format!("{} {} {}", x * scale, y * scale, z * scale);
    let config = format!(
        "image_width: 80\naspect_ratio: 1 1\ncamera_position: {}\ncamera_target: {}\nfield_of_view: 60\n\
         samples_per_pixel: 4\nmax_depth: 8\n",
        place([0.0, 1.0, -6.0]),
        place([0.0, 0.5, 0.0])
    );
    let mut scene = String::from("matte: grey .5 .6 .7\nmetal: mirror .9 .8 .7 .1\nrefractive: glass 1.5\n");
    for (center, radius, material) in [
        ([0.0, -100.5, 0.0], 100.0, "grey"),
        ([0.0, 0.75, 0.0], 1.0, "glass"),
        ([2.25, 0.5, 0.5], 0.75, "mirror"),
        ([-2.0, 0.25, 0.5], 0.5, "grey"),
    ] {
        scene += &format!("sphere: {} {} {material}\n", place(center), radius * scale);
    }
    (config, scene)
}

#[test]
fn a_scene_of_spheres_looks_the_same_at_every_scale() {
    // Every quantity scales exactly, except the least lambda. No hit in the scene is so near.
    let (config, scene) = scaled(1.0);
    let original = bytes(&render(&config, &scene, Scatter::Statement));
    assert!(original.iter().any(|&pixel| pixel != original[0]), "there is something to see");
    for power in [1, 4, 12, 20] {
        let (config, scene) = scaled(2.0_f64.powi(power));
        let larger = bytes(&render(&config, &scene, Scatter::Statement));
        let parted = original.iter().zip(&larger).filter(|(one, other)| one != other).count();
        assert_eq!(parted, 0, "pixels of {} part, scaled by 2^{power}", original.len());
    }
}
