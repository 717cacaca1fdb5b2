//! Tests of every kind of message that an input can cause (specification, sections 3.4 and 4.3). The unit tests of
//! `cpu` and the plain parser of `tests/fuzz` try many more values.

use crate::bench::{Bench, SMALL};

const MATERIALS: &str = "matte: mat1 0 0.8 0.8\r\nmetal: metal1 0 0.8 0 2.0\n\nrefractive: ref99 1.3\n";

#[test]
fn configurations() {
    let cases = [
        ("image_xwidth: 3", "Unknown configuration key: [image_xwidth:]"),
        ("width", "Unknown configuration key: [width:]"),
        ("# comment", "Unknown configuration key: [#:]"),
        ("image_width: 12.5", "Invalid value for key: [image_width:]\nLine: \"image_width: 12.5\""),
        ("camera_target: 1 2 z 3", "Invalid value for key: [camera_target:]\nLine: \"camera_target: 1 2 z 3\""),
        (" \taspect_ratio:  16 \t\r\n", "Invalid value for key: [aspect_ratio:]\nLine: \" \taspect_ratio:  16 \t\""),
        ("gamma: 1\t 2.2 99 \t", "Extra data after configuration value for key: [gamma:]\nExtra: \"2.2 99\""),
        ("gamma: x\nwidth", "Invalid value for key: [gamma:]\nLine: \"gamma: x\""),
    ];
    for (line, message) in cases {
        for before in ["", "\n \t\ngamma: 1.8\n", "image_width: 4\r\n\r\n"] {
            Bench::new(format!("{before}{line}"), "").refuses(message.as_bytes());
        }
    }
}

#[test]
fn scenes() {
    let extra = "Extra data after configuration value for key:";
    let cases = [
        ("triangle: 1 2 3", "Unknown scene entity: triangle".to_owned()),
        ("matte: new 0 0.8 ", "Invalid matte material parameters\nLine: \"matte: new 0 0.8 \"".to_owned()),
        ("metal: new 0 0.8 0 -2", "Invalid metal material parameters\nLine: \"metal: new 0 0.8 0 -2\"".to_owned()),
        ("refractive: new", "Invalid refractive material parameters\nLine: \"refractive: new\"".to_owned()),
        ("sphere: 0 0 0 a x 3", "Invalid sphere parameters\nLine: \"sphere: 0 0 0 a x 3\"".to_owned()),
        ("cylinder: 0 0 0 1 0 0 0 m", "Invalid cylinder parameters\nLine: \"cylinder: 0 0 0 1 0 0 0 m\"".to_owned()),
        ("sphere: 0 0 0 1 x  3 y ", format!("{extra} [sphere:]\nExtra: \"3 y\"\nLine: \"sphere: 0 0 0 1 x  3 y \"")),
        ("matte: mat1 0 0 0 3", format!("{extra} [matte:]\nExtra: \"3\"\nLine: \"matte: mat1 0 0 0 3\"")),
        (
            "metal: ref99 0 0 0 1",
            "Material with name [ref99] already exists\nLine: \"metal: ref99 0 0 0 1\"".to_owned(),
        ),
        ("sphere: 0 0 0 1 x\nmatte: x 0 0 0", "Material not found: [x]\nLine: \"sphere: 0 0 0 1 x\"".to_owned()),
    ];
    for (line, message) in cases {
        Bench::new(SMALL, format!("{MATERIALS}{line}\nnever read")).refuses(message.as_bytes());
    }
}

#[test]
fn pictures_that_cannot_be_made_name_the_file_and_the_values_to_change() {
    let cases = [
        ("image_width: 4294967296\n", "4294967296 x 2415919104 pixels"),
        ("image_width: 100000\naspect_ratio: 1 9223372036854775807\n", "100000 x"),
        ("camera_position: 1 2 3\ncamera_target: 1 2 3\n", "camera_position is the same point as camera_target"),
        ("camera_position: 0 5 0\n", "camera_north is null or parallel"),
        ("camera_north: 0 0 0\n", "camera_north is null or parallel"),
        ("camera_position: 0 0 1e300\n", "out of range"),
    ];
    for (config, part) in cases {
        let bench = Bench::new(config, "");
        let message = bench.message();
        assert!(message.starts_with("Error: Invalid configuration [config.txt]: "), "{message}");
        assert!(message.contains(part), "{message} lacks {part}");
        // Checks also that the output is not changed.
        bench.refuses(message["Error: ".len()..].trim_end_matches('\n').as_bytes());
    }
}
