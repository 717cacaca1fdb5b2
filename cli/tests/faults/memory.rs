//! Tests that run the programs with more and more memory or stack, until it is enough.

use std::fmt::Write;
use std::fs;

use crate::workshop::{NAMES, PROGRAMS, Workshop};

/// Returns the text of a scene with `count` materials, spheres and cylinders, in a long row.
fn scene(count: usize) -> String {
    let mut scene = String::new();
    for index in 0..count {
        writeln!(scene, "matte: m{index} .5 .5 .5").expect("a string takes all text");
        let place = index as f64;
        writeln!(scene, "sphere: {place} 1 2 .3 m{index}").expect("a string takes all text");
        writeln!(scene, "cylinder: {place} 5 2 .3 0 1 .1 m{index}").expect("a string takes all text");
    }
    scene
}

#[test]
fn with_too_little_memory_the_programs_say_so_and_never_die() {
    // The camera looks away from the objects, and the picture has 90,000 pixels.
    say_so_and_never_die(
        "image_width: 300\naspect_ratio: 1 1\nsamples_per_pixel: 1\n\
         camera_position: 0 0 -10\ncamera_target: 0 0 -20\n",
    );
}

#[test]
fn with_too_little_memory_for_all_that_is_in_view_the_programs_say_so_and_never_die() {
    // The camera looks along the row, so that every ray may hit all objects.
    say_so_and_never_die(
        "image_width: 4\naspect_ratio: 1 1\nsamples_per_pixel: 1\n\
         camera_position: -100 3 2\ncamera_target: 0 3 2\nfield_of_view: 90\n",
    );
}

fn say_so_and_never_die(config: &str) {
    let (empty, workshop) = (Workshop::new("image_width: 1\n", ""), Workshop::new(config, scene(10_000)));
    for program in PROGRAMS {
        // The smallest address space in which the program renders an empty scene, plus 500 kB. With less, the system
        // cannot even start it.
        let runs =
            |kilobytes| empty.limited(kilobytes, program, NAMES).output().expect("the program runs").status.success();
        let least = (4_000..200_000).step_by(500).find(|&limit| runs(limit)).expect("so much is enough") + 500;
        let (mut refused, mut kilobytes) = (0, least);
        loop {
            let output = workshop.limited(kilobytes, program, NAMES).output().expect("the program runs");
            if output.status.success() {
                break;
            }
            let stderr = String::from_utf8_lossy(&output.stderr);
            let says_so = stderr.starts_with("Error: Not enough memory for ") || stderr.contains("]: out of memory");
            assert!(output.status.code() == Some(1) && says_so, "at {kilobytes} kB: {output:?}");
            assert!(workshop.outputs().is_empty());
            refused += 1;
            // This step is small enough that a run ends in each of the large allocations.
            kilobytes += 90;
            assert!(kilobytes < least + 200_000, "so much is enough");
        }
        println!("refused {refused} times from {least} to {kilobytes} kB");
        assert!(refused >= 5, "only {refused} steps");
        fs::remove_file(workshop.file("d/out.ppm")).expect("it was written");
    }
}

#[test]
fn a_stack_suffices_or_is_refused_with_a_message() {
    let scene: String =
        (0..2000).map(|index| format!("sphere: {} {} 0 .4 m\n", index % 50 - 25, index / 50 - 20)).collect();
    let config = "image_width: 40\nsamples_per_pixel: 2\ncamera_position: 0 0 30\ncamera_target: 0 0 0\n";
    let workshop = Workshop::new(config, format!("matte: m .5 .5 .5\n{scene}"));
    let expected = workshop.render();
    for program in PROGRAMS {
        let (mut refused, mut rendered) = (0, 0);
        // With less than 64 KiB the system cannot start every program. From 1024 KiB on no exact room is known.
        for kibibytes in (64..400).step_by(2).chain([1020, 1024]) {
            let output = workshop.after(&format!("ulimit -s {kibibytes}"), program, NAMES).output();
            let output = output.expect("the program runs");
            if output.status.success() {
                assert!(fs::read(workshop.file("d/out.ppm")).expect("it was written") == expected, "{kibibytes}");
                fs::remove_file(workshop.file("d/out.ppm")).expect("it is ours");
                rendered += 1;
                continue;
            }
            let stderr = String::from_utf8_lossy(&output.stderr);
            let says_so = stderr.starts_with("Error: The stack is too small: ") && stderr.contains("ulimit -s 8192");
            assert!(output.status.code() == Some(1) && says_so, "with {kibibytes} KiB: {output:?}");
            assert!(kibibytes < 320, "320 KiB must suffice in all builds");
            refused += 1;
        }
        println!("refused with {refused} sizes, rendered with {rendered}");
        assert!(refused > 20 && rendered >= 42);
    }
}
