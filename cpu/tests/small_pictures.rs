//! Pictures of a few pixels, one for each search and stage: with every instruction set that there is and in both
//! layouts the reference's pixels.
//!
//! The properties in the package `tests` try the same on thousands of random scenes. These are so small that miri,
//! which interprets every instruction, is done with them in minutes (`tests/memory.sh miri`).

use std::ops::RangeInclusive;

use cpu::internals::Prepared;
use cpu::internals::accel::choice::Accel;
use cpu::{Aos, Config, Scatter, Scene};
use test_support::agreement::{equals_reference, reference};

const MATERIALS: &str = "matte: m .8 .7 .6\nmetal: s .9 .8 .7 .4\nrefractive: g 1.5\n";

/// A board of `count` objects, one after the other a sphere and a cylinder, of one material after the other.
fn board(count: usize) -> String {
    let object = |at: usize| {
        let (x, y) = ((at % 12) as f64 * 0.5 - 2.75, ((at / 12) as f64 - (count / 24) as f64) * 0.5);
        let (z, material) = ((at % 5) as f64 * 0.3, ["m", "s", "g"][at % 3]);
        match at % 2 {
            0 => format!("sphere: {x} {y} {z} .23 {material}\n"),
            _ => format!("cylinder: {x} {y} {z} .1 .1 .4 .2 {material}\n"),
        }
    };
    (0..count).map(object).collect()
}

/// The picture of `objects`, with the materials m, s and g, which must be seen in as many pixels as `seen` says, of 15,
/// and be searched as the test's name says.
fn check(objects: &str, seen: RangeInclusive<usize>, is_searched_so: fn(&Accel) -> bool) {
    let config = "image_width: 5\naspect_ratio: 5 3\nsamples_per_pixel: 3\nmax_depth: 6\nfield_of_view: 40\ncamera_position: .3 .2 -6\n";
    let config = Config::parse(config.as_bytes()).expect("the configuration is valid");
    let scene = Scene::parse(format!("{MATERIALS}{objects}").as_bytes()).expect("the scene is valid");
    let picture =
        equals_reference(&config, &scene, Scatter::Statement).unwrap_or_else(|difference| panic!("{difference}"));
    let means = picture.expect("the picture is small").means;
    let nothing = Scene::parse(MATERIALS.as_bytes()).expect("the scene is valid");
    let nothing = reference(&config, &nothing, Scatter::Statement).expect("the picture is small").means;
    let differing = (0..means.len()).filter(|&at| means[at] != nothing[at]).count();
    assert!(seen.contains(&differing), "the objects are in {differing} pixels");
    let prepared = Prepared::<Aos>::new(&config, &scene, Scatter::Statement).expect("the camera is sound");
    assert!(is_searched_so(&prepared.search), "{:?}", prepared.search);
}

#[test]
fn a_background_alone() {
    check("", 0..=0, |search| matches!(search, Accel::SmallScene(_)));
}

#[test]
fn two_objects_whose_samples_are_tried_ahead() {
    check(
        "sphere: 0 -102 0 100 s\ncylinder: 0 0 0 1.5 .5 3 0 m\n",
        6..=15,
        |search| matches!(search, Accel::SmallScene(few) if !few.uses_object_lanes()),
    );
}

#[test]
fn a_handful_asked_side_by_side_with_glass_among_them() {
    check(
        "sphere: 0 0 0 2 g\nsphere: 0 2 0 1 s\nsphere: 0 -2 0 1 m\ncylinder: 1 0 -1 .5 1 1 .2 g\nsphere: 2 0 0 .5 s\n",
        6..=15,
        |search| matches!(search, Accel::SmallScene(few) if few.uses_object_lanes()),
    );
}

#[test]
fn objects_behind_a_filter_over_a_ground() {
    check(&format!("sphere: 0 -101 0 100 s\n{}", board(20)), 6..=15, |search| matches!(search, Accel::FlatFilter(_)));
}

#[test]
fn objects_in_a_tree_over_a_ground() {
    check(&format!("sphere: 0 -101 0 100 m\n{}", board(132)), 12..=15, |search| matches!(search, Accel::Bvh(_)));
}

#[test]
#[cfg_attr(miri, ignore = "exact arithmetic takes too long there")]
fn objects_too_far_apart_for_any_filter() {
    check("sphere: 0 0 0 2 s\nsphere: 1e160 0 0 1 m\nsphere: 1 1 0 1 g\n", 4..=15, |search| {
        matches!(search, Accel::EveryObject)
    });
}
