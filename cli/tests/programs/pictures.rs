//! Tests of pictures of unusual configurations and scenes. Pictures with a digest are in `digests.rs`.

use test_support::p3::{self, Picture};

use crate::bench::{Bench, SMALL};

fn render(config: &str, scene: &str) -> Picture {
    p3::read(&Bench::new(config, scene).render()).expect("the picture is well formed")
}

/// A scene with a sphere that fills the view of a camera at (0, 0, -10) with a narrow field of view.
const WALL: &str = "matte: grey .5 .5 .5\nsphere: 0 0 50 49 grey\n";

#[test]
fn an_empty_scene_is_its_background() {
    let uniform = "background_dark_color: 1 0 .25\nbackground_light_color: 1 0 .25\ngamma: 1\n";
    for scene in ["", "\n\n", " \t\r\n"] {
        let picture = render(&format!("{SMALL}{uniform}"), scene);
        assert_eq!((picture.width, picture.height), (8, 4));
        assert!(picture.pixels.iter().all(|&pixel| pixel == [255, 0, 63]), "{picture:?}");
    }
}

#[test]
fn the_defaults_make_a_picture_of_1920_by_1080() {
    let picture = render("samples_per_pixel: 1\n", "");
    assert_eq!((picture.width, picture.height), (1920, 1080));
    let (top, bottom) = (picture.pixels[0], picture.pixels[1920 * 1079]);
    assert!(top[0] < bottom[0], "the dark colour is above: {top:?}, {bottom:?}");
}

#[test]
fn at_depth_one_every_object_is_black() {
    let picture = render(&format!("{SMALL}max_depth: 1\nfield_of_view: 20\n"), WALL);
    assert!(picture.pixels.iter().all(|&pixel| pixel == [0, 0, 0]), "{picture:?}");
    let picture = render(&format!("{SMALL}max_depth: 2\nfield_of_view: 20\n"), WALL);
    assert!(picture.pixels.iter().any(|&pixel| pixel != [0, 0, 0]), "{picture:?}");
}

#[test]
fn unused_materials_change_nothing() {
    let unused = "metal: a 1 1 1 1\nrefractive: b 2\nmatte: c 0 0 0\n";
    let config = format!("{SMALL}field_of_view: 40\n");
    assert_eq!(render(&config, &format!("{unused}{WALL}")), render(&config, WALL));
}

#[test]
fn seeds_may_be_as_large_as_64_bits_hold() {
    let config = |seed: u64| format!("{SMALL}field_of_view: 20\nmaterial_rng_seed: {seed}\nray_rng_seed: {seed}\n");
    assert_ne!(render(&config(u64::MAX), WALL), render(&config(1), WALL));
}

#[test]
fn a_great_depth_and_many_samples_do_not_overflow_anything() {
    // The camera is inside a mirror, so every path ends only at the maximum depth.
    let scene = "metal: mirror 1 1 1 0\nsphere: 0 0 0 20 mirror\n";
    let config = "image_width: 1\naspect_ratio: 1 1\nsamples_per_pixel: 3\nmax_depth: 300000\n";
    assert_eq!(render(config, scene).pixels, [[0, 0, 0]]);
}
