//! Tests of the module's functions, called as functions of Rust.

use super::*;
use crate::fault::Place;

fn write(text: usize, bytes: &[u8]) {
    assert!(!room(text, bytes.len()).is_null());
    state().texts[text].copy_from_slice(bytes);
}

/// Returns the text, the line, the column and the length of the last fault.
fn place() -> [usize; 4] {
    let Some(Fault { place: Place { text, line, column, length }, .. }) = state().fault else { panic!("no fault") };
    [text, line, column, length]
}

/// Returns the last fault as the page gets it.
fn last_fault() -> serde_json::Value {
    fault();
    serde_json::from_slice(&state().result).expect("it is JSON")
}

fn result_text() -> String {
    String::from_utf8(state().result.clone()).expect("it is a text")
}

/// One test, because the functions share their state.
#[test]
fn texts_become_a_file_or_a_message() {
    write(0, b"image_width: 8\naspect_ratio: 1 1\ncamera_position: 0 0 -3\n");
    write(1, b"matte: grey .5 .5 .5\nsphere: 0 0 0 1 grey\n");
    assert_eq!((check(0), check(1)), (0, 0));
    let mut files = Vec::new();
    for (layout, is_published, is_portable) in [(0, 0, 0), (1, 0, 0), (0, 0, 1), (0, 1, 0)] {
        page::CALLS.lock().expect("no test failed").clear();
        assert_eq!(render(layout, is_published, is_portable), 0);
        assert_eq!(result_length(), state().result.len());
        files.push(state().result.clone());
        let mut calls = vec![[8, 8]];
        calls.extend((0..8).map(|row| [row, 1]));
        assert_eq!(*page::CALLS.lock().expect("no test failed"), calls, "the size, and then every row once");
    }
    assert!(files[0].starts_with(b"P3\n8 8\n255\n"));
    assert!(files[0] == files[1] && files[0] == files[2] && files[0] != files[3]);

    state().result = b"abc".to_vec();
    digest();
    assert_eq!(result_text(), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad", "FIPS 180-2, B.1");

    write(1, b"\ntriangle: 1\n");
    assert_eq!((render(0, 0, 0), result_text().as_str()), (1, "Unknown scene entity: triangle"));
    assert_eq!(place(), [1, 2, 1, 9]);
    write(0, b"gamma: 0\n\nmax_depth: 0");
    assert_eq!(check(0), 2);
    fault_at(1);
    assert_eq!(place(), [0, 3, 12, 1]);
    fault_at(0);
    assert_eq!(result_text(), "Invalid value for key: [gamma:]\nLine: \"gamma: 0\"");
    assert_eq!(place(), [0, 1, 8, 1]);
    for (text, wanted, hints) in [
        ("gamma: 2,2", [0, 1, 8, 3], ["point, not a comma: gamma: 2.2", "decimal, no una coma: gamma: 2.2"]),
        (
            "gamma:\u{a0}2",
            [0, 1, 7, 1],
            ["here, and it is not seen; write a space", "que no se ve; escriba un espacio"],
        ),
        (
            "gamma: x",
            [0, 1, 8, 1],
            ["the line is: gamma: number > 0", "número mayor que 0; la línea es: gamma: número > 0"],
        ),
    ] {
        write(0, text.as_bytes());
        assert_eq!(check(0), 1, "{text}");
        fault_at(0);
        assert_eq!(place(), wanted, "{text}");
        for (language, hint) in hints.into_iter().enumerate() {
            let fault = last_fault();
            assert!(fault["hints"][language].as_str().is_some_and(|text| text.contains(hint)), "{text}: {fault}");
        }
    }
    assert!(room(2, 1).is_null());

    for (text, spanish) in [
        ("image_width: 18446744073709551615\n", "la imagen es demasiado grande"),
        ("camera_target: 0 0 -10\n", "camera_position es el mismo punto"),
        ("camera_north: 0 0 1\n", "camera_north es nulo o paralelo"),
        ("camera_position: 1e308 0 0\ncamera_target: -1e308 0 0\n", "la posición, el objetivo o field_of_view"),
    ] {
        write(0, text.as_bytes());
        write(1, b"");
        assert_eq!((render(0, 0, 0), place()[0]), (1, 0), "{text}");
        let fault = last_fault();
        assert!(fault["hints"][1].as_str().is_some_and(|text| text.starts_with(spanish)), "{fault}");
    }

    table(0);
    assert!(result_text().contains("gamma:\tnumber > 0\t2.2\tgamma correction"), "{}", result_text());
    assert_eq!(result_text().lines().count(), format::CONFIG.len());
    table(1);
    assert!(result_text().lines().all(|line| line.split('\t').count() == 5), "{}", result_text());
    assert!(result_text().contains("\tx y z radio material"), "{}", result_text());

    the_shaders_get_a_scene();
}

/// Part of the one test, because the functions share their state.
fn the_shaders_get_a_scene() {
    assert_eq!((aim(), result_text().as_str()), (1, "no scene is prepared"));
    write(0, b"image_width: 8\naspect_ratio: 1 1\ncamera_position: 0 0 -3\nmax_depth: 3\n");
    write(1, b"matte: grey .5 .5 .5\nsphere: 0 0 0 1 grey\ncylinder: 2 0 0 .5 0 2 0 grey\n");
    assert_eq!(prepare(), 0);
    let mut sizes = Vec::new();
    for part in 0..4 {
        assert_eq!(packed(part), 0);
        sizes.push(result_length());
    }
    assert_eq!(sizes, [140, 24, 40, 28], "the sizes of the structures in WGSL");
    assert_eq!(packed(4), 0);
    let facts: serde_json::Value = serde_json::from_slice(&state().result).expect("it is JSON");
    assert_eq!((&facts["width"], &facts["tests"], &facts["depth"]), (&8.into(), &2.into(), &3.into()));
    assert_eq!(facts["shapes"][1], serde_json::json!(["cylinder", [2.0, 0.0, 0.0], 0.5, [0.0, 1.0, 0.0]]));

    let colors = |is_single| {
        assert_eq!(truth(is_single), 0);
        let numbers: Vec<f64> =
            state().result.chunks(8).map(|bytes| f64::from_le_bytes(bytes.try_into().expect("8 bytes"))).collect();
        assert_eq!(numbers.len(), 8 * 8 * 3);
        numbers
    };
    let (exact, single) = (colors(0), colors(1));
    let largest = exact.iter().zip(&single).map(|(one, other)| (one - other).abs()).fold(0.0, f64::max);
    assert!(largest > 0.0 && largest < 1e-4, "f32 differs from f64 by rounding: {largest}");

    // The ray beside the middle goes along (0.375, -0.375, 3), whose unit vector has z = 0.9847. So it hits the sphere
    // of radius 1 at 3 z - sqrt(9 z^2 - 8) = 2.1014 units from the camera, with the normal towards the camera.
    assert_eq!((truth(2), result_length()), (0, 8 * 8 * 6 * 8));
    let seen: Vec<f64> =
        state().result.chunks(8).map(|bytes| f64::from_le_bytes(bytes.try_into().expect("8 bytes"))).collect();
    let middle = &seen[6 * (8 * 4 + 4)..][..6];
    assert!(
        (middle[0] - 2.1014).abs() < 1e-4 && middle[3] < -0.9 && middle[4] == 0.0 && middle[5] == 2.0,
        "{middle:?}"
    );
    assert!(seen[0].is_nan() && seen[4].is_nan() && seen[5] == 1.0, "the corner shows the background");

    assert_eq!(steps(8 * 4 + 4), 0);
    step_names_have_numbers(3);
    assert_eq!((steps(64), result_length()), (0, 0), "there is no pixel 64");
    write(0, b"image_width: 4\naspect_ratio: 1 1\ncamera_position: 0 0 -3\n");
    assert_eq!((aim(), packed(4)), (0, 0));
    assert!(result_text().contains("\"width\":4"), "{}", result_text());
    write(0, b"image_width: none\n");
    assert_eq!((aim(), place()), (1, [0, 1, 14, 4]));
    assert_eq!((truth(0), result_length()), (0, 4 * 4 * 3 * 8), "the last good scene stays");
    wgsl();
    assert!(result_text().contains("shaders/wgsl/sphere.wgsl"));
}

/// Compares the number of the last result's numbers with the number of names.
fn step_names_have_numbers(depth: usize) {
    let numbers = result_length() / 4;
    step_names();
    assert_eq!(numbers, depth * result_text().lines().count());
}
