//! Tests with inputs that are not ordinary files. The programs must refuse them with a message, and need little memory
//! for that.

use std::fs::{self, File, OpenOptions};
use std::io::Write;
use std::os::unix::fs::symlink;

use crate::workshop::{PROGRAMS, Workshop, assert_refused, running};

const SMALL: &str = "image_width: 8\nsamples_per_pixel: 1\n";

/// An address space in kilobytes that is enough to refuse any input.
const LITTLE: u64 = 64_000;

/// Checks that both programs refuse the file `name` for `reason`, both as configuration and as scene, within [`LITTLE`]
/// memory.
fn refuses(workshop: &Workshop, name: &str, reason: &str) {
    for program in PROGRAMS {
        for names in [[name, "scene.txt", "d/out.ppm"], ["config.txt", name, "d/out.ppm"]] {
            let output = workshop.limited(LITTLE, program, names).output().expect("the program runs");
            assert_refused(&output, &format!("Cannot read file [{name}]: {reason}"));
            assert!(workshop.outputs().is_empty());
        }
    }
}

#[test]
fn endless_input_is_refused() {
    let workshop = Workshop::new(SMALL, "");
    refuses(&workshop, "/dev/zero", "line 1 is longer than 1048576 bytes");
    symlink("/dev/zero", workshop.file("link")).expect("links are allowed");
    refuses(&workshop, "link", "line 1 is longer than 1048576 bytes");
}

#[test]
fn a_sparse_file_of_four_gigabytes_is_refused() {
    let workshop = Workshop::new(SMALL, "");
    for (name, start, line) in [("holes", "", 1), ("text-and-holes", "\n\n", 3)] {
        let mut file = File::create(workshop.file(name)).expect("the folder is writable");
        file.write_all(start.as_bytes()).expect("the folder is writable");
        file.set_len(4 << 30).expect("holes take no place");
        refuses(&workshop, name, &format!("line {line} is longer than 1048576 bytes"));
    }
}

#[test]
fn links_are_followed_and_loops_refused() {
    let workshop = Workshop::new(SMALL, "");
    let expected = workshop.render();
    symlink("config.txt", workshop.file("first")).expect("links are allowed");
    symlink("first", workshop.file("second")).expect("links are allowed");
    for program in PROGRAMS {
        let output = workshop.command_with(program, ["second", "scene.txt", "d/out.ppm"]).output();
        assert!(output.expect("the program runs").status.success());
        assert!(fs::read(workshop.file("d/out.ppm")).expect("it was written") == expected);
        fs::remove_file(workshop.file("d/out.ppm")).expect("it is ours");
    }
    symlink("loop", workshop.file("loop")).expect("links are allowed");
    refuses(&workshop, "loop", "Too many levels of symbolic links");
}

#[test]
fn a_fifo_is_read_to_its_end() {
    let workshop = Workshop::new(SMALL, "");
    let expected = workshop.render();
    nix::unistd::mkfifo(&workshop.file("fifo"), nix::sys::stat::Mode::S_IRWXU).expect("the folder is writable");
    for program in PROGRAMS {
        let mut child = running(&mut workshop.command_with(program, ["fifo", "scene.txt", "d/out.ppm"]));
        // The text is written in two pieces. The first piece ends within a line.
        let mut fifo = OpenOptions::new().write(true).open(workshop.file("fifo")).expect("the program reads");
        fifo.write_all(&SMALL.as_bytes()[..5]).expect("the program reads");
        std::thread::sleep(std::time::Duration::from_millis(20));
        fifo.write_all(&SMALL.as_bytes()[5..]).expect("the program reads");
        drop(fifo);
        assert!(child.wait().expect("it ends").success());
        assert!(fs::read(workshop.file("d/out.ppm")).expect("it was written") == expected);
    }
}

#[test]
fn a_file_that_the_system_cannot_read_is_named() {
    let workshop = Workshop::new(SMALL, "");
    // The program would read memory at address 0, which no process has, so the system returns an error.
    refuses(&workshop, "/proc/self/mem", "");
    refuses(&workshop, "config.txt/below", "Not a directory");
    let long = "x".repeat(300);
    refuses(&workshop, &long, "File name too long");
}
