//! Tests values that are read, default values, and every fault of a value.

use crate::input::config::*;

fn parse(text: &str) -> Result<Config, Error> {
    Config::parse(text.as_bytes())
}

fn message(text: &str) -> String {
    parse(text).expect_err("the text is invalid").to_string()
}

#[test]
fn an_empty_file_gives_the_defaults() {
    let config = parse("\n \t\r\n").expect("blank lines are ignored");
    assert_eq!(config, Config::default());
    assert_eq!((config.image_width, config.aspect_ratio, config.gamma), (1920, [16, 9], 2.2));
    assert_eq!((config.samples_per_pixel, config.max_depth), (20, 5));
    assert_eq!((config.material_rng_seed, config.ray_rng_seed), (13, 19));
}

#[test]
fn every_key_is_read() {
    let config = parse(
        "\taspect_ratio:\t4 3\r\nimage_width: 10\ngamma: 1.5 \ncamera_position: 1 2 3\ncamera_target: 4 5 6\n\
             camera_north: 0 0 1\nfield_of_view: 20\nsamples_per_pixel: 7\nmax_depth: 8\nmaterial_rng_seed: 9\n\
             ray_rng_seed: 11\nbackground_dark_color: 0 .5 1\nbackground_light_color: 1 1 0",
    )
    .expect("all lines are valid");
    let expected = Config {
        aspect_ratio: [4, 3],
        image_width: 10,
        gamma: 1.5,
        camera_position: Vec3::new(1.0, 2.0, 3.0),
        camera_target: Vec3::new(4.0, 5.0, 6.0),
        camera_north: Vec3::new(0.0, 0.0, 1.0),
        field_of_view: 20.0,
        samples_per_pixel: 7,
        max_depth: 8,
        material_rng_seed: 9,
        ray_rng_seed: 11,
        background_dark_color: Vec3::new(0.0, 0.5, 1.0),
        background_light_color: Vec3::new(1.0, 1.0, 0.0),
    };
    assert_eq!(config, expected);
}

#[test]
fn the_last_of_a_repeated_key_counts() {
    assert_eq!(parse("gamma: 1.8\nimage_width: 900\ngamma: 2.5").map(|config| config.gamma).ok(), Some(2.5));
}

#[test]
fn unknown_keys_are_named() {
    assert_eq!(message("image_xwidth: 3"), "Unknown configuration key: [image_xwidth:]");
    assert_eq!(message("width 3"), "Unknown configuration key: [width:]");
    assert_eq!(message("gamma 2"), "Unknown configuration key: [gamma:]");
    assert_eq!(message("gamma:2"), "Unknown configuration key: [gamma:2:]");
}

#[test]
fn invalid_values_show_their_line() {
    let cases = [
        "aspect_ratio: nulo",
        "aspect_ratio: 16",
        "aspect_ratio: 0 9",
        "image_width: -4",
        "image_width: 1.5",
        "gamma: 0",
        "gamma: 2.2x",
        "gamma: nan",
        "camera_position: 500 500",
        "camera_north: 1e999 0 0",
        "field_of_view: 0",
        "field_of_view: 180",
        "samples_per_pixel: 0",
        "max_depth: -1",
        "material_rng_seed: 0",
        "ray_rng_seed: 18446744073709551616",
        "background_dark_color: 0 0 1.01",
        "background_light_color: -0.1 0 0",
        "gamma:",
        "gamma: x 9",
    ];
    for line in cases {
        let key = line.split(' ').next().expect("split yields at least one part");
        assert_eq!(message(line), format!("Invalid value for key: [{key}]\nLine: \"{line}\""));
    }
    assert_eq!(message("\tgamma: a \r\n"), "Invalid value for key: [gamma:]\nLine: \"\tgamma: a \"");
}

#[test]
fn extra_data_is_shown_trimmed() {
    let expected = "Extra data after configuration value for key: [gamma:]\nExtra: \"2.2 99\"";
    assert_eq!(message("gamma: 2.1   2.2 99 \t"), expected);
}

#[test]
fn height_is_the_floor_of_width_over_the_ratio_and_at_least_one() {
    let size = |width, aspect_ratio| {
        let config = Config { image_width: width, aspect_ratio, ..Config::default() };
        config.image_size().map(|size| (size.width(), size.height()))
    };
    assert_eq!(size(1800, [16, 9]), Ok((1800, 1012)));
    assert_eq!(size(600, [1, 1]), Ok((600, 600)));
    assert_eq!(size(2, [9, 1]), Ok((2, 1)));
    assert!(matches!(size(1 << 20, [1, 1 << 40]), Err(Picture::TooLarge { .. })));
    assert!(matches!(size(u64::MAX, [1, 1]), Err(Picture::TooLarge { .. })));
}

#[test]
fn a_missing_file_is_named() {
    let error = Config::read(Path::new("/nowhere/config.txt")).expect_err("the file does not exist");
    assert!(error.to_string().starts_with("Cannot read file [/nowhere/config.txt]: "), "{error}");
}
