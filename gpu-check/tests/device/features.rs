//! Tests that a pipeline specialised to its scene gives the bits of the general pipeline, and prints the times of both.

use std::time::Duration;

use gpu_check::difference::difference;
use gpu_check::{Float, Gpu, Picture, Renderer, features_of};
use shaders::{Features, Library};

use crate::common;
use crate::scenes::{self, Case};

/// Number of random scenes that are compared, in addition to the repository's scenes and the edge cases.
const RANDOM_SCENES: u64 = 12;
/// Limit on the number of pixels times objects of one picture; see [`Case::within`].
const TESTS: usize = 1_000_000;

fn render<T: Float>(gpu: &Gpu, case: &Case, features: &Features) -> (Vec<cpu::Vec3<T>>, Duration) {
    let rendering = Renderer::<T>::new(gpu, &Library::standard(), features, &[]).and_then(|renderer| {
        let picture = Picture::new(&case.config, &case.scene)?;
        // The first rendering is not measured.
        renderer.render(&picture)?;
        renderer.render(&picture)
    });
    let rendering = rendering.unwrap_or_else(|error| panic!("{}: {error}", case.name));
    (rendering.pixels, rendering.time)
}

fn specialised_pipelines_give_the_same_bits<T: Float>(gpu: &Gpu) {
    let mut cases = scenes::in_folder("tests/cases");
    cases.extend(scenes::edges());
    cases.extend((0..RANDOM_SCENES).map(scenes::random));
    cases.extend([
        crowd("200 matte spheres", "sphere: X Y 0 .4 m\n"),
        crowd("200 metal cylinders", "cylinder: X Y 0 .3 .2 .6 .1 n\n"),
        crowd("200 glass spheres", "sphere: X Y 0 .4 o\n"),
    ]);
    let (mut pixels, mut specialised) = (0, 0);
    for case in cases.into_iter().map(|case| case.within(TESTS)) {
        let features = features_of(&case.config, &case.scene).unwrap_or_else(|error| panic!("{error}"));
        let all = Features::all(features.max_depth);
        let ((own, own_time), (general, general_time)) =
            (render::<T>(gpu, &case, &features), render::<T>(gpu, &case, &all));
        let found = difference(&own, &general);
        assert_eq!(found.differing, 0, "{}: {found}", case.name);
        println!("{} {}: {own_time:?} specialised, {general_time:?} general", T::PRECISION, case.name);
        pixels += found.pixels;
        specialised += usize::from(features != all);
    }
    println!("{}: {pixels} pixels compared, {specialised} scenes with a feature off", T::PRECISION);
    assert!(pixels > 50_000 && specialised >= 10);
}

#[test]
fn specialised_pipelines_give_the_bits_of_general_ones_in_f64() {
    specialised_pipelines_give_the_same_bits::<f64>(&common::gpu());
}

#[test]
fn specialised_pipelines_give_the_bits_of_general_ones_in_f32() {
    specialised_pipelines_give_the_same_bits::<f32>(&common::gpu());
}

/// Returns a scene of 200 objects of one shape and one material, for which the code of other shapes and materials costs
/// most.
fn crowd(name: &str, line: &str) -> Case {
    let mut text = "matte: m .8 .8 .8\nmetal: n .9 .9 .9 0\nrefractive: o 1.5\n".to_owned();
    for number in 0..200 {
        let (x, y) = (number % 20 - 10, number / 20 - 5);
        text.push_str(&line.replace("X", &x.to_string()).replace("Y", &y.to_string()));
    }
    let config = cpu::Config {
        image_width: 100,
        aspect_ratio: [1, 1],
        max_depth: 10,
        ..cpu::internals::input::config::Config::default()
    };
    Case {
        name: name.to_owned(),
        config,
        scene: cpu::internals::input::scene::Scene::parse(text.as_bytes()).expect("it is valid"),
    }
}
