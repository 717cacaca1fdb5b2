//! Two programs that write the same file at the same time.

use std::fs;
use std::io::Read;

use crate::workshop::{PROGRAMS, Workshop, running};

/// How many times both programs run together.
const PAIRS: usize = 100;

/// A picture of `width` columns and rows of the background. Pictures of different sizes can be told apart.
fn config(width: usize) -> String {
    format!("image_width: {width}\naspect_ratio: 1 1\nsamples_per_pixel: 1\n")
}

#[test]
fn two_programs_that_write_one_file_leave_one_whole_picture_and_nothing_else() {
    let workshop = Workshop::new(config(120), "");
    let small = workshop.render();
    fs::write(workshop.file("large.txt"), config(150)).expect("the folder is writable");
    let large_names = ["large.txt", "scene.txt", "d/out.ppm"];
    assert!(workshop.command_with(PROGRAMS[1], large_names).status().expect("the program runs").success());
    let large = fs::read(workshop.file("d/out.ppm")).expect("it was written");
    let mut larger = 0;
    for pair in 0..PAIRS {
        // In every second pair there is no old picture.
        if pair % 2 == 0 {
            fs::remove_file(workshop.file("d/out.ppm")).expect("it is ours");
        } else {
            fs::write(workshop.file("d/out.ppm"), "old").expect("the folder is writable");
        }
        let mut programs = [
            running(&mut workshop.command(PROGRAMS[pair / 2 % 2])),
            running(&mut workshop.command_with(PROGRAMS[(pair / 2 + 1) % 2], large_names)),
        ];
        for program in &mut programs {
            let mut message = String::new();
            let stderr = program.stderr.take();
            stderr.expect("it is a pipe").read_to_string(&mut message).expect("messages are text");
            let status = program.wait().expect("it ends");
            assert!(status.success(), "pair {pair}: {status}: {message}");
        }
        let picture = fs::read(workshop.file("d/out.ppm")).expect("it was written");
        assert!(picture == small || picture == large, "pair {pair}: {} bytes", picture.len());
        larger += usize::from(picture == large);
        assert_eq!(workshop.outputs(), ["out.ppm"], "pair {pair}");
    }
    println!("the larger picture was left by {larger} of {PAIRS} pairs");
}
