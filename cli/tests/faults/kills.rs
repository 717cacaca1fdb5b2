//! Tests that end the programs by signals at random moments.

use std::fs;
use std::process::Stdio;
use std::time::{Duration, Instant};

use cpu::internals::sampling::uniform::Uniform;
use nix::sys::signal::Signal;

use crate::workshop::{PROGRAMS, Workshop, running, send, signal_of};

/// A configuration for a picture of the background alone. A large part of its time is spent on writing.
const CONFIG: &str = "image_width: 500\naspect_ratio: 1 1\nsamples_per_pixel: 1\n";

/// Number of times that each signal ends each program while it runs.
const KILLS: u32 = 100;

/// Sends `signal` to runs of a program at random moments, until it has ended [`KILLS`] runs. Returns three numbers: how
/// many of these runs left the old picture, how many left the new picture, and how many temporary files were left.
fn killed(program: &str, signal: Signal, seed: u64) -> [u32; 3] {
    let workshop = Workshop::new(CONFIG, "");
    let new = workshop.render();
    let out = workshop.file("d/out.ppm");
    let mut moments = Uniform::new(seed);
    let (mut kills, mut tries) = (0, 0);
    let [mut old_stood, mut new_stood, mut left] = [0; 3];
    // The moments are spread over the time of an undisturbed run. Late moments hit the writing, the renaming and the
    // end of the process.
    let start = Instant::now();
    assert!(workshop.command(program).status().expect("the program runs").success());
    let whole = start.elapsed();
    while kills < KILLS {
        tries += 1;
        assert!(tries < 100 * KILLS, "the signal ended only {kills} of {tries} runs");
        fs::write(&out, "old").expect("the folder is writable");
        let mut child = running(workshop.command(program).stdout(Stdio::null()));
        std::thread::sleep(whole.mul_f64(moments.canonical()));
        send(&child, signal);
        let status = child.wait().expect("it ends");
        match signal_of(status) {
            Some(ended_by) => assert_eq!(ended_by, signal),
            None => assert!(status.success(), "{status}"),
        }
        let was_killed = signal_of(status).is_some();
        kills += u32::from(was_killed);
        let picture = fs::read(&out).expect("a picture stands");
        if picture == b"old" {
            assert!(was_killed, "it ended well and wrote nothing");
            old_stood += 1;
        } else {
            assert!(picture == new, "{} bytes that are neither the old picture nor the new", picture.len());
            new_stood += 1;
        }
        for name in workshop.outputs() {
            if name != "out.ppm" {
                assert!(name.starts_with(".render-") && name.ends_with(".tmp"), "{name}");
                fs::remove_file(workshop.file("d").join(name)).expect("it is ours");
                left += 1;
            }
        }
    }
    println!("{signal} {kills} times: {old_stood} old, {new_stood} new pictures, {left} temporary files left");
    [old_stood, new_stood, left]
}

#[test]
fn after_a_kill_the_old_picture_stands_or_the_new_one() {
    for (seed, program) in PROGRAMS.into_iter().enumerate() {
        let [old, ..] = killed(program, Signal::SIGKILL, 1 + seed as u64);
        assert!(old > 0, "no kill came before the end");
    }
}

#[test]
fn after_a_request_to_stop_nothing_else_is_left() {
    for (seed, program) in PROGRAMS.into_iter().enumerate() {
        let [old, _, left] = killed(program, Signal::SIGTERM, 11 + seed as u64);
        assert!(old > 0, "no request came before the end");
        assert_eq!(left, 0);
    }
}

#[test]
fn a_program_that_waits_for_its_input_can_be_stopped() {
    let workshop = Workshop::new("", "");
    let fifo = workshop.file("never");
    nix::unistd::mkfifo(&fifo, nix::sys::stat::Mode::S_IRWXU).expect("the folder is writable");
    for program in PROGRAMS {
        let mut child = running(&mut workshop.command_with(program, ["never", "scene.txt", "d/out.ppm"]));
        std::thread::sleep(Duration::from_millis(50));
        assert!(child.try_wait().expect("it is ours").is_none(), "it ended without an input");
        send(&child, Signal::SIGTERM);
        assert_eq!(signal_of(child.wait().expect("it ends")), Some(Signal::SIGTERM));
        assert!(workshop.outputs().is_empty());
    }
}
