//! Tests that the parsers read any bytes without a panic, and read back what the writers of `test_support` write.

use std::cell::Cell;

use cpu::{Config, Error, Scene};
use generator::write;
use generator::{self, Arrangement, Options};
use proptest::prelude::*;

use crate::runner::check;

/// Returns random tokens that occur in valid and nearly valid lines.
fn token() -> impl Strategy<Value = Vec<u8>> {
    let keys = prop::sample::select(vec![
        "aspect_ratio:",
        "image_width:",
        "gamma:",
        "camera_position:",
        "camera_target:",
        "field_of_view:",
        "samples_per_pixel:",
        "max_depth:",
        "ray_rng_seed:",
        "background_dark_color:",
        "matte:",
        "metal:",
        "refractive:",
        "sphere:",
        "cylinder:",
    ]);
    let values = prop::sample::select(vec![
        "0",
        "1",
        ".5",
        "-1",
        "1e-3",
        "2.",
        "+4",
        "1e999",
        "nan",
        "inf",
        "0x1",
        "1.5x",
        "",
        "a",
        "b",
        "99999999999999999999",
        "--1",
        "1e",
        "\u{e9}",
        "1\0",
    ]);
    let text = |text: &str| text.as_bytes().to_vec();
    prop_oneof![2 => keys.prop_map(text), 8 => values.prop_map(text), 1 => prop::collection::vec(any::<u8>(), 0..4)]
}

/// Returns random lines of such tokens, separated by different blanks and line ends.
fn lines() -> impl Strategy<Value = Vec<u8>> {
    let blank = prop::sample::select(vec![" ", "  ", "\t", "\n", "\r\n", "\n\n", " \t"]);
    prop::collection::vec((token(), blank), 0..30).prop_map(|parts| {
        parts.into_iter().flat_map(|(token, blank)| [token, blank.as_bytes().to_vec()].concat()).collect()
    })
}

/// Checks that a value is within the ranges of the specification, sections 3.1 and 4.1, or that an error has a message.
/// Returns true for a value.
fn sound<T>(result: Result<T, Error>, is_sound: impl Fn(&T) -> bool) -> Result<bool, TestCaseError> {
    match result {
        Ok(value) => {
            prop_assert!(is_sound(&value));
            Ok(true)
        }
        Err(error) => {
            prop_assert!(!error.message().is_empty() && !error.to_string().is_empty());
            Ok(false)
        }
    }
}

fn config_is_sound(config: &Config) -> bool {
    config.image_width > 0
        && config.gamma > 0.0
        && config.field_of_view > 0.0
        && config.field_of_view < 180.0
        && config.samples_per_pixel > 0
        && config.max_depth > 0
        && config.camera_position.is_finite()
}

fn scene_is_sound(scene: &Scene) -> bool {
    scene.objects.iter().all(|object| (object.material as usize) < scene.materials.len())
}

#[test]
fn any_bytes_are_read_or_refused() {
    check(20_000, prop::collection::vec(any::<u8>(), 0..200), |bytes| {
        sound(Config::parse(&bytes[..]), config_is_sound)?;
        sound(Scene::parse(&bytes[..]), scene_is_sound)?;
        Ok(())
    });
}

#[test]
fn nearly_valid_lines_are_read_or_refused() {
    let (read, refused) = (Cell::new(0), Cell::new(0));
    check(50_000, lines(), |bytes| {
        for accepted in
            [sound(Config::parse(&bytes[..]), config_is_sound)?, sound(Scene::parse(&bytes[..]), scene_is_sound)?]
        {
            let count = if accepted { &read } else { &refused };
            count.set(count.get() + 1);
        }
        Ok(())
    });
    let (read, refused) = (read.get(), refused.get());
    assert!(read > 0 && refused > 0, "{read} read, {refused} refused");
}

#[test]
fn valid_lines_with_one_byte_changed_are_read_or_refused() {
    let text = write::scene(&generator::scene(&Options { objects: 3, ..Options::default() })).into_bytes();
    let length = text.len();
    let (read, refused) = (Cell::new(0), Cell::new(0));
    check(20_000, (0..length, any::<u8>()), |(place, byte)| {
        let mut text = text.clone();
        text[place] = byte;
        let count = if sound(Scene::parse(&text[..]), scene_is_sound)? { &read } else { &refused };
        count.set(count.get() + 1);
        Ok(())
    });
    let (read, refused) = (read.get(), refused.get());
    assert!(read > 0 && refused > 0, "{read} read, {refused} refused");
}

#[test]
fn what_is_written_reads_back_as_it_was() {
    let arrangement = prop_oneof![Just(Arrangement::Degenerate), Just(Arrangement::Scattered), Just(Arrangement::Grid)];
    let options =
        (any::<u64>(), 0..200_usize, -4..=5_i32, arrangement).prop_map(|(seed, objects, scale, arrangement)| {
            let extent = format!("1e{scale}").parse().expect("it is a number");
            Options { seed, objects, extent, arrangement, ..Options::default() }
        });
    let objects = Cell::new(0);
    check(500, options, |options| {
        let (config, scene) = (generator::view(&options), generator::scene(&options));
        prop_assert_eq!(Config::parse(write::config(&config).as_bytes()).ok(), Some(config));
        prop_assert_eq!(Scene::parse(write::scene(&scene).as_bytes()).ok(), Some(scene.clone()));
        objects.set(objects.get() + scene.objects.len());
        Ok(())
    });
    assert!(objects.get() > 0);
}
