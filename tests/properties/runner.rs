//! Runs a property on random cases. Environment variables can set the number and the seed of the cases.

use std::cell::Cell;

use cpu::internals::Prepared;
use cpu::{Aos, Config, Scatter, Scene};
use proptest::prelude::any;
use proptest::strategy::Strategy;
use proptest::test_runner::{self, RngSeed, TestCaseError, TestCaseResult, TestRunner};
use test_support::agreement::{Picture, SCATTERS, equals_reference, reference};
use test_support::number_of;

/// Checks `property` for `cases` random values of `strategy`. If the variable `RENDER_CASES` is set, its
/// number replaces `cases`.
pub fn check<S: Strategy>(cases: u32, strategy: S, property: impl Fn(S::Value) -> TestCaseResult) {
    let cases = number_of("RENDER_CASES").map_or(cases, |cases| u32::try_from(cases).unwrap_or(u32::MAX));
    let seed = number_of("RENDER_SEED").unwrap_or(1);
    assert!(cases > 0, "no case would be tried");
    let config = test_runner::Config {
        cases,
        rng_seed: RngSeed::Fixed(seed),
        // The seed reproduces a failure, so old failures need no file.
        failure_persistence: None,
        max_shrink_iters: 2_000,
        ..test_runner::Config::default()
    };
    let tried = Cell::new(0);
    let result = TestRunner::new(config).run(&strategy, |value| {
        tried.set(tried.get() + 1);
        property(value)
    });
    if let Err(failure) = result {
        panic!("with RENDER_SEED={seed} RENDER_CASES={cases}: {failure}");
    }
    assert_eq!(tried.get(), cases);
}

/// Checks that the pictures of `cases` random scenes are the reference's, with each way to scatter in turn. `make`
/// returns the scene of a seed with a number of objects. Returns the share of moderate scenes.
pub fn check_scenes(
    cases: u32,
    objects: impl Strategy<Value = usize>,
    make: impl Fn(u64, usize) -> (Scene, Config),
) -> f64 {
    let shown = Shown::default();
    check(cases, (any::<u64>(), objects), |(seed, objects)| {
        let (scene, config) = make(seed, objects);
        shown.compare(&config, &scene, SCATTERS[(seed % 3) as usize])
    });
    shown.conclude()
}

/// Renders two texts, and fails if a renderer differs from the reference.
pub fn agreed(config: &str, scene: &str, scatter: Scatter) -> Picture {
    let config = Config::parse(config.as_bytes()).expect("the configuration is valid");
    let scene = Scene::parse(scene.as_bytes()).expect("the scene is valid");
    let picture = equals_reference(&config, &scene, scatter).unwrap_or_else(|text| panic!("{text}"));
    picture.expect("the camera has a window")
}

/// Counts the pictures of random scenes, so that a test fails if most of them show nothing.
#[derive(Default)]
pub struct Shown {
    rendered: Cell<u32>,
    with_objects: Cell<u32>,
    moderate: Cell<u32>,
}

impl Shown {
    /// Fails if a renderer differs from the reference. A camera without a window makes no picture, and is not counted.
    pub fn compare(&self, config: &Config, scene: &Scene, scatter: Scatter) -> TestCaseResult {
        let picture = equals_reference(config, scene, scatter).map_err(TestCaseError::fail)?;
        let Some(picture) = picture.filter(|_| !scene.objects.is_empty()) else { return Ok(()) };
        let background = reference(config, &Scene::default(), scatter).expect("the camera has a window");
        let prepared = Prepared::<Aos>::new(config, scene, scatter).expect("the camera has a window");
        self.rendered.set(self.rendered.get() + 1);
        self.with_objects.set(self.with_objects.get() + u32::from(picture.means != background.means));
        self.moderate.set(self.moderate.get() + u32::from(prepared.moderate));
        Ok(())
    }

    /// Panics if fewer than half of the pictures show an object. Returns the share of moderate scenes.
    pub fn conclude(&self) -> f64 {
        let [rendered, shown, moderate] = [&self.rendered, &self.with_objects, &self.moderate].map(Cell::get);
        println!("{shown} of {rendered} pictures show an object, {moderate} scenes are moderate");
        assert!(2 * shown > rendered, "only {shown} of {rendered} pictures show an object");
        f64::from(moderate) / f64::from(rendered)
    }
}
