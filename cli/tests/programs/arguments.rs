//! Tests of the number of arguments, and of unusual names in arguments.

use std::process::Command;

use crate::bench::{Bench, PROGRAMS, SMALL, assert_failed, assert_succeeded};

#[test]
fn any_other_number_of_arguments_than_three_is_refused() {
    let bench = Bench::new(SMALL, "");
    let arguments = ["config.txt", "scene.txt", "out.ppm", "extra", "more"];
    for program in PROGRAMS {
        for count in [0, 1, 2, 4, 5] {
            let output = Command::new(program)
                .current_dir(bench.file(""))
                .args(&arguments[..count])
                .output()
                .expect("the program runs");
            assert_failed(&output);
            let expected = format!("Error: Invalid number of arguments: {count}\n");
            assert_eq!(String::from_utf8_lossy(&output.stderr), expected);
            assert!(bench.outputs().is_empty());
        }
    }
}

#[test]
fn arguments_that_look_like_options_are_names() {
    let bench = Bench::new(SMALL, "");
    for program in PROGRAMS {
        let output = bench.command(program, "--help").output().expect("the program runs");
        assert_succeeded(&output);
        assert_eq!(bench.outputs(), ["--help"]);
    }
}

#[cfg(unix)]
#[test]
fn names_need_not_be_utf8() {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt;

    let bench = Bench::new(SMALL, "");
    let name = OsStr::from_bytes(b"\xff.txt");
    for program in PROGRAMS {
        let output = Command::new(program)
            .current_dir(bench.file(""))
            .args([name, OsStr::new("scene.txt"), OsStr::new("out.ppm")])
            .output()
            .expect("the program runs");
        assert_failed(&output);
        assert!(output.stderr.starts_with(b"Error: Cannot read file [\xff.txt]: "), "{output:?}");
    }
}
