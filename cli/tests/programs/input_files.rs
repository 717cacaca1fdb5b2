//! Tests of inputs that are unusual text, no text, or not files.

use std::fs;

use crate::bench::{Bench, PROGRAMS, SMALL, assert_failed};

#[test]
fn crlf_blank_lines_tabs_and_a_missing_last_line_end_change_nothing() {
    let config = "image_width: 8\nsamples_per_pixel: 2\ncamera_position: 0 0 -3";
    let scene = "matte: grey .5 .5 .5\nsphere: 0 0 0 1 grey";
    let plain = Bench::new(config, scene).render();
    let dressed = |text: &str| format!("\r\n \t\r\n\t{}\t\r\n\r\n", text.replace(' ', " \t ").replace('\n', "\r\n"));
    assert!(Bench::new(dressed(config), dressed(scene)).render() == plain);
}

#[test]
fn invalid_utf8_is_shown_byte_for_byte() {
    Bench::new(b"\xff\0: 1", "").refuses(b"Unknown configuration key: [\xff\0:]");
    let line = b"sphere: 0 0 0 1 \xc3\x28";
    Bench::new(SMALL, line).refuses(&[b"Material not found: [\xc3\x28]\nLine: \"".as_slice(), line, b"\""].concat());
}

/// Checks that control characters are escaped on a terminal, which would obey them. Through a pipe the bytes are
/// unchanged.
#[cfg(unix)]
#[test]
fn control_characters_are_escaped_on_a_terminal() {
    use std::io::Read;
    use std::process::Stdio;

    let bench = Bench::new(b"\x1b[2J\x9b: 1\x07", "");
    bench.refuses(b"Unknown configuration key: [\x1b[2J\x9b:]");
    let bench = Bench::new(b"gamma: \x1b[31m\r2", "");
    for program in PROGRAMS {
        let terminal = nix::pty::openpty(None, None).expect("the system has terminals");
        let mut command = bench.command(program, "out\x1b.ppm");
        let mut child = command.stderr(Stdio::from(terminal.slave)).spawn().expect("the program runs");
        // The command holds the terminal's other end open.
        drop(command);
        assert_eq!(child.wait().expect("it ends").code(), Some(1));
        let mut shown = Vec::new();
        // Reading a terminal ends with an error when its other end is closed.
        let _ = fs::File::from(terminal.master).read_to_end(&mut shown);
        let expected = "Error: Invalid value for key: [gamma:]\r\nLine: \"gamma: \\u{1b}[31m\\r2\"\r\n";
        assert_eq!(String::from_utf8_lossy(&shown), expected);
    }
}

#[test]
fn gigantic_numbers_are_invalid_and_long_ones_are_read() {
    let digits = "9".repeat(100_000);
    let line = format!("sphere: 0 0 {digits} 1 m");
    Bench::new(SMALL, &line).refuses(format!("Invalid sphere parameters\nLine: \"{line}\"").as_bytes());
    let line = format!("image_width: {digits}");
    Bench::new(&line, "").refuses(format!("Invalid value for key: [image_width:]\nLine: \"{line}\"").as_bytes());
    let fraction = format!("gamma: 2.{digits}\n{SMALL}");
    assert!(!Bench::new(fraction, "").render().is_empty());
}

#[test]
fn faults_of_the_configuration_are_reported_first() {
    let bench = Bench::new("width", "triangle");
    bench.refuses(b"Unknown configuration key: [width:]");
    for program in PROGRAMS {
        let output = bench.command(program, "no/such/folder.ppm").output().expect("the program runs");
        assert_failed(&output);
        assert!(output.stderr.starts_with(b"Error: Unknown configuration key"), "{output:?}");
    }
}

#[test]
fn a_file_that_is_missing_or_a_folder_is_named() {
    for (name, is_folder) in [("config.txt", false), ("scene.txt", false), ("config.txt", true), ("scene.txt", true)] {
        let bench = Bench::new(SMALL, "");
        fs::remove_file(bench.file(name)).expect("it is ours");
        if is_folder {
            fs::create_dir(bench.file(name)).expect("the folder is writable");
        }
        let message = bench.message();
        assert!(message.starts_with(&format!("Error: Cannot read file [{name}]: ")), "{message}");
        assert!(bench.outputs().is_empty());
    }
}
