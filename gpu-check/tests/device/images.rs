//! Compares whole pictures in WGSL with pictures in Rust, in deterministic mode: every scene of the repository, random
//! scenes, and edge cases.

use cpu::{Config, Vec3};
use generator::cameras::hard_camera;
use gpu_check::difference::difference;
use gpu_check::{Picture, Renderer, features_of};
use shaders::Library;

use crate::common::{self, Accuracy};
use crate::pictures::{Compared, by_reference, on_device};
use crate::running::{self, Running};
use crate::scenes::{self, Case};

const RANDOM_SCENES: u64 = 60;
/// Limit on the number of pixels times objects of one picture; see [`Case::within`].
const TESTS: usize = 15_000_000;

/// Returns all cases, and the number of cases that come from the repository.
fn cases() -> (Vec<Case>, usize) {
    let mut cases = Vec::new();
    for folder in ["tests/cases", "scenes"] {
        let found = scenes::in_folder(folder);
        println!("{folder}: {} scenes", found.len());
        cases.extend(found);
    }
    let files = cases.len();
    cases.extend(scenes::edges());
    cases.push(scenes::long_paths());
    cases.extend((0..RANDOM_SCENES).map(scenes::random));
    (cases.into_iter().map(|case| case.within(TESTS)).collect(), files)
}

/// Returns scenes with cameras far from the origin of coordinates, near windows, and any field of view. In f32 these
/// cameras have no window.
fn hard_cameras() -> impl Iterator<Item = Case> {
    let cases = (0..100).map(|seed| (seed, hard_camera(seed, 6)));
    cases.filter(|(_, (_, config))| config.check_picture().is_ok()).map(|(seed, (scene, config))| {
        let config = Config { image_width: 24, ..config };
        Case { name: format!("hard camera {seed}"), config, scene }
    })
}

#[test]
fn f64_pictures_are_the_references_to_the_bit() {
    let gpu = common::gpu();
    let (cases, files) = cases();
    assert!(files >= 16, "the repository has scenes: {files}");
    let cases: Vec<_> = cases.into_iter().chain(hard_cameras()).collect();
    let mut compared = Compared::default();
    for case in &cases {
        compared.add(case, &on_device::<f64>(&gpu, &Library::standard(), case).pixels);
    }
    compared.check(200_000);
}

#[test]
fn f32_pictures_are_near_the_reference_and_with_the_arithmetic_of_ieee_their_twins() {
    let gpu = common::gpu();
    let accuracy = common::accuracy(&gpu);
    let (cases, _) = cases();
    let (mut faults, mut all) = (Vec::new(), Reasons::default());
    for case in &cases {
        let rendering = on_device::<f32>(&gpu, &Library::standard(), case);
        let twin = Picture::<f32>::new(&case.config, &case.scene).unwrap_or_else(|error| panic!("{error}"));
        let twin: Vec<_> = (0..rendering.pixels.len()).map(|index| twin.color(index)).collect();
        let found = difference(&rendering.pixels, &twin);
        if accuracy == Accuracy::Ieee && found.differing > 0 {
            faults.push(format!("{} and its twin: {found}", case.name));
        }
        let expected = by_reference(case);
        let before = all.unexplained;
        running::within(accuracy, || all.count(case, &rendering.pixels, &expected));
        if all.unexplained > before {
            faults.push(format!("{}: {} pixels are beyond the bound", case.name, all.unexplained - before));
        }
    }
    let rmse = (all.squares / (3 * all.pixels) as f64).sqrt();
    println!("f32: {} pictures, RMSE {rmse:.1e}; {all:?}", cases.len());
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    assert!(all.rounding > 100_000, "f32 is compared within its bound in most pixels: {all:?}");
    assert!(all.visible * 50 < all.pixels, "{all:?}");
    assert!(rmse < 0.02, "the pictures are alike: {rmse}");
}

#[test]
fn more_objects_than_a_loop_may_pass_are_refused() {
    let gpu = common::gpu();
    let behind = "sphere: 0 0 -900 1 red\n".repeat(66_000);
    let text = format!("matte: red .9 .1 .1\n{behind}sphere: 0 0 0 5 red\n");
    let scene = cpu::internals::input::scene::Scene::parse(text.as_bytes()).expect("it is valid");
    let config = Config { image_width: 8, aspect_ratio: [1, 1], max_depth: 1, ..Config::default() };
    let case = Case { name: "66,001 spheres".to_owned(), config, scene };
    let picture = Picture::<f64>::new(&case.config, &case.scene).expect("it is valid");
    let features = features_of(&case.config, &case.scene).expect("it is valid");
    let renderer = Renderer::<f64>::new(&gpu, &Library::standard(), &features, &[]).expect("the kernel is valid");
    let error = renderer.render(&picture).expect_err("they are too many");
    assert!(
        error.to_string().starts_with("66001 objects to a depth of 1 are more than one run can loop over"),
        "{error}"
    );
}

/// Numbers of pixels by the reason why their f32 colour differs from the f64 colour.
#[derive(Debug, Default)]
struct Reasons {
    pixels: usize,
    /// Number of pixels whose difference is 0, or within the bound on the rounding errors along the path.
    rounding: usize,
    /// Number of pixels without a bound. The ray may pass so near an edge, a tangent, a critical angle or its own
    /// origin that f32 may decide differently. Or the error has grown without bound from bounce to bounce.
    undecided: usize,
    /// Number of pixels whose difference exceeds the bound, which is an error.
    unexplained: usize,
    /// Number of pixels whose difference is more than one step of a byte.
    visible: usize,
    /// Sum of the squares of the differences of all channels.
    squares: f64,
}

impl Reasons {
    /// Counts the pixels of a picture.
    fn count(&mut self, case: &Case, single: &[Vec3<f32>], wide: &[Vec3]) {
        let running = Picture::<Running>::new(&case.config, &case.scene).unwrap_or_else(|error| panic!("{error}"));
        for (index, (single, wide)) in single.iter().zip(wide).enumerate() {
            let (color, decided) = running::observe(|| running.color(index));
            let channels = single.to_array().into_iter().zip(wide.to_array());
            let apart: Vec<_> = channels.map(|(single, wide)| (f64::from(single) - wide).abs()).collect();
            let bounds = color.to_array().map(|channel| channel.bound);
            self.pixels += 1;
            self.visible += usize::from(apart.iter().any(|apart| *apart > 1.0 / 255.0));
            self.squares += apart.iter().map(|apart| apart * apart).sum::<f64>();
            let has_bound = decided && bounds.iter().all(|bound| bound.is_finite());
            let is_within = apart.iter().zip(bounds).all(|(apart, bound)| *apart <= bound);
            *match (has_bound, is_within) {
                (false, _) => &mut self.undecided,
                (true, true) => &mut self.rounding,
                (true, false) => &mut self.unexplained,
            } += 1;
        }
    }
}
