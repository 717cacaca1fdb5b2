//! Renders pictures of 15 pixels, which reach every stage and every acceleration structure. They must have the
//! reference's pixels with every available instruction set and in both layouts.
//!
//! The properties in the package `tests` check the same for thousands of random scenes. These pictures are so small
//! that miri, which interprets every instruction, renders them in minutes (`tests/extensive memory -- miri`).

use std::ops::{ControlFlow, RangeInclusive};

use cpu::internals::accel::choice::Accel;
#[cfg(debug_assertions)]
use cpu::internals::counters::{Counter, reset, snapshot};
use cpu::internals::{Ended, InstructionSet, Limits, Prepared, Streams, render_from, render_linear};
use cpu::reference::{self, Counts, Exact, Plain, render_recorded};
use cpu::{Aos, Config, Image, Layout, Scatter, Scene};
use test_support::agreement::{equals_reference, reference};

const MATERIALS: &str = "matte: m .8 .7 .6\nmetal: s .9 .8 .7 .4\nrefractive: g 1.5\n";

/// Returns the scene's lines for a board of `count` objects. Spheres and cylinders alternate, and so do the materials.
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

/// Returns the scene's lines for a cube full of `count` spheres, which the camera sees from outside. Some touch.
fn crowd(count: usize) -> String {
    let side = (count as f64).cbrt().ceil() as usize;
    let (step, middle) = (4.0 / side as f64, (side / 2) as f64);
    let object = |at: usize| {
        let [x, y, z] = [at % side, at / side % side, at / side / side].map(|place| (place as f64 - middle) * step);
        let (size, material) = (step * (0.2 + 0.03 * (at % 11) as f64), ["m", "s", "g"][at % 3]);
        format!("sphere: {x} {y} {z} {size} {material}\n")
    };
    (0..count).map(object).collect()
}

/// Compares the picture of `objects`, which use the materials m, s and g, with the reference. `seen` is the range of
/// the number of pixels, of 15, that show an object. `is_expected` checks that the scene gets the acceleration
/// structure in the test's name.
fn check(objects: &str, seen: RangeInclusive<usize>, is_expected: fn(&Accel) -> bool) {
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
    assert!(is_expected(&prepared.accel), "{:?}", prepared.accel);
}

/// Tests that every function that renders gives the same picture, from the first row to the last, and stops on request.
#[test]
fn all_functions_that_render_give_one_picture() {
    let config = "image_width: 5\naspect_ratio: 5 3\nsamples_per_pixel: 3\nmax_depth: 6\ncamera_position: .3 .2 -6\n";
    let config = Config::parse(config.as_bytes()).expect("the configuration is valid");
    let scene = format!("{MATERIALS}sphere: 0 0 0 2 m\nsphere: 2 0 -2 1 s\n");
    let scene = Scene::parse(scene.as_bytes()).expect("the scene is valid");
    let prepared = Prepared::<Aos>::new(&config, &scene, Scatter::Statement).expect("the camera is sound");
    let (set, limits) = (InstructionSet::chosen(), Limits::default());
    let black = || <Aos as Layout>::Image::black(prepared.size).expect("it is small");
    let pixels = |image: &<Aos as Layout>::Image| (0..15).map(|at| image.pixel(at)).collect::<Vec<_>>();
    let whole = pixels(&cpu::render::<Aos>(&config, &scene, Scatter::Statement).expect("memory is enough"));

    // The first run stops after two rows. The second one goes on with its words, and renders the last row alone.
    let (mut image, mut words, mut rows) = (black(), Vec::new(), Vec::new());
    let first = render_from(&prepared, set, &limits, (0, &[]), &mut image, |row, _, streams| {
        words.clear();
        streams.visit(|word| words.push(*word));
        rows.push(row);
        if row == 2 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    });
    assert_eq!((first.expect("memory is enough"), rows), (Some(Ended::Stopped), vec![1, 2]));
    assert_eq!(pixels(&image)[..10], whole[..10]);
    let mut rest = black();
    assert_eq!(words.len(), Streams::count());
    let second = render_from(&prepared, set, &limits, (2, &words), &mut rest, |_, _, _| ControlFlow::Continue(()));
    assert_eq!((second.expect("memory is enough"), &pixels(&rest)[10..]), (None, &whole[10..]));

    let mut means = [const { Vec::new() }; 3];
    let [linear, counted, recorded] = &mut means;
    let ended = render_linear(&prepared, set, &limits, |at, mean| linear.push((at, mean)));
    assert_eq!(ended.expect("memory is enough"), None);
    let scatter = Scatter::Statement;
    let counts = reference::render_linear::<Exact>(&config, &scene, scatter, |at, mean| counted.push((at, mean)));
    let counts = counts.expect("memory is enough");
    assert!(counts.hits > 0 && counts.rays >= 45 + counts.hits, "{counts:?}");
    let mut samples = Vec::new();
    let pixel = |at, mean| recorded.push((at, mean));
    let again = render_recorded::<Exact>(&config, &scene, scatter, |words| samples.push(words), pixel);
    assert_eq!(again.expect("memory is enough"), counts);
    // Each of the 45 samples takes three words for each matte and metal surface that it hits.
    assert!(samples.len() == 45 && samples.iter().all(|words| words % 3 == 0) && samples.iter().sum::<u64>() > 0);
    assert!(means.iter().all(|of| *of == means[0]), "{means:?}");

    // No ray hits an object, so each sample has one ray, and plain and exact intersections agree.
    let (mut plain, mut real, nothing) = (Vec::new(), Vec::new(), Scene::default());
    reference::render_linear::<Plain>(&config, &nothing, scatter, |at, mean| plain.push((at, mean)))
        .expect("memory is enough");
    let counts = reference::render_linear::<Exact>(&config, &nothing, scatter, |at, mean| real.push((at, mean)));
    assert_eq!((counts.expect("memory is enough"), plain), (Counts { rays: 45, hits: 0 }, real));
}

/// Tests means below -1/16. The squares of the rays' components underflow, so the rays' lengths are too small by a
/// fifth, and the background's weight is -0.1. With a gamma of 1/2 the bytes of such means are not 0.
#[test]
fn negative_means() {
    let config = "image_width: 5\naspect_ratio: 5 3\nsamples_per_pixel: 1\nfield_of_view: 1\ngamma: 0.5\n\
        camera_position: 0 0 0\ncamera_target: 0 -2.68e-162 0\ncamera_north: 0 0 1\n\
        background_dark_color: 1 1 1\nbackground_light_color: 0 0 0\n";
    let config = Config::parse(config.as_bytes()).expect("the configuration is valid");
    let picture = equals_reference(&config, &Scene::default(), Scatter::Statement);
    let means = picture.unwrap_or_else(|difference| panic!("{difference}")).expect("the picture is small").means;
    assert!(means.iter().all(|mean| f64::from_bits(mean[0]) < -0.0625), "{means:?}");
}

/// Tests hits at an infinite lambda. It overflows, because the rays are 1e-150 long and the objects 1e159 away.
#[test]
fn hits_whose_lambda_overflows() {
    let config = "image_width: 5\naspect_ratio: 5 3\nsamples_per_pixel: 2\nfield_of_view: 40\n\
        camera_position: 0 0 0\ncamera_target: 0 0 1e-150\n";
    let config = Config::parse(config.as_bytes()).expect("the configuration is valid");
    let picture = |objects: &str| {
        let scene = Scene::parse(format!("{MATERIALS}{objects}").as_bytes()).expect("the scene is valid");
        let picture = equals_reference(&config, &scene, Scatter::Statement);
        let picture = picture.unwrap_or_else(|difference| panic!("{objects}: {difference}"));
        picture.expect("the picture is small").means
    };
    let nothing = picture("");
    for material in ["m", "s", "g"] {
        let (sphere, cylinder) =
            (format!("sphere: 0 0 1e160 9e159 {material}\n"), "cylinder: 0 0 1e160 9e159 0 9e150 0 m\n");
        assert_ne!(picture(&sphere), nothing, "{sphere}");
        picture(&format!("{sphere}{cylinder}"));
        picture(&format!("{cylinder}{sphere}"));
    }
}

#[test]
fn a_background_alone() {
    check("", 0..=0, |accel| matches!(accel, Accel::SmallScene(_)));
}

/// Tests pixels whose bytes follow from bounds of the background. In one picture all rays have the same colour, and in
/// the other one nearly the same.
#[test]
fn a_background_of_one_byte_in_each_channel() {
    let colors = "background_dark_color: .3 .4 .5\nbackground_light_color: .3 .4 .5\n";
    for lines in [colors, "field_of_view: .01\n"] {
        #[cfg(debug_assertions)]
        reset();
        let config = format!("image_width: 5\naspect_ratio: 5 3\nsamples_per_pixel: 3\n{lines}");
        let config = Config::parse(config.as_bytes()).expect("the configuration is valid");
        let picture = equals_reference(&config, &Scene::default(), Scatter::Statement);
        let picture = picture.unwrap_or_else(|difference| panic!("{difference}")).expect("the picture is small");
        assert!((0..15).all(|at| picture.image.pixel(at) == picture.image.pixel(0)), "{lines}");
        // Debug builds count such pixels.
        #[cfg(debug_assertions)]
        assert!(snapshot()[Counter::BackgroundPixels as usize] >= 15, "{lines}");
    }
}

/// Tests camera rays that rounding turns into null vectors, because the camera is far from the origin and its target
/// near. Their colour is no number, so their pixels are black, although both ends of the background are white.
#[test]
fn a_white_background_with_rays_without_a_direction() {
    let config = "image_width: 8\naspect_ratio: 4 3\nsamples_per_pixel: 8\nfield_of_view: 30\n\
        background_dark_color: 1 1 1\nbackground_light_color: 1 1 1\n\
        camera_position: -900000000.0000001 -900000000.0000006 -900000000.0000006\n\
        camera_target: -900000000.0000002 -900000000.0000005 -900000000.0000007\ncamera_north: -2 -2 1\n";
    let config = Config::parse(config.as_bytes()).expect("the configuration is valid");
    let picture = equals_reference(&config, &Scene::default(), Scatter::Statement);
    let image = picture.unwrap_or_else(|difference| panic!("{difference}")).expect("the picture is small").image;
    let black = (0..48).filter(|&at| image.pixel(at).red == 0).count();
    assert!(black > 0 && black < 48, "{black} of 48 pixels are black");
}

#[test]
fn two_objects_with_lookahead() {
    check(
        "sphere: 0 -102 0 100 s\ncylinder: 0 0 0 1.5 .5 3 0 m\n",
        6..=15,
        |accel| matches!(accel, Accel::SmallScene(small_scene) if !small_scene.uses_object_lanes()),
    );
}

#[test]
fn five_objects_in_object_lanes_with_refraction() {
    check(
        "sphere: 0 0 0 2 g\nsphere: 0 2 0 1 s\nsphere: 0 -2 0 1 m\ncylinder: 1 0 -1 .5 1 1 .2 g\nsphere: 2 0 0 .5 s\n",
        6..=15,
        |accel| matches!(accel, Accel::SmallScene(small_scene) if small_scene.uses_object_lanes()),
    );
}

#[test]
fn objects_in_a_flat_filter_above_a_dominant_sphere() {
    check(&format!("sphere: 0 -101 0 100 s\n{}", board(20)), 6..=15, |accel| matches!(accel, Accel::FlatFilter(_)));
}

#[test]
fn objects_in_a_bvh_above_a_dominant_sphere() {
    check(&format!("sphere: 0 -101 0 100 m\n{}", board(132)), 12..=15, |accel| matches!(accel, Accel::Bvh(_)));
}

#[test]
fn a_thin_disc_apart_from_the_bvh_and_among_few_objects() {
    let disc = "cylinder: 0 -1 0 3 0 1e-7 .01 s\nsphere: 0 1 0 1e-9 m\n";
    check(&format!("{disc}{}", board(20)), 8..=15, |accel| matches!(accel, Accel::Bvh(_)));
    check(&format!("{disc}{}", board(3)), 4..=15, |accel| matches!(accel, Accel::EveryObject(_)));
}

#[test]
#[cfg_attr(miri, ignore = "it takes too long there")]
fn spheres_in_sphere_leaves() {
    check(&crowd(1000), 12..=15, |accel| matches!(accel, Accel::Bvh(bvh) if bvh.sphere_leaf_count() > 0));
}

#[test]
#[cfg_attr(miri, ignore = "it takes too long there")]
fn more_spheres_in_byte_boxes() {
    check(&crowd(200_001), 12..=15, |accel| matches!(accel, Accel::LargeBvh(bvh) if bvh.sphere_leaf_count() > 0));
}

#[test]
#[cfg_attr(miri, ignore = "exact arithmetic takes too long there")]
fn objects_of_extreme_magnitude() {
    check("sphere: 0 0 0 2 s\nsphere: 1e160 0 0 1 m\nsphere: 1 1 0 1 g\n", 4..=15, |accel| {
        matches!(accel, Accel::EveryObject(_))
    });
    // The camera is inside objects whose squared distances exceed the limit of the camera rays' test.
    let cylinder = "cylinder: 0 1e120 2e120 1e121 1e120 2e121 3e120 s\n";
    for room in [cylinder, "sphere: 3e120 -1e121 2e120 1.3e121 s\n"] {
        check(room, 1..=15, |accel| matches!(accel, Accel::EveryObject(_)));
    }
}
