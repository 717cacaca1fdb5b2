//! Compares whole pictures in WGSL with pictures in Rust, in deterministic mode: every scene of the repository, random
//! scenes, and edge cases.

use cpu::{Config, Vec3};
use generator::cameras::hard_camera;
use gpu_check::Picture;
use gpu_check::difference::difference;
use shaders::Library;

use crate::common::{self, Accuracy};
use crate::pictures::{Compared, by_reference, on_device};
use crate::running::{self, Running};
use crate::scenes::{self, Case};

const RANDOM_SCENES: u64 = 30;
const HARD_CAMERAS: u64 = 50;
/// Limit on the number of pixels times objects of one picture; see [`Case::within`].
const TESTS: usize = 15_000_000;

fn cases() -> impl Iterator<Item = Case> {
    scenes::all(scenes::number_of_random(RANDOM_SCENES), TESTS).into_iter().chain([scenes::long_paths()])
}

/// Returns scenes with cameras far from the origin of coordinates, near windows, and any field of view. In f32 these
/// cameras have no window.
fn hard_cameras() -> impl Iterator<Item = Case> {
    let cases = (0..scenes::number_of_random(HARD_CAMERAS)).map(|seed| (seed, hard_camera(seed, 6)));
    cases.filter(|(_, (_, config))| config.check_picture().is_ok()).map(|(seed, (scene, config))| {
        let config = Config { image_width: 24, ..config };
        Case { name: format!("hard camera {seed}"), config, scene }
    })
}

#[test]
fn f64_pictures_are_the_references_to_the_bit() {
    let gpu = common::gpu();
    let mut compared = Compared::default();
    for case in cases().chain(hard_cameras()) {
        compared.add(&case, &on_device::<f64>(&gpu, &Library::standard(), &case).pixels);
    }
    compared.check(500_000);
}

#[test]
fn f32_pictures_are_near_the_reference_and_with_the_arithmetic_of_ieee_their_twins() {
    let gpu = common::gpu();
    let accuracy = common::accuracy(&gpu);
    let (mut faults, mut all) = (Vec::new(), Reasons::default());
    for case in &cases().collect::<Vec<_>>() {
        let rendering = on_device::<f32>(&gpu, &Library::standard(), case);
        let twin = Picture::<f32>::new(&case.config, &case.scene).unwrap_or_else(|error| panic!("{error}"));
        let twin: Vec<_> = (0..rendering.pixels.len()).map(|index| twin.color(index)).collect();
        let found = difference(&rendering.pixels, &twin);
        if accuracy == Accuracy::Ieee && found.differing > 0 {
            faults.push(format!("{} and its twin: {found}", case.name));
        }
        let expected = by_reference(case);
        let before = all.unexplained;
        match accuracy {
            Accuracy::Ieee => all.count::<true>(case, &rendering.pixels, &expected),
            Accuracy::Wgsl => all.count::<false>(case, &rendering.pixels, &expected),
        }
        if all.unexplained > before {
            faults.push(format!("{}: {} pixels are beyond the bound", case.name, all.unexplained - before));
        }
    }
    let rmse = (all.squares / (3 * all.pixels) as f64).sqrt();
    println!("f32: RMSE {rmse:.1e}; {all:?}");
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    assert!(all.rounding > 200_000, "f32 is compared within its bound in most pixels: {all:?}");
    assert!(all.visible * 50 < all.pixels, "{all:?}");
    assert!(rmse < 0.02, "the pictures are alike: {rmse}");
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
    /// Counts the pixels of a picture. `IEEE` says which arithmetic the device has, as for [`Running`].
    fn count<const IEEE: bool>(&mut self, case: &Case, single: &[Vec3<f32>], wide: &[Vec3]) {
        let running =
            Picture::<Running<IEEE>>::new(&case.config, &case.scene).unwrap_or_else(|error| panic!("{error}"));
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
