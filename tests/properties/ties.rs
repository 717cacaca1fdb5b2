//! Tests with surfaces at the same lambda: coplanar caps of two and of many cylinders, and spheres that touch the plane
//! of a cap exactly.
//!
//! Rays come straight from above, so the lambdas are exactly equal. The expected objects follow from the statement: a
//! sphere or a side replaces what is at the same lambda, and a cap does not.

use cpu::{Image, Rgb, Scatter};

use crate::runner::agreed;

/// The colours of the objects, one for each place in the scene file.
const COLORS: [&str; 3] = [".9 0 0", "0 .9 0", "0 0 .9"];

/// The way in which rays come to the surfaces, straight from above. The renderer finds the closest hit by another code
/// for each.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Way {
    /// Camera rays.
    Straight,
    /// Rays of a specular chain, which pass through a flat glass cylinder.
    ThroughGlass,
    /// Rays of a path, which a mirror reflects. The directions are random here, so only coplanar caps tie.
    Mirrored,
}

/// Returns the index of the largest channel at the centre of the picture of `objects`. The material of each object is
/// the one of its place in the list. `others` are added before the objects.
fn seen(way: Way, others: &str, objects: &[&str]) -> usize {
    let materials: String = (0..3).map(|at| format!("matte: m{at} {}\n", COLORS[at])).collect();
    let lines: String = objects.iter().enumerate().map(|(at, object)| format!("{object} m{at}\n")).collect();
    let (more, camera, scatter) = match way {
        Way::Straight => ("", "0 9 0\ncamera_target: 0 0 0", Scatter::Deterministic),
        Way::ThroughGlass => ("cylinder: 0 5 0 3 0 1 0 glass\n", "0 9 0\ncamera_target: 0 0 0", Scatter::Deterministic),
        Way::Mirrored => ("cylinder: 0 10 0 .3 0 2 0 mirror\n", "0 5 0\ncamera_target: 0 9 0", Scatter::Statement),
    };
    let text =
        format!("{materials}matte: grey .4 .4 .4\nrefractive: glass 1.5\nmetal: mirror 1 1 1 0\n{more}{others}{lines}");
    let config = format!(
        "image_width: 5\naspect_ratio: 1 1\nmax_depth: 8\nsamples_per_pixel: 8\ncamera_north: 0 0 1\nfield_of_view: 1\n\
         background_dark_color: 1 1 1\nbackground_light_color: 1 1 1\ncamera_position: {camera}\n"
    );
    let Rgb { red, green, blue } = agreed(&config, &text, scatter).image.pixel(12);
    let channels = [red, green, blue];
    let largest = (0..3).max_by_key(|&channel| channels[channel]).expect("there are three");
    assert!((0..3).all(|at| at == largest || channels[at] < channels[largest]), "{way:?}: {channels:?}");
    largest
}

/// The numbers of other objects. They give a small scene with and without lanes, the flat filter, and the BVH.
const OTHERS: [usize; 5] = [0, 3, 20, 100, 300];

/// Checks which object is seen in each of `cases`, with every structure and each of `ways`. A case has the lines of the
/// objects, and the place of the one that is seen.
#[track_caller]
fn check(ways: &[Way], cases: &[(&[&str], usize)]) {
    for count in OTHERS {
        let others = others(count);
        for (&way, (objects, place)) in ways.iter().flat_map(|way| cases.iter().map(move |case| (way, case))) {
            assert_eq!(seen(way, &others, objects), *place, "{count} others, {way:?}, {objects:?}");
        }
    }
}

/// Returns lines of small objects below the plane, away from the camera's axis.
fn others(count: usize) -> String {
    (0..count)
        .map(|at| {
            let (x, z) = ((at % 20) as f64 - 9.5, (at / 20) as f64 + 3.0);
            match at % 2 {
                0 => format!("sphere: {x} -3 {z} .3 grey\n"),
                _ => format!("cylinder: {x} -3 {z} .2 0 .5 0 grey\n"),
            }
        })
        .collect()
}

#[test]
fn of_coplanar_caps_the_first_counts() {
    let wide = "cylinder: 0 0 0 2 0 2 0";
    for second in ["cylinder: 0 0 0 1 0 2 0", "cylinder: 0 .5 0 3 0 1 0", "cylinder: 0 0 0 1 0 -2 0"] {
        let cases: [(&[&str], usize); 3] = [(&[wide, second], 0), (&[second, wide], 0), (&[wide, wide, wide], 0)];
        check(&[Way::Straight, Way::ThroughGlass, Way::Mirrored], &cases);
    }
}

#[test]
fn a_sphere_that_touches_the_plane_of_a_cap_counts_in_any_order() {
    let (cap, sphere) = ("cylinder: 0 0 0 2 0 2 0", "sphere: 0 .5 0 .5");
    let cases: [(&[&str], usize); 4] =
        [(&[cap, sphere], 1), (&[sphere, cap], 0), (&[cap, sphere, cap], 1), (&[sphere, cap, sphere], 2)];
    check(&[Way::Straight, Way::ThroughGlass], &cases);
}

#[test]
fn of_sides_at_the_same_lambda_the_last_counts_and_no_cap_replaces_it() {
    // The first two cylinders lie on their sides, and touch the plane of the third one's cap.
    let (lying, across, cap) = ("cylinder: 0 0 0 1 2 0 0", "cylinder: 0 0 0 1 0 0 2", "cylinder: 0 0 0 2 0 2 0");
    let cases: [(&[&str], usize); 4] = [
        (&[lying, across, cap], 1),
        (&[cap, lying, across], 2),
        (&[lying, cap, across], 2),
        (&[lying, "sphere: 0 .5 0 .5", cap], 1),
    ];
    check(&[Way::Straight, Way::ThroughGlass], &cases);
}
