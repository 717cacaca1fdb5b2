//! Tests of `render-lab diagnose` and `render-lab explain`.

use std::os::unix::fs::PermissionsExt;

use serde_json::Value;
use test_support::folder::Folder;

use crate::{complaint, lab, printed, run};

/// Diagnoses a program of a few lines of shell, in which `$lab` is `render-lab`. Returns the exit status, and the
/// diagnosis or the message.
fn diagnose(script: &str) -> (Option<i32>, Value) {
    let folder = Folder::new();
    let lab_name = env!("CARGO_BIN_EXE_render-lab");
    let program = folder.write("program", format!("#!/bin/sh\nIFS=\nlab='{lab_name}'\n{script}\n"));
    std::fs::set_permissions(&program, PermissionsExt::from_mode(0o755)).expect("it is ours");
    let output = lab(&["diagnose", "--json", "--seconds", "5", &folder.name("program")]).output().expect("it runs");
    let value = serde_json::from_slice(&output.stdout)
        .unwrap_or_else(|_| Value::String(String::from_utf8_lossy(&output.stderr).into_owned()));
    (output.status.code(), value)
}

/// Returns all words of a diagnosis, without its sections.
fn words(diagnosis: &Value) -> Vec<String> {
    let all = diagnosis["causes"].as_array().into_iter().flatten().filter_map(Value::as_array).flatten();
    let all = all.chain(diagnosis["others"].as_array().into_iter().flatten());
    all.map(|deviation| deviation["words"].as_str().unwrap_or_default().to_owned()).collect()
}

#[test]
fn programs_are_diagnosed() {
    let render = "exec $lab render --no-sync";
    for (script, status, explained, expected) in [
        (format!("{render} \"$1\" \"$2\" \"$3\""), 0, true, &[][..]),
        (format!("{render} \"$1\" \"$2\" \"$3\" --scatter published"), 0, true, &["unit vectors"]),
        (format!("{render} \"$2\" \"$1\" \"$3\""), 1, true, &["the configuration and the scene are swapped"]),
        (
            format!("grep -q gamma \"$1\" || echo gamma: 2 >>\"$1\"; {render} \"$1\" \"$2\" \"$3\""),
            1,
            true,
            &["the default of gamma: is not 2.2"],
        ),
        (format!("{render} \"$1\" \"$2\" \"$3\" --set gamma=2.2"), 1, true, &["configuration's gamma is ignored"]),
        (format!("{render} \"$1\" \"$2\" \"$3\" --set ray_rng_seed=5"), 1, false, &[]),
        (format!("{render} \"$1\" \"$2\" \"$3\" --set ray_rng_seed=1$(date +%N)"), 1, false, &["others in every run"]),
    ] {
        let (found, diagnosis) = diagnose(&script);
        let words = words(&diagnosis);
        assert_eq!((found, &diagnosis["explained"]), (Some(status), &explained.into()), "{script}: {diagnosis}");
        let is_named =
            words.len() == expected.len() && expected.iter().zip(&words).all(|(it, words)| words.contains(it));
        assert!(is_named, "{script}: {words:?}");
    }
}

#[test]
fn programs_without_a_picture_are_an_error() {
    for (script, expected) in [
        ("exit 3", "exit status 3"),
        ("echo no >&2; kill -SEGV $$", "SIGSEGV"),
        ("exit 0", "no picture"),
        ("rm -f \"$3\"; mkfifo \"$3\"", "no picture"),
        ("ln -s /dev/zero \"$3\"", "no picture"),
        ("(echo P3 1 1 255; yes 0 | head -c 1000000) >\"$3\"", "larger than"),
        ("printf 'P6 1 1 255\\n123' >\"$3\"", "no P3"),
        ("printf 'P3 1000000 1000000 255\\n1 2 3' >\"$3\"", "cannot be read"),
    ] {
        let (status, message) = diagnose(script);
        let message = message.as_str().unwrap_or_default();
        assert!(status == Some(2) && message.contains(expected), "{script}: {status:?} {message}");
    }
}

const SCENE: &str = "matte: m .5 .5 .5\nmetal: n .9 .9 .9 .2\nrefractive: g 1.5\nsphere: 0 0 0 1 m\n\
                     cylinder: 0 -2 0 1 0 2 0 n\nsphere: 0 0 -2 .5 g\n";

#[test]
fn a_pixel_is_explained_beside_that_of_another_picture() {
    let folder = Folder::new();
    folder.write("config", "image_width: 16\nsamples_per_pixel: 4\ncamera_position: 0 0 -4\nmax_depth: 6\n");
    folder.write("scene", SCENE);
    let [config, scene, own, other] = ["config", "scene", "own.ppm", "other.ppm"].map(|name| folder.name(name));
    printed(&["render", &config, &scene, &own]);
    let picture = String::from_utf8(folder.read("own.ppm")).expect("P3 is text");
    let mut lines: Vec<_> = picture.lines().collect();
    assert!(lines.len() > 100);
    lines[3 + 70] = "1 2 3";
    folder.write("other.ppm", format!("{}\n", lines.join("\n")));

    let text = printed(&["explain", &config, &scene, "6", "4", "--sample", "2", "--other", &other]);
    assert!(text.contains("sample 2 of 0 to 3\n") && !text.contains("sample 1 of"), "{text}");
    let bytes = picture.lines().nth(3 + 70).expect("it has the pixel");
    assert!(text.contains(&format!("bytes       {bytes}: truncated\nother       1 2 3\n")), "{text}");
    assert!(
        text.ends_with(&format!("first       difference in column 6, row 4: {bytes} here, 1 2 3 there\n")),
        "{text}"
    );
    let text = printed(&["explain", &config, &scene, "6", "4", "--other", &own]);
    assert!(text.ends_with("first       no pixel differs\n"), "{text}");
    assert!(text.contains("sample 3 of 0 to 3\n") && text.contains(" of all 4 samples of the pixel\n"), "{text}");

    let told: Value = printed(&["explain", &config, &scene, "7", "4", "--json"]).parse().expect("it is JSON");
    let count = |what: &str| told.to_string().matches(what).count();
    assert_eq!((count("\"event\":\"sample\""), count("\"event\":\"end\"")), (4, 4));
    assert!(count("\"material\":\"refractive\"") >= 4, "the glass is in the middle: {told}");
}

#[test]
fn the_text_tells_refraction_and_total_reflection_with_their_numbers() {
    let folder = Folder::new();
    folder.write("config", "image_width: 16\nsamples_per_pixel: 2\ncamera_position: 0 0 -4\nmax_depth: 3\n");
    folder.write("scene", "refractive: g 1.5\ncylinder: 0 0 0 .7 0 4 0 g\ncylinder: 9 0 0 .7 0 4 0 g\n");
    let [config, scene] = ["config", "scene"].map(|name| folder.name(name));
    let text = printed(&["explain", &config, &scene, "8", "4", "--sample", "0"]);
    let lines: Vec<_> = text.lines().map(str::trim).collect();
    let after = |words: &str| {
        let place = lines.iter().position(|line| line.starts_with(words)).unwrap_or_else(|| panic!("{words}: {text}"));
        lines[place + 2]
    };
    let enters = after("rho'      = 0.6666666666666666 = 1 / 1.5: the ray enters");
    assert!(enters.starts_with("cos with this normal 0.") && enters.ends_with(" <= 1: it is refracted"), "{text}");
    // The side's short normal makes every sine greater than 1 / 1.5.
    let leaves = after("rho'      = rho = 1.5: the ray leaves");
    assert!(leaves.starts_with("cos with this normal 0.") && leaves.ends_with(" > 1: it is reflected"), "{text}");
    assert!(
        text.contains("object 2, side: no root, the discriminant is negative\n    object 2, upper base:"),
        "{text}"
    );
}

#[test]
fn a_pixel_that_does_not_exist_is_refused() {
    let scene = "scenes/listings/scene.txt";
    let folder = Folder::new();
    folder.write("config", "image_width: 16\nsamples_per_pixel: 2\n");
    folder.write("small.ppm", "P3\n1 1\n255\n0 0 0\n");
    let [config, small] = ["config", "small.ppm"].map(|name| folder.name(name));
    for (arguments, message) in [
        (&["16", "0"][..], "there is no pixel 16 0: columns are 0 to 15, rows 0 to 8"),
        (&["0", "9"], "there is no pixel 0 9"),
        (&["0", "0", "--sample", "2"], "--sample 2: samples are 0 to 1"),
        (&["0", "0", "--other", &small], "small.ppm: it has 1 x 1 pixels, and this picture has 16 x 9"),
    ] {
        let arguments: Vec<_> = ["explain", &config, scene].into_iter().chain(arguments.iter().copied()).collect();
        assert!(complaint(&arguments).contains(message), "{arguments:?}: {}", complaint(&arguments));
    }
    assert_eq!(run(&["explain", &config, scene, "-1", "0"]).status.code(), Some(2));
}
