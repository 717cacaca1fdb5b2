//! Tests with hard cameras: far from the origin of coordinates, with near windows, and with any field of view. The
//! renderer must give the reference's bytes, and the bits of its means.

use cpu::Scatter;
use generator::cameras::hard_camera;
use proptest::prelude::*;

use crate::runner::{agreed, check_scenes};

#[test]
fn scenes_with_hard_cameras_give_the_references_bytes_and_means() {
    let objects = prop_oneof![1 => Just(0_usize), 4 => 1..=8_usize, 3 => 9..=64_usize, 1 => 65..=140_usize];
    assert!(check_scenes(250, objects, hard_camera) > 0.5, "most scenes are moderate");
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
