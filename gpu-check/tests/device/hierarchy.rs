//! Compares the hierarchy in WGSL with the loop over all objects: random rays must have equal hits. Pictures with
//! random numbers in the hierarchy are compared in `samples`.
//!
//! `RENDER_ALL=1` compares more rays, and renders a million objects, which tests/extensive does.
//! `RENDER_CASES` sets the number of random rays.

mod large;
pub mod random;

use gpu_check::closest_hits::closest_hits;
use gpu_check::steps::{Follower, first_difference};
use gpu_check::{Float, Gpu, Picture, features_of};
use shaders::Library;
use stability::random::Random;
use test_support::{everything, number_of};

use crate::common::{self, Accuracy};
use crate::pictures::prepared;
use crate::scenes;

/// Number of random rays, and their number if everything is compared, unless the variable sets another one.
const RAYS: usize = 1 << 17;
const ALL_RAYS: usize = 1 << 20;
/// Number of rays in each random scene.
const RAYS_OF_A_SCENE: usize = 1 << 14;

fn rays_have_the_same_hits<T: Float>() {
    let gpu = common::gpu();
    let usual = if everything() { ALL_RAYS } else { RAYS };
    let count = number_of("RENDER_CASES").map_or(usual, |count| count as usize);
    let mut draws = Random::new(30);
    let (mut hits, mut done) = (0, 0);
    for number in 0..count.div_ceil(RAYS_OF_A_SCENE) {
        let (picture, rays) = random::rays::<T>(&mut draws, number, RAYS_OF_A_SCENE);
        let find =
            |library: &Library| closest_hits(&gpu, library, &picture, &rays).unwrap_or_else(|error| panic!("{error}"));
        let (expected, actual) = (find(&Library::standard()), find(&Library::standard().in_hierarchy()));
        for ((ray, expected), actual) in rays.iter().zip(&expected).zip(&actual) {
            let same = expected.iter().zip(actual).all(|(expected, actual)| expected.same(*actual));
            assert!(same, "{ray:?} in scene {number}: {expected:?} of all objects, {actual:?} in the hierarchy");
        }
        hits += expected.iter().filter(|hit| hit[1].wide() >= 0.0).count();
        done += rays.len();
    }
    println!("{}: {done} rays, {hits} hits, 0 differ", T::PRECISION);
    assert!(hits * 2 > done, "{hits} of {done}");
}

#[test]
fn random_rays_have_the_hits_of_the_loop_over_all_objects_in_both_precisions() {
    rays_have_the_same_hits::<f64>();
    rays_have_the_same_hits::<f32>();
}

fn steps_are_those_of_rust<T: Float>(gpu: &Gpu) {
    let (mut compared, mut hits) = (0, 0);
    for case in [large::ten_thousand(16), scenes::long_paths(), scenes::random(3), scenes::random(8)] {
        let picture = Picture::<T>::new(&case.config, &case.scene).expect("it is valid");
        let features = features_of(&case.config, &case.scene).expect("it is valid");
        let expected: Vec<_> = (0..100).map(|index| picture.steps(index)).collect();
        for library in [Library::standard(), Library::standard().in_hierarchy()] {
            let follower = Follower::<T>::new(gpu, &library, &features, &[]).expect("it compiles");
            let actual = follower.follow(&picture, 0, expected.len()).expect("it is small");
            for (one, other) in expected.concat().iter().zip(actual.concat()) {
                assert_eq!(first_difference(one, &other), None, "{}", case.name);
                compared += 1;
                hits += usize::from(one.is_hit().wide() == 1.0);
            }
        }
    }
    println!("{}: {compared} steps, {hits} hits", T::PRECISION);
    assert!(hits > 500, "{hits}");
}

#[test]
fn steps_of_paths_are_those_of_rust() {
    let gpu = common::gpu();
    steps_are_those_of_rust::<f64>(&gpu);
    if common::accuracy(&gpu) == Accuracy::Ieee {
        steps_are_those_of_rust::<f32>(&gpu);
    }
}

#[test]
fn a_ray_that_visits_too_many_nodes_is_an_error_and_not_a_wrong_colour() {
    let gpu = common::gpu();
    let mut library = Library::standard().in_hierarchy();
    let source = library.source("hierarchy").expect("it exists");
    assert_eq!(source.matches("MOST_VISITS: u32 = 60000u").count(), 1);
    let source = source.replace("MOST_VISITS: u32 = 60000u", "MOST_VISITS: u32 = 20u");
    library.replace("hierarchy", "few.wgsl", source).expect("it exists");
    let (renderer, picture) = prepared::<f64>(&gpu, &library, &large::ten_thousand(16)).expect("it compiles");
    let error = renderer.render(&picture).expect_err("20 nodes are too few");
    assert!(error.to_string().contains("did not write"), "{error}");
}
