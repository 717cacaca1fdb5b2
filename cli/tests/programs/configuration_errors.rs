//! Tests of every message that a configuration can cause (specification, section 3.4).

use crate::bench::Bench;

/// Checks that both programs refuse the configuration `line` with `message`, alone and after other valid lines.
fn refuses(line: &str, message: &str) {
    for before in ["", "\n \t\ngamma: 1.8\n", "image_width: 4\r\n\r\n"] {
        Bench::new(format!("{before}{line}"), "").refuses(message.as_bytes());
    }
}

/// Returns the key of a line, with its colon.
fn key(line: &str) -> &str {
    line.split_whitespace().next().expect("the line has a key")
}

#[test]
fn unknown_keys() {
    refuses("image_xwidth: 3", "Unknown configuration key: [image_xwidth:]");
    refuses("width", "Unknown configuration key: [width:]");
    refuses("gamma 2.2", "Unknown configuration key: [gamma:]");
    refuses("Gamma: 2.2", "Unknown configuration key: [Gamma:]");
    refuses("# comment", "Unknown configuration key: [#:]");
}

#[test]
fn values_that_are_missing_unreadable_or_out_of_range() {
    let lines = [
        "aspect_ratio: nulo",
        "aspect_ratio: 16",
        "aspect_ratio: 16 0",
        "aspect_ratio: -16 9",
        "image_width:",
        "image_width: 0",
        "image_width: 12.5",
        "image_width: 99999999999999999999999",
        "gamma: 0",
        "gamma: -2.2",
        "gamma: nan",
        "gamma: 0x2",
        "camera_position: 500 500",
        "camera_target: 1 2 z",
        "camera_north: 1 2 1e999",
        "field_of_view: 0",
        "field_of_view: 180",
        "field_of_view: inf",
        "samples_per_pixel: 0",
        "samples_per_pixel: 1e2",
        "max_depth: -1",
        "material_rng_seed: 0",
        "ray_rng_seed: -1",
        "background_dark_color: 0 0 1.01",
        "background_light_color: -.01 0 0",
        "background_light_color: 0 0",
        "gamma: 1.5x 99",
    ];
    for line in lines {
        refuses(line, &format!("Invalid value for key: [{}]\nLine: \"{line}\"", key(line)));
    }
}

#[test]
fn the_line_is_shown_byte_for_byte_without_its_line_end() {
    refuses(" \taspect_ratio:  16 \t\r\n", "Invalid value for key: [aspect_ratio:]\nLine: \" \taspect_ratio:  16 \t\"");
}

#[test]
fn extra_data_after_every_key() {
    let lines = [
        "aspect_ratio: 16 9",
        "image_width: 10",
        "gamma: 2.2",
        "camera_position: 0 0 -10",
        "camera_target: 0 0 0",
        "camera_north: 0 1 0",
        "field_of_view: 90",
        "samples_per_pixel: 1",
        "max_depth: 1",
        "material_rng_seed: 1",
        "ray_rng_seed: 1",
        "background_dark_color: 0 0 0",
        "background_light_color: 1 1 1",
    ];
    for line in lines {
        let message = format!("Extra data after configuration value for key: [{}]\nExtra: \"2.2 99\"", key(line));
        refuses(&format!("{line}\t 2.2 99 \t"), &message);
    }
}

#[test]
fn the_first_wrong_line_counts() {
    refuses("gamma: x\nwidth", "Invalid value for key: [gamma:]\nLine: \"gamma: x\"");
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
