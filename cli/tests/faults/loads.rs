//! Tests of very large inputs, depths, numbers of samples, and pictures.

use std::fmt::Write;
use std::fs;
use std::process::Child;
use std::time::{Duration, Instant};

use nix::sys::signal::Signal;

use crate::workshop::{NAMES, PROGRAMS, Workshop, assert_refused, running, send, signal_of};

/// Returns the text of a scene with `count` spheres in a cube.
fn spheres(count: usize) -> String {
    let mut scene = String::from("matte: m .5 .5 .5\n");
    for index in 0..count {
        let [x, y, z] = [7919, 104_729, 1_299_709].map(|step| (index * step % 1_000_003) as f64 / 1e5 - 5.0);
        writeln!(scene, "sphere: {x} {y} {z} .004 m").expect("a string takes all text");
    }
    scene
}

/// Returns the peak resident memory of a running process so far, in kilobytes.
fn peak(child: &Child) -> u64 {
    let status = fs::read_to_string(format!("/proc/{}/status", child.id())).expect("it runs");
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:")).expect("it has memory");
    line.trim().trim_end_matches(" kB").parse().expect("it is a number")
}

#[test]
fn an_error_on_the_last_of_a_million_lines_is_found_in_proportionate_time() {
    let time = |lines: usize| {
        let workshop = Workshop::new("image_width: 1\n", spheres(lines - 1) + "sphere: 0 0 0 1 nothing");
        let mut least = Duration::MAX;
        for program in PROGRAMS {
            let start = Instant::now();
            let output = workshop.command(program).output().expect("the program runs");
            least = least.min(start.elapsed());
            assert_refused(&output, "Material not found: [nothing]\nLine: \"sphere: 0 0 0 1 nothing\"\n");
        }
        least
    };
    let (some, many) = (time(100_000), time(1_000_000));
    println!("100,000 lines: {some:?}; 1,000,000 lines: {many:?}");
    assert!(many < 60 * some, "ten times the lines took {many:?} instead of {some:?}");
}

#[test]
fn any_depth_and_any_number_of_samples_start_and_can_be_interrupted() {
    // Inside a perfect mirror every path continues until the maximum depth.
    let scene = "metal: mirror 1 1 1 0\nsphere: 0 0 0 5 mirror\n";
    for (samples, depth) in [(i32::MAX as u64, i32::MAX as u64), (u64::MAX, u64::MAX), (u64::MAX, 1), (1, u64::MAX)] {
        let config = format!(
            "image_width: 1\naspect_ratio: 1 1\nsamples_per_pixel: {samples}\nmax_depth: {depth}\n\
             camera_position: 0 0 -1\n"
        );
        let workshop = Workshop::new(config, scene);
        fs::write(workshop.file("d/out.ppm"), "old").expect("the folder is writable");
        for program in PROGRAMS {
            let mut child = running(&mut workshop.command(program));
            std::thread::sleep(Duration::from_millis(300));
            let ended = child.try_wait().expect("it is ours");
            assert!(ended.is_none(), "{samples} samples, depth {depth}: {ended:?}");
            // The program keeps 8 bytes for each surface that the path has hit. In the time waited it hits some
            // millions. It reserves no memory for surfaces that the path may hit later.
            let peak = peak(&child);
            assert!(peak < 300_000, "{peak} kB for one pixel");
            // SIGTERM, because a program that a shell starts in the background may ignore SIGINT.
            send(&child, Signal::SIGTERM);
            assert_eq!(signal_of(child.wait().expect("it ends")), Some(Signal::SIGTERM));
            assert_eq!(workshop.outputs(), ["out.ppm"]);
            assert_eq!(fs::read(workshop.file("d/out.ppm")).expect("it stands"), b"old");
        }
    }
}

#[test]
fn a_picture_one_pixel_too_large_is_refused_before_any_memory_is_taken() {
    // A picture may have up to 2^30 pixels. Larger ones are refused, however much memory the machine has.
    let workshop = Workshop::new("image_width: 32769\naspect_ratio: 32769 32768\n", "");
    for program in PROGRAMS {
        let output = workshop.limited(64_000, program, NAMES).output().expect("the program runs");
        assert_refused(&output, "Invalid configuration [config.txt]: the image is too large to hold: 32769 x 32768");
    }
}

/// Renders with both programs in an address space limited to `kilobytes`, and returns the size of the picture's file in
/// bytes.
fn renders_within(kilobytes: u64, config: &str, scene: &str) -> u64 {
    let workshop = Workshop::new(config, scene);
    let mut length = 0;
    for program in PROGRAMS {
        let start = Instant::now();
        let output = workshop.limited(kilobytes, program, NAMES).output().expect("the program runs");
        assert!(output.status.success() && output.stderr.is_empty(), "{output:?}");
        println!("{program}: {:?} within {kilobytes} kB", start.elapsed());
        length = fs::metadata(workshop.file("d/out.ppm")).expect("it was written").len();
    }
    length
}

#[test]
#[ignore = "writes 3 GB and takes a minute"]
fn a_picture_of_16384_by_16384_pixels_fits_in_900_megabytes() {
    let config = "image_width: 16384\naspect_ratio: 1 1\nsamples_per_pixel: 1\n";
    let scene = "matte: m .5 .5 .5\nsphere: 0 0 0 3 m\nsphere: 0 -103 0 100 m\n";
    let length = renders_within(900_000, config, scene);
    assert!(length > 6 * (1 << 28), "{length} bytes for 2^28 pixels");
}

#[test]
#[ignore = "takes a minute"]
fn a_million_objects_fit_in_a_gigabyte() {
    let config = "image_width: 64\nsamples_per_pixel: 1\n";
    let length = renders_within(1_000_000, config, &spheres(1_000_000));
    assert!(length > 6 * 64 * 36, "{length} bytes");
}
