//! Tests of pictures that are made in several runs.

use std::fs;
use std::time::Duration;

use test_support::folder::Folder;

use crate::{complaint, lab, printed, run};

const GRID: [&str; 2] = ["scenes/grid/config.txt", "scenes/grid/scene.txt"];

/// Returns the arguments that render the scene `grid` with `width` pixels in a row into `out`.
fn arguments<'a>(out: &'a str, width: &'a str, options: &[&'a str]) -> Vec<&'a str> {
    [&["render", GRID[0], GRID[1], out, "--quiet", "--no-sync", "--set", width][..], options].concat()
}

#[test]
fn a_run_that_is_killed_at_random_moments_always_goes_on_to_the_same_bytes() {
    let kills = test_support::number_of("RENDER_CASES").unwrap_or(10) as usize;
    let seed = std::time::UNIX_EPOCH.elapsed().map_or(1, |time| time.as_nanos() as u64) | 1;
    let mut random = seed;
    let folder = Folder::new();
    let names = ["whole.ppm", "out.ppm", "keep"].map(|name| folder.name(name));
    let [whole, out, keep] = names.each_ref().map(String::as_str);
    let (mut killed, mut resumed) = (0, 0);
    for round in 0.. {
        let convention = ["--scatter", ["statement", "published"][round % 2]];
        printed(&arguments(whole, "image_width=200", &convention));
        while !fs::exists(out).expect("the folder is ours") {
            let is_there = fs::exists(keep).expect("the folder is ours");
            let how = [if is_there { "--resume" } else { "--checkpoint" }, keep, "--checkpoint-every", "0s"];
            let layout = ["--layout", ["aos", "soa"][(killed + round) % 2]];
            let options = [&how[..], &convention, &layout].concat();
            let mut child = lab(&arguments(out, "image_width=200", &options)).spawn().expect("the program runs");
            random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            if killed < kills {
                std::thread::sleep(Duration::from_micros((random >> 33) % 200_000));
                child.kill().expect("it is ours");
            }
            let status = child.wait().expect("it is ours");
            // A process that was killed has no code.
            assert!(status.success() || status.code().is_none(), "seed {seed}: {status}");
            killed += usize::from(!status.success());
            resumed += usize::from(is_there);
        }
        assert!(fs::read(out).expect("it is there") == fs::read(whole).expect("it is there"), "seed {seed}");
        fs::remove_file(out).and_then(|()| fs::remove_file(keep)).expect("they are ours");
        if killed >= kills {
            break;
        }
    }
    println!("{killed} kills, resumed {resumed} times");
    assert!(resumed > kills / 4, "{resumed} of {killed}");
}

#[test]
fn a_run_stops_where_it_is_told_and_says_how_to_go_on() {
    let folder = Folder::new();
    let names = ["whole.ppm", "out.ppm", "keep"].map(|name| folder.name(name));
    let [whole, out, keep] = names.each_ref().map(String::as_str);
    printed(&arguments(whole, "image_width=64", &[]));
    let stopped = |options: &[&str], rows: &str| {
        let output = run(&arguments(out, "image_width=64", options));
        let said = String::from_utf8(output.stderr).expect("it is text");
        assert_eq!(said, format!("Not finished: {keep} has {rows} of 36 rows; go on by --resume {keep}\n"));
        assert_eq!((output.status.code(), fs::exists(out).ok()), (Some(3), Some(false)), "{options:?}");
    };
    stopped(&["--checkpoint", keep, "--rows", "0..9"], "9");
    stopped(&["--resume", keep, "--stop-after", "0s"], "10");
    stopped(&["--resume", keep, "--rows", "10..20", "--layout", "soa"], "20");
    let refusals: [(&[&str], &str); 8] = [
        (&["--checkpoint", keep], "the file exists; go on by --resume"),
        (&["--resume", keep, "--rows", "9..30"], "row 20 comes next"),
        (&["--resume", keep, "--rows", "..20"], "row 20 comes next"),
        (
            &["--resume", keep, "--scatter", "published"],
            "made with --scatter statement, and this run has --scatter pub",
        ),
        (&["--resume", keep, "--set", "gamma=1"], "it is of another configuration"),
        (&["--resume", "README.md"], "is damaged, or no checkpoint"),
        (&["--resume", "/nowhere/keep"], "/nowhere/keep"),
        (&["--stop-after", "9s"], "need --checkpoint FILE"),
    ];
    for (options, reason) in refusals {
        let said = complaint(&arguments(out, "image_width=64", options));
        assert!(said.contains(reason), "{options:?}: {said}");
    }
    printed(&arguments(out, "image_width=64", &["--resume", keep]));
    assert!(fs::read(out).expect("it is finished") == fs::read(whole).expect("it is there"));
    // A finished checkpoint gives the picture again.
    let options = ["--resume", keep, "--crop", "3,4,5,6", "--json"];
    let taken: serde_json::Value = printed(&arguments(out, "image_width=64", &options)).parse().expect("it is JSON");
    assert_eq!((&taken["primary_rays"], taken["nanoseconds_per_primary_ray"].is_null()), (&0.into(), true));
}

#[test]
fn an_interruption_writes_the_checkpoint() {
    let folder = Folder::new();
    let [out, keep] = ["out.ppm", "keep"].map(|name| folder.name(name));
    let long = [&["--set", "samples_per_pixel=2000", "--checkpoint", &keep][..]].concat();
    let child = lab(&arguments(&out, "image_width=400", &long)).stderr(std::process::Stdio::piped()).spawn();
    let child = child.expect("the program runs");
    std::thread::sleep(Duration::from_millis(500));
    let id = child.id().to_string();
    let sent = std::process::Command::new("kill").args(["-TERM", &id]).status().expect("there is kill");
    let output = child.wait_with_output().expect("it is ours");
    let said = String::from_utf8(output.stderr).expect("it is text");
    assert!(sent.success() && output.status.code() == Some(130), "{said}");
    assert!(said.starts_with("Not finished: ") && folder.names() == ["keep"], "{said}");
}

#[test]
fn a_run_without_a_checkpoint_begins_writes_one_on_request_and_keeps_others_away() {
    let folder = Folder::new();
    let names = ["whole.ppm", "out.ppm", "keep"].map(|name| folder.name(name));
    let [whole, out, keep] = names.each_ref().map(String::as_str);
    let resume = ["--resume", keep, "--set", "samples_per_pixel=300"];
    printed(&arguments(whole, "image_width=120", &resume[2..]));
    let mut child = lab(&arguments(out, "image_width=120", &resume)).spawn().expect("the program runs");
    let wait_for = |name: &str| {
        while !folder.file(name).exists() {
            std::thread::sleep(Duration::from_millis(5));
        }
    };
    wait_for("keep.lock");
    let second = complaint(&arguments(&folder.name("second.ppm"), "image_width=120", &resume));
    assert!(second.contains("keep: another run keeps this checkpoint; wait for its end"), "{second}");
    // A checkpoint every minute is not yet due.
    assert!(child.try_wait().expect("it is ours").is_none(), "the picture takes too little time for this test");
    let id = child.id().to_string();
    for _ in 0..1000 {
        let sent = std::process::Command::new("kill").args(["-USR1", &id]).status().expect("there is kill");
        std::thread::sleep(Duration::from_millis(20));
        if !sent.success() || folder.file("keep").exists() {
            break;
        }
    }
    assert!(folder.file("keep").exists() && child.try_wait().expect("it is ours").is_none(), "it goes on");
    assert!(child.wait().expect("it is ours").success());
    assert!(fs::read(out).expect("it is finished") == fs::read(whole).expect("it is there"));
    assert_eq!(folder.names(), ["keep", "out.ppm", "whole.ppm"], "no lock is left");
}
