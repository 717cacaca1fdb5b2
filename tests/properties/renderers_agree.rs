//! Tests that the real renderer gives the reference's bytes: in both layouts, with all three ways to scatter, with
//! every instruction set of the machine, and with every acceleration structure (small scene, flat filter, BVH).

use cpu::internals::layout::aos::AosImage;
use cpu::{Config, Scene, Vec3};
use generator::{Arrangement, Options, scene};
use proptest::prelude::*;
use test_support::agreement::SCATTERS;
use test_support::{golden, ppm};

use crate::runner::{Shown, check};

/// The inputs of a picture: options of the scene generator, and a configuration.
#[derive(Clone, Debug)]
struct Case {
    options: Options,
    config: Config,
}

fn options() -> impl Strategy<Value = Options> {
    let arrangement = prop_oneof![Just(Arrangement::Degenerate), Just(Arrangement::Scattered), Just(Arrangement::Grid)];
    // Two thirds of the scenes have objects of only one kind, because the renderer skips work for the other kind.
    let cylinders = prop_oneof![Just(0.0), Just(0.5), Just(1.0)];
    let material = || prop_oneof![Just(0.0), Just(1.0)];
    let materials = [material(), material(), material()].prop_map(|weights| match weights {
        [0.0, 0.0, 0.0] => [1.0; 3],
        weights => weights,
    });
    // The extent is a power of ten from 0.0001 to 100,000; all powers are equally likely.
    let extent = (-4..=5).prop_map(|exponent| format!("1e{exponent}").parse().expect("it is a number"));
    // Up to 8 objects make a small scene. Up to 64 with few cylinders get a flat filter, and others get a BVH.
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

/// Returns random positions of the camera, in units of the extent: outside, among the objects, or on a coordinate axis,
/// where rays are parallel to that axis.
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
        // With these aspect ratios, small widths also give pictures of one row or one column, and numbers of samples
        // that do not fill the lanes.
        let north = Vec3::from(north);
        let position = Vec3::from(position) * options.extent;
        let light = if one_color { Vec3::new(0.25, 0.5, 1.0) } else { Vec3::new(1.0, 0.9, 0.8) };
        // A view parallel to the north is refused, so the camera is moved slightly to the side.
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

#[test]
fn the_real_renderer_gives_the_references_bytes() {
    let shown = Shown::default();
    check(24, case(), |case| {
        let scene = scene(&case.options);
        SCATTERS.into_iter().try_for_each(|scatter| shown.compare(&case.config, &scene, scatter))
    });
    shown.conclude();
}

/// Tests that the reference gives the digests of the literal program, with which it shares no code.
#[test]
fn the_reference_gives_the_digests_of_the_small_scenes() {
    let mut compared = 0;
    for golden in golden::cases() {
        let config = Config::read(&golden.config).expect("committed configurations are valid");
        let scene = Scene::read(&golden.scene).expect("committed scenes are valid");
        let image = cpu::reference::render::<AosImage>(&config, &scene, golden.scatter).expect("it fits");
        assert_eq!(golden.digest(), Ok(format::digest::sha256(&ppm(&image))), "{}", golden.name);
        compared += 1;
    }
    assert_eq!(compared, 32, "16 scenes in both conventions");
}
