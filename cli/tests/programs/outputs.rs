//! Where the picture goes, and that it goes there whole or not at all.

use std::fs::{self, File};
use std::process::{Output, Stdio};

use crate::bench::{Bench, PROGRAMS, SMALL, assert_failed, assert_succeeded};

/// A picture of 22,500 pixels takes more than a pipe holds.
const LARGE: &str = "image_width: 150\naspect_ratio: 1 1\nsamples_per_pixel: 1\n";

fn run(bench: &Bench, program: &str, out: &str) -> Output {
    bench.command(program, out).output().expect("the program runs")
}

fn assert_cannot_write(output: &Output, out: &str, reason: &str) {
    assert_failed(output);
    let stderr = String::from_utf8_lossy(&output.stderr);
    let expected = format!("Error: Cannot write file [{out}]: {reason}");
    assert!(stderr.starts_with(&expected), "{stderr} instead of {expected}");
}

#[test]
fn an_old_picture_is_replaced_whole() {
    let bench = Bench::new(SMALL, "");
    let expected = bench.render();
    for program in PROGRAMS {
        fs::write(bench.path("out.ppm"), vec![b'x'; 2 * expected.len()]).expect("the folder is writable");
        assert_succeeded(&run(&bench, program, "out.ppm"));
        assert!(fs::read(bench.path("out.ppm")).expect("it was written") == expected);
        assert_eq!(bench.outputs(), ["out.ppm"]);
    }
}

#[test]
fn a_missing_folder_is_refused() {
    let bench = Bench::new(SMALL, "");
    for program in PROGRAMS {
        assert_cannot_write(&run(&bench, program, "no/out.ppm"), "no/out.ppm", "No such file or directory");
        assert!(bench.outputs().is_empty());
    }
}

#[test]
fn a_folder_is_not_replaced() {
    let bench = Bench::new(SMALL, "");
    fs::create_dir(bench.path("folder")).expect("the folder is writable");
    for program in PROGRAMS {
        assert_cannot_write(&run(&bench, program, "folder"), "folder", "is a directory");
        assert_cannot_write(&run(&bench, program, ""), "", "");
        assert_eq!(bench.outputs(), ["folder"]);
    }
}

#[cfg(unix)]
#[test]
fn a_link_stays_a_link_to_the_new_picture() {
    use std::os::unix::fs::symlink;

    let bench = Bench::new(SMALL, "");
    let expected = bench.render();
    fs::create_dir(bench.path("folder")).expect("the folder is writable");
    symlink("folder/out.ppm", bench.path("link.ppm")).expect("links are allowed");
    for program in PROGRAMS {
        // First dangling, then to an old picture.
        for old in [None, Some("old")] {
            match old {
                None => drop(fs::remove_file(bench.path("folder/out.ppm"))),
                Some(old) => fs::write(bench.path("folder/out.ppm"), old).expect("the folder is writable"),
            }
            assert_succeeded(&run(&bench, program, "link.ppm"));
            assert!(bench.path("link.ppm").is_symlink());
            assert!(fs::read(bench.path("folder/out.ppm")).expect("it was written") == expected);
            assert_eq!(bench.outputs(), ["folder", "link.ppm"]);
        }
    }
}

#[cfg(unix)]
#[test]
fn a_full_device_is_an_error_and_a_null_device_is_not() {
    let bench = Bench::new(SMALL, "");
    for program in PROGRAMS {
        assert_cannot_write(&run(&bench, program, "/dev/full"), "/dev/full", "No space left on device");
        assert_succeeded(&run(&bench, program, "/dev/null"));
        assert!(bench.outputs().is_empty());
    }
}

#[cfg(unix)]
#[test]
fn standard_output_takes_the_picture_through_a_pipe_and_into_a_file() {
    let bench = Bench::new(LARGE, "");
    let expected = bench.render();
    assert!(expected.len() > 1 << 16);
    for program in PROGRAMS {
        let output = run(&bench, program, "/dev/stdout");
        assert!(output.status.success() && output.stderr.is_empty(), "{output:?}");
        assert!(output.stdout == expected);

        let file = File::create(bench.path("redirected")).expect("the folder is writable");
        let status = bench.command(program, "/dev/stdout").stdout(file).status().expect("the program runs");
        assert!(status.success());
        assert!(fs::read(bench.path("redirected")).expect("it was written") == expected);
        assert_eq!(bench.outputs(), ["redirected"]);
    }
}

#[cfg(unix)]
#[test]
fn a_reader_that_is_gone_is_an_error() {
    let bench = Bench::new(LARGE, "");
    for program in PROGRAMS {
        let (reader, writer) = std::io::pipe().expect("a pipe is made");
        drop(reader);
        let mut command = bench.command(program, "/dev/stdout");
        let child = command.stdout(writer).stderr(Stdio::piped()).spawn().expect("the program runs");
        let output = child.wait_with_output().expect("it ends");
        assert_cannot_write(&output, "/dev/stdout", "Broken pipe");
    }
}

#[cfg(unix)]
#[test]
fn a_closed_standard_error_still_leaves_the_status() {
    let bench = Bench::new("width", "");
    for program in PROGRAMS {
        let (reader, writer) = std::io::pipe().expect("a pipe is made");
        drop(reader);
        let status = bench.command(program, "out.ppm").stderr(writer).status().expect("the program runs");
        assert_eq!(status.code(), Some(1));
    }
}
