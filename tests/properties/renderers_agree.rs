//! The real renderer gives the reference's bytes: both layouts, all three ways to scatter, every instruction
//! set that the machine has, and every search (a handful of objects, a filter, a tree).

use std::cell::Cell;

use cpu::internals::layout::aos::AosImage;
use cpu::internals::{InstructionSet, Prepared};
use cpu::reference::intersect::Certified;
use cpu::{Aos, Config, Image, Layout, Scatter, Scene, Soa, Vec3};
use proptest::prelude::*;
use proptest::test_runner::TestCaseError;
use test_support::generator::{Arrangement, Options, scene};

use crate::runner::{cases, check};

const SCATTERS: [Scatter; 3] = [Scatter::Statement, Scatter::Published, Scatter::Deterministic];

/// A picture to render: what the generator makes, and how it is looked at.
#[derive(Clone, Debug)]
struct Case {
    options: Options,
    config: Config,
}

impl Case {
    /// The text of both files, to be saved and rendered by hand.
    fn files(&self, scene: &Scene) -> String {
        format!(
            "config.txt:\n{}scene.txt:\n{}",
            test_support::write::config(&self.config),
            test_support::write::scene(scene)
        )
    }
}

fn options() -> impl Strategy<Value = Options> {
    let arrangement = prop_oneof![Just(Arrangement::Degenerate), Just(Arrangement::Scattered), Just(Arrangement::Grid)];
    // All of one kind is as likely as a mixture: renderers leave out what a scene does not have.
    let cylinders = prop_oneof![Just(0.0), Just(0.5), Just(1.0)];
    let material = || prop_oneof![Just(0.0), Just(1.0)];
    let materials = [material(), material(), material()].prop_map(|weights| match weights {
        [0.0, 0.0, 0.0] => [1.0; 3],
        weights => weights,
    });
    // From 0.0001 to 100,000, all magnitudes alike.
    let extent = (-4..=5).prop_map(|exponent| format!("1e{exponent}").parse().expect("it is a number"));
    // Each range is searched in a way of its own.
    let objects = prop_oneof![4 => 0..=8_usize, 4 => 9..=100_usize, 1 => 101..=300_usize];
    (any::<u64>(), objects, cylinders, materials, extent, arrangement).prop_map(
        |(seed, objects, cylinders, materials, extent, arrangement)| Options {
            seed,
            objects,
            cylinders,
            materials,
            extent,
            arrangement,
        },
    )
}

/// Where the camera is, in extents: outside, among the objects, or on an axis, where rays run along coordinates.
fn position() -> impl Strategy<Value = [f64; 3]> {
    let axis = (0..3_usize, prop_oneof![Just(1.0), Just(-2.0), Just(0.25)]).prop_map(|(axis, distance)| {
        let mut position = [0.0; 3];
        position[axis] = distance;
        position
    });
    prop_oneof![axis, [-2.5..2.5, -2.5..2.5, -2.5..2.5], [-0.5..0.5, -0.5..0.5, -0.5..0.5]]
}

prop_compose! {
    fn case()(
        options in options(),
        position in position(),
        north in prop_oneof![Just([0.0, 1.0, 0.0]), Just([0.3, -1.0, 0.2]), Just([0.0, 0.1, -1.0])],
        field_of_view in 1.0..175.0,
        [width, aspect_width, aspect_height] in [1_u64..=24, 1..=4, 1..=4],
        samples_per_pixel in prop_oneof![4 => 1_u64..=8, 1 => 9..=40_u64],
        max_depth in 1..=50_u64,
        [material_rng_seed, ray_rng_seed] in [1..=u64::MAX, 1..=u64::MAX],
        gamma in prop_oneof![Just(1.0), Just(2.2), 0.2..5.0],
        one_color in any::<bool>(),
    ) -> Case {
        // Odd sizes of a single row or column come from the ratios; an odd width is one sample more in a batch.
        let north = Vec3::from(north);
        let position = Vec3::from(position) * options.extent;
        let light = if one_color { Vec3::new(0.25, 0.5, 1.0) } else { Vec3::new(1.0, 0.9, 0.8) };
        // A view along the north is refused; looking from a little aside it is not.
        let aside = Vec3::new(0.001, 0.0, 0.002) * options.extent;
        let parallel = position.cross(north).length() < 1e-6 * options.extent;
        let config = Config {
            image_width: width,
            aspect_ratio: [aspect_width, aspect_height],
            camera_position: if parallel { position + aside } else { position },
            camera_north: north,
            field_of_view,
            samples_per_pixel,
            max_depth,
            material_rng_seed,
            ray_rng_seed,
            gamma,
            background_light_color: light,
            ..Config::default()
        };
        Case { options, config }
    }
}

/// How many pixels of two pictures of the same size differ, and where the first is.
fn difference(actual: &impl Image, expected: &impl Image) -> Option<String> {
    assert_eq!(actual.size(), expected.size());
    let pixels = expected.size().pixels();
    assert!(pixels > 0);
    let differing: Vec<usize> = (0..pixels).filter(|&index| actual.pixel(index) != expected.pixel(index)).collect();
    let &first = differing.first()?;
    let (actual, expected) = (actual.pixel(first), expected.pixel(first));
    Some(format!("{} of {pixels} pixels differ; pixel {first} is {actual:?}, not {expected:?}", differing.len()))
}

fn reference(config: &Config, scene: &Scene, scatter: Scatter) -> AosImage {
    cpu::reference::render_with::<_, Certified>(config, scene, scatter)
        .expect("the picture is small and the camera sound")
}

fn agree(case: &Case, scene: &Scene, scatter: Scatter) -> Result<(), TestCaseError> {
    let expected = reference(&case.config, scene, scatter);
    agrees::<Aos>(case, scene, scatter, &expected)?;
    agrees::<Soa>(case, scene, scatter, &expected)
}

fn agrees<L: Layout>(case: &Case, scene: &Scene, scatter: Scatter, expected: &AosImage) -> Result<(), TestCaseError> {
    let layout = std::any::type_name::<L>();
    let prepared = Prepared::<L>::new(&case.config, scene, scatter).expect("what the reference renders, it renders");
    for set in InstructionSet::ALL.into_iter().filter(|set| set.is_available()) {
        let actual = cpu::internals::render_with(&prepared, set).expect("the picture is small");
        if let Some(difference) = difference(&actual, expected) {
            let (set, files) = (set.name(), case.files(scene));
            let what = format!("{layout}, {set}, {scatter:?}: {difference}\n{files}");
            return Err(TestCaseError::fail(what));
        }
    }
    Ok(())
}

#[test]
fn the_real_renderer_gives_the_references_bytes() {
    let (tried, with_objects) = (Cell::new(0), Cell::new(0));
    check(cases(20, 150), case(), |case| {
        let scene = scene(&case.options);
        let background = reference(&case.config, &Scene::default(), Scatter::Deterministic);
        for scatter in SCATTERS {
            agree(&case, &scene, scatter)?;
            if scatter == Scatter::Deterministic {
                let expected = reference(&case.config, &scene, scatter);
                tried.set(tried.get() + 1);
                with_objects.set(with_objects.get() + u32::from(difference(&expected, &background).is_some()));
            }
        }
        Ok(())
    });
    let (tried, with_objects) = (tried.get(), with_objects.get());
    println!("{with_objects} of {tried} pictures show an object");
    assert!(2 * with_objects > tried, "only {with_objects} of {tried} pictures show an object");
}

#[test]
fn a_single_wrong_channel_would_be_noticed() {
    let options = Options { objects: 5, ..Options::default() };
    let config = Config { image_width: 8, samples_per_pixel: 1, ..Config::default() };
    let expected = reference(&config, &scene(&options), Scatter::Statement);
    let mut wrong = expected.clone();
    let mut pixel = wrong.pixel(9);
    pixel.green ^= 1;
    wrong.set_pixel(9, pixel);
    assert!(difference(&expected, &expected).is_none());
    assert!(difference(&wrong, &expected).is_some_and(|text| text.starts_with("1 of 32 pixels differ; pixel 9 ")));
}
