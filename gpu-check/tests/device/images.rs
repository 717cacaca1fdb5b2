//! Compares whole pictures in WGSL with pictures in Rust, in deterministic mode: every scene of the repository, random
//! scenes, and edge cases.

use std::path::Path;

use cpu::{Scatter, Vec3, reference};
use gpu_check::difference::{Difference, difference, write_png};
use gpu_check::running::{self, Accuracy, Running};
use gpu_check::scenes::{self, Case};
use gpu_check::{Float, Gpu, Picture, Renderer, Rendering, features_of};
use shaders::Library;

use crate::common;

const RANDOM_SCENES: u64 = 60;
/// Limit on the number of pixels times objects of one picture; see [`Case::within`].
const TESTS: usize = 15_000_000;

/// Returns all cases, and the number of cases that come from the repository.
fn cases() -> (Vec<Case>, usize) {
    let mut cases = Vec::new();
    for folder in ["tests/cases", "scenes"] {
        let found = scenes::in_folder(&scenes::repository(folder)).unwrap_or_else(|error| panic!("{error}"));
        println!("{folder}: {} scenes", found.len());
        cases.extend(found);
    }
    let files = cases.len();
    cases.extend(scenes::edges());
    cases.extend((0..RANDOM_SCENES).map(scenes::random));
    (cases.into_iter().map(|case| case.within(TESTS)).collect(), files)
}

fn on_device<T: Float>(gpu: &Gpu, case: &Case) -> Rendering<T> {
    let render = || {
        let features = features_of(&case.config, &case.scene)?;
        let renderer = Renderer::<T>::new(gpu, &Library::standard(), &features)?;
        renderer.render(&Picture::new(&case.config, &case.scene)?)
    };
    render().unwrap_or_else(|error: gpu_check::Error| panic!("{}: {error}", case.name))
}

fn by_reference(case: &Case) -> Vec<Vec3> {
    let mut means = Vec::new();
    reference::render_linear(&case.config, &case.scene, Scatter::Deterministic, |_, mean| means.push(mean))
        .unwrap_or_else(|error| panic!("{}: {error}", case.name));
    means
}

/// Writes both pictures and their difference into one file, and returns a message that names the file.
fn show<A: Float, B: Float>(case: &Case, rendering: &Rendering<A>, other: &[Vec3<B>]) -> String {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("differences");
    let name = format!("{} {}", case.name, A::PRECISION);
    match write_png(&folder, &name, rendering.size, &rendering.pixels, other) {
        Ok(path) => format!("{}: see {} (WGSL, Rust, difference)", case.name, path.display()),
        Err(error) => format!("{}: {error}", case.name),
    }
}

#[test]
fn f64_pictures_are_the_references_to_the_bit() {
    let gpu = common::gpu();
    let (cases, files) = cases();
    assert!(files >= 16, "the repository has scenes: {files}");
    let cases: Vec<_> = cases.into_iter().chain(scenes::hard_cameras()).collect();
    let (mut pixels, mut lit, mut faults) = (0, 0, Vec::new());
    for case in &cases {
        let rendering = on_device::<f64>(&gpu, case);
        let expected = by_reference(case);
        let found = difference(&rendering.pixels, &expected);
        pixels += found.pixels;
        lit += expected.iter().filter(|color| **color != Vec3::ZERO).count();
        if found.differing > 0 {
            faults.push(format!("{found}: {}", show(case, &rendering, &expected)));
        }
    }
    println!("f64: {} pictures, {pixels} pixels compared, {lit} of them not black", cases.len());
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    assert!(lit > 200_000, "{lit} pixels with light are too few");
}

#[test]
fn f32_pictures_are_near_the_reference_and_with_the_arithmetic_of_ieee_their_twins() {
    let gpu = common::gpu();
    let accuracy = common::accuracy(&gpu);
    let (cases, _) = cases();
    let (mut faults, mut all) = (Vec::new(), Reasons::default());
    for case in &cases {
        let rendering = on_device::<f32>(&gpu, case);
        let twin = Picture::<f32>::new(&case.config, &case.scene).unwrap_or_else(|error| panic!("{error}"));
        let twin: Vec<_> = (0..rendering.pixels.len()).map(|index| twin.color(index)).collect();
        if accuracy == Accuracy::Ieee && difference(&rendering.pixels, &twin).differing > 0 {
            faults.push(format!("not its twin: {}", show(case, &rendering, &twin)));
        }
        let expected = by_reference(case);
        let reasons = running::within(accuracy, || Reasons::of(case, &rendering.pixels, &expected));
        if reasons.unexplained > 0 {
            faults.push(format!("{} without a reason: {}", reasons.unexplained, show(case, &rendering, &expected)));
        }
        println!("{}: {reasons}", case.name);
        all.add(&reasons);
    }
    println!("f32: {} pictures; {all}", cases.len());
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    assert!(all.rounding > 100_000, "f32 is compared within its bound in most pixels: {all}");
    assert!(all.visible * 50 < all.overall.pixels, "{all}");
    assert!(all.overall.rmse < 0.02, "the pictures are alike: {all}");
}

/// Renders as [`on_device`] does, but a path hits at most `surfaces` surfaces in each run.
fn in_steps_of(surfaces: u32, gpu: &Gpu, case: &Case) -> Result<Rendering<f64>, gpu_check::Error> {
    let features = features_of(&case.config, &case.scene)?;
    let renderer = Renderer::<f64>::new(gpu, &Library::standard(), &features)?.in_steps_of(surfaces);
    renderer.render(&Picture::new(&case.config, &case.scene)?)
}

#[test]
fn a_long_path_in_several_runs_gives_the_reference_to_the_bit() {
    let gpu = common::gpu();
    let mut pixels = 0;
    for case in scenes::edges().into_iter().chain((0..10).map(scenes::random)) {
        let expected = by_reference(&case);
        for surfaces in [1, 3] {
            let rendering = in_steps_of(surfaces, &gpu, &case).unwrap_or_else(|error| panic!("{error}"));
            let found = difference(&rendering.pixels, &expected);
            assert_eq!(found.differing, 0, "{} in steps of {surfaces}: {found}", case.name);
            pixels += found.pixels;
        }
    }
    println!("{pixels} pixels compared");
    assert!(pixels > 50_000);
}

#[test]
fn more_objects_than_a_loop_may_pass_are_refused_and_lavapipe_would_lose_them() {
    let gpu = common::gpu();
    // Only the last of 66,000 spheres is in front of the camera.
    let behind = "sphere: 0 0 -900 1 red
"
    .repeat(66_000);
    let text = format!(
        "matte: red .9 .1 .1
{behind}sphere: 0 0 0 5 red
"
    );
    let scene = cpu::internals::input::scene::Scene::parse(text.as_bytes()).expect("it is valid");
    let config = cpu::Config {
        image_width: 8,
        aspect_ratio: [1, 1],
        max_depth: 1,
        ..cpu::internals::input::config::Config::default()
    };
    let case = Case { name: "66,001 spheres".to_owned(), config, scene };
    let picture = Picture::<f64>::new(&case.config, &case.scene).expect("it is valid");
    let features = features_of(&case.config, &case.scene).expect("it is valid");
    let renderer = Renderer::<f64>::new(&gpu, &Library::standard(), &features).expect("the kernel is valid");
    let error = renderer.render(&picture).expect_err("they are too many");
    assert!(
        error.to_string().starts_with("66001 objects to a depth of 1 are more than one run can loop over"),
        "{error}"
    );

    if gpu.is_lavapipe() {
        // This fails if a new version of Mesa runs loops to their end. Then docs/gpu.md must be changed.
        let lost = in_steps_of(1, &gpu, &case).unwrap_or_else(|error| panic!("{error}"));
        let found = difference(&lost.pixels, &by_reference(&case));
        assert!(found.differing > 0, "lavapipe renders the last of 66,001 objects: {found}");
    }
}

/// Numbers of pixels by the reason why their f32 colour differs from the f64 colour.
#[derive(Default)]
struct Reasons {
    overall: Difference,
    /// Number of pixels whose difference is 0, or within the bound on the rounding errors along the path.
    rounding: usize,
    /// Number of pixels without a bound. The ray may pass so near an edge, a tangent, a critical angle or its own
    /// origin that f32 may decide differently. Or the error has grown without bound from bounce to bounce.
    undecided: usize,
    /// Number of pixels whose difference exceeds the bound, which is an error.
    unexplained: usize,
    /// The largest difference of the pixels with a bound.
    largest: f64,
    /// Number of pixels whose difference is more than one step of a byte.
    visible: usize,
}

impl Reasons {
    fn of(case: &Case, single: &[Vec3<f32>], wide: &[Vec3]) -> Self {
        let running = Picture::<Running>::new(&case.config, &case.scene).unwrap_or_else(|error| panic!("{error}"));
        let mut reasons = Self { overall: difference(single, wide), ..Self::default() };
        for (index, (single, wide)) in single.iter().zip(wide).enumerate() {
            let (color, decided) = running::observe(|| running.color(index));
            let apart = |single: f32, wide: f64| (f64::from(single) - wide).abs();
            let channels = [(color.x, single.x, wide.x), (color.y, single.y, wide.y), (color.z, single.z, wide.z)];
            let largest = channels.iter().map(|(_, single, wide)| apart(*single, *wide)).fold(0.0, f64::max);
            reasons.visible += usize::from(largest > 1.0 / 255.0);
            if !decided || channels.iter().any(|(running, ..)| !running.bound.is_finite()) {
                reasons.undecided += 1;
                continue;
            }
            let explained = channels.iter().all(|(running, single, wide)| apart(*single, *wide) <= running.bound);
            *if explained { &mut reasons.rounding } else { &mut reasons.unexplained } += 1;
            reasons.largest = reasons.largest.max(largest);
        }
        reasons
    }

    fn add(&mut self, other: &Self) {
        let (pixels, more) = (self.overall.pixels as f64, other.overall.pixels as f64);
        let squares = self.overall.rmse.powi(2) * pixels + other.overall.rmse.powi(2) * more;
        self.overall.rmse = (squares / (pixels + more)).sqrt();
        self.overall.pixels += other.overall.pixels;
        self.overall.differing += other.overall.differing;
        self.overall.largest = self.overall.largest.max(other.overall.largest);
        self.rounding += other.rounding;
        self.undecided += other.undecided;
        self.unexplained += other.unexplained;
        self.visible += other.visible;
        self.largest = self.largest.max(other.largest);
    }
}

impl std::fmt::Display for Reasons {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { overall, rounding, undecided, unexplained, largest, visible } = self;
        write!(
            f,
            "{overall}, {visible} by more than 1/255; {rounding} pixels within the bound of rounding (at most {largest:.1e} apart), "
        )?;
        write!(f, "{undecided} that f32 may decide otherwise, {unexplained} unexplained")
    }
}
