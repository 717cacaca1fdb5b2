//! Tests of every kind of message that an input can cause (specification, sections 3.4 and 4.3). The unit tests of
//! `cpu` and the plain parser of `tests/fuzz` try many more values.

use format::hint::Kind;
use format::refused;

use crate::bench::Bench;

#[test]
fn every_wrong_line_is_refused_with_its_message() {
    for refused in refused::all() {
        let [config, scene] = refused.files();
        let more = ["\n \t\ngamma: 1.8\n", "image_width: 4\r\n\r\n"];
        let above = if refused.kind == Kind::Config { &more[..] } else { &[] };
        for above in [""].iter().chain(above) {
            Bench::new([above.as_bytes(), &config].concat(), &scene).refuses(refused.message.as_bytes());
        }
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
