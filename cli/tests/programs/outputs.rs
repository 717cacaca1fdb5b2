//! Tests of where the picture is written, and that it is written completely or not at all.

use std::fs::{self, File};
use std::process::{Command, Output, Stdio};

use crate::bench::{Bench, PROGRAMS, SMALL, assert_failed, assert_succeeded};

/// A configuration for a picture of 22,500 pixels. Its file is larger than the buffer of a pipe.
const LARGE: &str = "image_width: 150\naspect_ratio: 1 1\nsamples_per_pixel: 1\n";

fn run(bench: &Bench, program: &str, out: &str) -> Output {
    bench.command(program, out).output().expect("the program runs")
}

/// A configuration whose rendering takes much longer than one minute, the time limit of these tests. So the output must
/// be refused before rendering.
const ENDLESS: &str = "samples_per_pixel: 4000000000\n";

/// Runs a program from bash, with a redirection, for at most one minute.
fn run_promptly(bench: &Bench, program: &str, out: &str, redirection: &str) -> Output {
    let script = format!("exec timeout 60 \"$0\" config.txt scene.txt {out} {redirection}");
    let output = test_support::running::bash().current_dir(bench.file("")).args(["-c", &script, program]).output();
    output.expect("the program runs")
}

fn assert_cannot_write(output: &Output, out: &str, reason: &str) {
    assert_failed(output);
    let stderr = String::from_utf8_lossy(&output.stderr);
    let expected = format!("Error: Cannot write file [{out}]: {reason}");
    assert!(stderr.starts_with(&expected), "{stderr} instead of {expected}");
}

#[cfg(unix)]
#[test]
fn bad_outputs_are_refused_before_rendering() {
    let bench = Bench::new(ENDLESS, "");
    fs::create_dir(bench.file("folder")).expect("the folder is writable");
    std::os::unix::fs::symlink("/dev/stdout", bench.file("link")).expect("links are allowed");
    let _socket = std::os::unix::net::UnixListener::bind(bench.file("socket")).expect("the folder is writable");
    let mut cases = vec![
        ("no/out.ppm", "", "No such file or directory"),
        ("folder", "", "Is a directory"),
        ("''", "", ""),
        ("socket", "", "No such device or address"),
        ("config.txt/out.ppm", "", "Not a directory"),
        // No user, not even root, can create a file there.
        ("/proc/out.ppm", "", ""),
    ];
    for out in ["/dev/stdout", "/dev/fd/1", "/proc/self/fd/1", "link"] {
        cases.push((out, ">&-", "standard output is closed"));
        cases.push((out, "1</dev/null", "standard output is open for"));
    }
    for program in PROGRAMS {
        for (out, redirection, reason) in &cases {
            let output = run_promptly(&bench, program, out, redirection);
            assert_cannot_write(&output, out.trim_matches('\''), reason);
        }
        assert_eq!(bench.outputs(), ["folder", "link", "socket"]);
    }
}

#[test]
fn a_folder_that_vanishes_while_the_picture_is_made_is_an_error() {
    // Rendering takes so long that the folder vanishes before the end. If the folder vanished before the start, the
    // message would be the same.
    let config = "image_width: 400\naspect_ratio: 1 1\nsamples_per_pixel: 400\n";
    let bench = Bench::new(config, "matte: m .5 .5 .5\nsphere: 0 0 0 3 m\nsphere: 0 -103 0 100 m\n");
    for program in PROGRAMS {
        fs::create_dir(bench.file("d")).expect("the folder is writable");
        let mut command = bench.command(program, "d/out.ppm");
        let child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the program runs");
        std::thread::sleep(std::time::Duration::from_millis(100));
        fs::remove_dir(bench.file("d")).expect("it is empty");
        assert_cannot_write(&child.wait_with_output().expect("it ends"), "d/out.ppm", "No such file or directory");
        assert!(bench.outputs().is_empty());
    }
}

#[cfg(unix)]
#[test]
fn an_output_that_is_an_input_is_refused_before_it_is_read() {
    use std::os::unix::fs::symlink;

    // Both inputs have faults, but the output must be refused before they are read.
    let bench = Bench::new("no key", "no entity");
    symlink("scene.txt", bench.file("link")).expect("links are allowed");
    fs::hard_link(bench.file("config.txt"), bench.file("hard")).expect("links are allowed");
    for program in PROGRAMS {
        for (out, input) in [("scene.txt", "scene.txt"), ("link", "scene.txt"), ("hard", "config.txt")] {
            let reason = format!("it is the same file as the input [{input}]; choose another file for the output\n");
            assert_cannot_write(&run(&bench, program, out), out, &reason);
        }
        assert_eq!(fs::read(bench.file("config.txt")).expect("it stands"), b"no key");
        assert_eq!(fs::read(bench.file("scene.txt")).expect("it stands"), b"no entity");
        assert_eq!(bench.outputs(), ["hard", "link"]);
    }
}

#[cfg(unix)]
#[test]
fn a_new_picture_obeys_the_mask_of_the_process() {
    use std::os::unix::fs::PermissionsExt;

    let bench = Bench::new(SMALL, "");
    for program in PROGRAMS {
        for (mask, mode) in [("077", 0o600), ("027", 0o640), ("000", 0o666)] {
            let script = format!("umask {mask}; exec \"$0\" config.txt scene.txt out.ppm");
            let output =
                test_support::running::bash().current_dir(bench.file("")).args(["-c", &script, program]).output();
            assert_succeeded(&output.expect("the program runs"));
            let new = fs::metadata(bench.file("out.ppm")).expect("it was written").permissions().mode();
            assert_eq!(new & 0o7777, mode, "{mask}");
            fs::remove_file(bench.file("out.ppm")).expect("it is ours");
        }
    }
}

#[cfg(unix)]
#[test]
fn a_device_may_be_input_and_output() {
    let bench = Bench::new(SMALL, "");
    for program in PROGRAMS {
        let output =
            Command::new(program).current_dir(bench.file("")).args(["config.txt", "/dev/null", "/dev/null"]).output();
        assert_succeeded(&output.expect("the program runs"));
    }
}

#[cfg(unix)]
#[test]
fn standard_output_takes_the_picture_through_a_pipe_into_a_file_and_after_other_text() {
    let bench = Bench::new(LARGE, "");
    let expected = bench.render();
    assert!(expected.len() > 1 << 16);
    for program in PROGRAMS {
        let output = run(&bench, program, "/dev/stdout");
        assert!(output.status.success() && output.stderr.is_empty(), "{output:?}");
        assert!(output.stdout == expected);

        for (append, before) in [(false, ""), (true, "before\n")] {
            bench.write("redirected", before);
            let file = File::options().write(true).append(append).open(bench.file("redirected")).expect("it is ours");
            let status = bench.command(program, "/dev/stdout").stdout(file).status().expect("the program runs");
            assert!(status.success());
            assert!(bench.read("redirected") == [before.as_bytes(), &expected].concat());
        }
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
