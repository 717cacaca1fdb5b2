//! Tests with hard cameras: far from the origin of coordinates, with near windows, and with any field of view. The
//! renderer must give the reference's bytes, and the bits of its means.

use cpu::Scatter;
use generator::cameras::hard_camera;
use proptest::prelude::*;
use test_support::agreement::{Picture, SCATTERS};

use crate::runner::{Shown, agreed, check};

/// Returns the number of pixels whose bytes are not `background`.
pub fn count_shown(picture: &Picture, background: [u8; 3]) -> usize {
    use cpu::Image as _;
    let size = picture.image.size();
    let differs = |&index: &usize| {
        let pixel = picture.image.pixel(index);
        [pixel.red, pixel.green, pixel.blue] != background
    };
    (0..size.pixels()).filter(differs).count()
}

#[test]
fn scenes_with_hard_cameras_give_the_references_bytes_and_means() {
    let shown = Shown::default();
    let objects = prop_oneof![1 => Just(0_usize), 4 => 1..=8_usize, 3 => 9..=64_usize, 1 => 65..=140_usize];
    check(250, (any::<u64>(), objects), |(seed, objects)| {
        let (scene, config) = hard_camera(seed, objects);
        shown.compare(&config, &scene, SCATTERS[(seed % 3) as usize])
    });
    assert!(shown.conclude() > 0.5, "most scenes are moderate");
}

/// Renders two scenes in which culling once lost objects, because it took the rays of a far camera as exact. The second
/// scene is rendered again with 200 other objects, which make a hierarchy.
#[test]
fn objects_before_a_far_camera_with_a_near_window_are_seen() {
    let white = "background_dark_color: 1 1 1\nbackground_light_color: 1 1 1\n";
    let far = format!(
        "{white}image_width: 64\naspect_ratio: 1 1\nsamples_per_pixel: 4\nmax_depth: 1\n\
         camera_position: 126511.29483519692 -111994.59568274823 157363.9475857903\n\
         camera_target: 126511.29483519684 -111994.59568274823 157363.94758579065\n\
         camera_north: 0.01519176635484475 0.24355603588431043 0.29093035263743217\nfield_of_view: 20\n"
    );
    let cylinder = "metal: m .3 .9 .9 0\ncylinder: 99732.55927131389 -106087.47853180127 227549.89511009253 \
                    391.8235564957429 -424.5878581675544 -276.5069169941397 92.43550154907906 m\n";
    // The literal program in C++ shows it in as many pixels.
    assert_eq!(count_shown(&agreed(&far, cylinder, Scatter::Statement), [255; 3]), 69);
    let narrow = format!(
        "{white}image_width: 64\naspect_ratio: 1 1\nsamples_per_pixel: 4\nmax_depth: 1\n\
         camera_position: 6e7 5e7 -9e7\ncamera_target: 60000000.36 50000000.48 -89999999.2\nfield_of_view: 1e-6\n"
    );
    let sphere = "matte: a .5 .5 .5\nsphere: 1.14e8 1.22e8 3e7 1 a\n".to_owned();
    let alone = agreed(&narrow, &sphere, Scatter::Statement);
    assert!(count_shown(&alone, [255; 3]) > 2000, "{}", count_shown(&alone, [255; 3]));
    // The other spheres are beyond the picture.
    let others: String = (0..200).map(|at| format!("sphere: {}e5 1.32e8 3e7 1e4 a\n", 1100 + at)).collect();
    assert_eq!(agreed(&narrow, &(sphere + &others), Scatter::Statement).means, alone.means);
}

#[test]
fn empty_skies_give_the_references_bytes() {
    for (position, target, fov) in [
        ("6e8 5e8 -9e8", "600000000.36 500000000.48 -899999999.2", 1.0),
        ("1e9 0 0", "1000000000.01 1e-3 0", 60.0),
        ("3e5 1e5 -2e5", "300000.000001 100000 -200000.000001", 100.0),
        ("0 0 -10", "0 1 0", 179.9),
    ] {
        let config = format!(
            "image_width: 400\naspect_ratio: 1 1\nsamples_per_pixel: 1\ncamera_position: {position}\n\
             camera_target: {target}\nfield_of_view: {fov}\n"
        );
        agreed(&config, "", Scatter::Statement);
    }
}

#[test]
fn north_may_have_any_length() {
    let picture = |north: &str| {
        let config = format!(
            "image_width: 12\naspect_ratio: 1 1\nsamples_per_pixel: 2\nfield_of_view: 60\ncamera_north: {north}\n"
        );
        agreed(&config, "matte: m .8 .2 .1\nsphere: 0 0 0 3 m\nsphere: 2 2 0 1 m\n", Scatter::Statement).means
    };
    let expected = picture("0 1 0");
    for length in ["1e155", "1e-170", "1.7976931348623157e308", "5e-324"] {
        assert_eq!(picture(&format!("0 {length} 0")), expected, "{length}");
    }
    assert_ne!(picture("1 1 0"), expected);
    let tilted = picture("3 4 0");
    for power in [660, -660] {
        let length = 2.0_f64.powi(power);
        assert_eq!(picture(&format!("{:e} {:e} 0", 3.0 * length, 4.0 * length)), tilted, "2^{power}");
    }
}
