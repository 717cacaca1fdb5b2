//! Compares whole pictures with random numbers in WGSL with pictures in Rust: the small scenes, the repository's
//! scenes, and random scenes, in both conventions of the scatter vectors.
//!
//! `RENDER_ALL=1` renders the repository's scenes in full size, which tests/extensive does. By default those with many
//! objects or samples are smaller.

mod draws;

use gpu_check::difference::difference;
use gpu_check::sampled::streams::Streams;
use gpu_check::sampled::twin::means;
use gpu_check::sampled::{Convention, SampleRenderer, SampledRendering};
use gpu_check::{Picture, features_of};
use shaders::{Features, Library};
use test_support::everything;

use crate::common::{self, Accuracy};
use crate::sampled::{Pipelines, Tally, record};
use crate::scenes::{self, Case};

const RANDOM_SCENES: u64 = 100;
/// Limit on the number of samples times objects of one picture; see [`Case::within`].
const TESTS: usize = 15_000_000;
/// Limit for random scenes.
const RANDOM_TESTS: usize = 1_000_000;

/// Returns the scenes of `folder`; with at most `tests` tests of objects, unless everything is rendered.
fn in_folder(folder: &str, tests: usize) -> Vec<Case> {
    let cases = scenes::in_folder(folder);
    cases.into_iter().map(|case| if everything() { case } else { within(case, tests) }).collect()
}

/// Returns the case with fewer pixels if its samples times its objects are more than `tests`.
fn within(case: Case, tests: usize) -> Case {
    let samples = case.config.samples_per_pixel as usize;
    case.within(tests / samples)
}

/// Returns a random scene of [`scenes::random`] with 1 to 4 samples for each pixel, and with other seeds.
fn random(seed: u64) -> Case {
    let mut case = scenes::random(seed);
    case.config.samples_per_pixel = 1 + seed % 4;
    (case.config.ray_rng_seed, case.config.material_rng_seed) = (seed + 1, 2 * seed + 7);
    within(case, RANDOM_TESTS)
}

/// Returns all features, so that few pipelines have to be compiled.
fn all_features(case: &Case) -> Features {
    Features::all(case.config.max_depth as u32)
}

/// Compares pictures of `cases` in both conventions with the reference's. Fails if one differs, or if fewer samples
/// than `least` were compared.
#[track_caller]
fn check(library: &Library, cases: &[Case], features: impl Fn(&Case) -> Features, least: usize) {
    let gpu = common::gpu();
    let (mut tally, mut pipelines) = (Tally::default(), Pipelines::<f64>::new(&gpu, library));
    for case in cases {
        for convention in Convention::ALL {
            let recording = record(case, convention);
            tally.add(&case.name, &pipelines.render(case, &features(case), &recording), &recording);
        }
    }
    let Tally { pictures, pixels, samples, words, not_black, faults } = tally;
    println!("f64 with random numbers: {pictures} pictures, {pixels} pixels, {not_black} of them not black");
    println!("{samples} samples, {words} words of scatter vectors");
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    assert!(samples >= least, "{samples} samples are too few");
    assert!(words as usize > samples / 2 && not_black * 2 > pixels, "the pictures are all but empty");
}

#[test]
fn pictures_of_the_repositorys_scenes_are_the_references_to_the_bit() {
    let mut cases = in_folder("tests/cases", usize::MAX);
    assert_eq!(cases.len(), 16);
    cases.extend(in_folder("scenes", TESTS));
    assert!(cases.len() >= 22, "{}", cases.len());
    let own = |case: &Case| features_of(&case.config, &case.scene).expect("it is not deep");
    check(&Library::standard(), &cases, own, 1_000_000);
}

#[test]
fn pictures_of_random_and_edge_scenes_are_the_references_to_the_bit() {
    let edges = scenes::edges().into_iter().map(|case| within(case, RANDOM_TESTS));
    let random = (0..scenes::number_of_random(RANDOM_SCENES)).map(random);
    let cases: Vec<_> = random.chain(edges).chain([scenes::long_paths()]).collect();
    check(&Library::standard(), &cases, all_features, 800_000);
}

#[test]
fn pictures_in_the_hierarchy_are_the_references_to_the_bit() {
    let mut cases = in_folder("tests/cases", TESTS / 20);
    cases.extend(in_folder("scenes", TESTS / 20));
    cases.extend((0..RANDOM_SCENES / 5).map(random));
    check(&Library::standard().in_hierarchy(), &cases, all_features, 250_000);
}

#[test]
fn a_wrong_recording_is_noticed() {
    let gpu = common::gpu();
    let case = random(3);
    let features = features_of(&case.config, &case.scene).expect("it is not deep");
    let picture = Picture::<f64>::new(&case.config, &case.scene).expect("it is valid");
    let renderer = SampleRenderer::<f64>::new(&gpu, &Library::standard(), &features, &[]).expect("it is valid");
    let mut recording = record(&case, Convention::Statement);
    let sample = recording.words.iter().position(|count| *count >= 3).expect("a path hits a rough surface");
    recording.words[sample] -= 3;
    let rendering = renderer.render(&picture, &recording).expect("it is small");
    let (first, recorded, actual) = rendering.first_disagreeing.expect("it is noticed");
    assert_eq!((first, actual), (sample as u64, recorded + 3));
    assert!(difference(&rendering.pixels, &recording.means).differing > 0, "later paths start at wrong places");
}

#[test]
fn f32_pictures_are_near_the_reference_and_with_the_arithmetic_of_ieee_their_twins() {
    let gpu = common::gpu();
    let accuracy = common::accuracy(&gpu);
    let library = Library::standard();
    let mut pipelines = Pipelines::new(&gpu, &library);
    let (mut squares, mut pixels, mut samples, mut disagreeing) = (0.0, 0, 0, 0);
    let mut cases = in_folder("tests/cases", TESTS / 10);
    cases.extend(in_folder("scenes", TESTS / 10));
    cases.extend((0..20).map(random));
    for (case, convention) in cases.iter().flat_map(|case| Convention::ALL.map(|convention| (case, convention))) {
        let recording = record(case, convention);
        let rendering: SampledRendering<f32> = pipelines.render(case, &all_features(case), &recording);
        let picture = Picture::<f32>::new(&case.config, &case.scene).expect("it is valid");
        let twin = means(&picture, &recording, Streams::new(&recording), |_| ());
        let found = difference(&rendering.pixels, &twin);
        let is_equal = found.differing == 0 || accuracy == Accuracy::Wgsl;
        assert!(is_equal, "{}, {convention:?}: {found} from f32 in Rust", case.name);
        let rmse = difference(&rendering.pixels, &recording.means).rmse;
        squares += rmse * rmse * found.pixels as f64;
        pixels += found.pixels;
        samples += recording.words.len() as u64;
        disagreeing += rendering.disagreeing;
    }
    let rmse = (squares / pixels as f64).sqrt();
    println!(
        "f32 with random numbers: {pixels} pixels, RMSE {rmse:.1e}; {disagreeing} of {samples} paths take other words"
    );
    assert!(rmse > 0.0 && rmse < 0.02, "{rmse}");
    assert!(disagreeing * 30 < samples, "{disagreeing} of {samples}");
}
