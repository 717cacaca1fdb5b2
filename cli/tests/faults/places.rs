//! Tests with outputs whose folder vanishes, or in which no file can be created.

use std::fs;
use std::time::Duration;

use crate::workshop::{PROGRAMS, Workshop, assert_refused};

#[test]
fn a_place_below_a_file_is_refused() {
    let workshop = Workshop::new("image_width: 8\n", "");
    for program in PROGRAMS {
        let output = workshop.command_with(program, ["config.txt", "scene.txt", "config.txt/out.ppm"]).output();
        assert_refused(&output.expect("the program runs"), "Cannot write file [config.txt/out.ppm]: Not a directory");
        // No user, not even root, can create a file there.
        let output = workshop.command_with(program, ["config.txt", "scene.txt", "/proc/out.ppm"]).output();
        assert_refused(&output.expect("the program runs"), "Cannot write file [/proc/out.ppm]: ");
        assert_eq!(fs::read(workshop.file("config.txt")).expect("it stands"), b"image_width: 8\n");
    }
}

#[test]
fn a_folder_that_vanishes_while_the_picture_is_made_is_an_error() {
    // Rendering takes so long that the folder vanishes before the end. If the folder vanished before the start, the
    // message would be the same.
    let config = "image_width: 400\naspect_ratio: 1 1\nsamples_per_pixel: 400\n";
    let workshop = Workshop::new(config, "matte: m .5 .5 .5\nsphere: 0 0 0 3 m\nsphere: 0 -103 0 100 m\n");
    for program in PROGRAMS {
        let child = workshop.command(program).spawn().expect("the program runs");
        std::thread::sleep(Duration::from_millis(100));
        fs::remove_dir(workshop.file("d")).expect("it is empty");
        let output = child.wait_with_output().expect("it ends");
        assert_refused(&output, "Cannot write file [d/out.ppm]: No such file or directory");
        assert!(!workshop.file("d").exists());
        fs::create_dir(workshop.file("d")).expect("the folder is writable");
    }
}
