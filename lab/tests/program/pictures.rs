//! Tests of `compare` and `convert` with pictures of other programs. numpy, OpenEXR and Pillow wrote the files in the
//! folder `pictures`, and read the values that are expected: number `k` of a picture of 6 x 4 pixels is k / 72.

use std::fs;
use std::process::Output;

use lab::picture::any::Any;
use test_support::folder::Folder;

use crate::{bash, bash_complaint};

/// Returns a folder with the pictures.
fn folder() -> Folder {
    let folder = Folder::new();
    let pictures = test_support::project_root().join("lab/tests/program/pictures");
    for entry in fs::read_dir(pictures).expect("it is committed") {
        let entry = entry.expect("it is there");
        folder.write(&entry.file_name().to_string_lossy(), fs::read(entry.path()).expect("it is committed"));
    }
    folder
}

/// Returns what a line of bash printed on standard output and on standard error.
fn said(output: &Output) -> [String; 2] {
    [&output.stdout, &output.stderr].map(|bytes| String::from_utf8_lossy(bytes).into_owned())
}

/// Converts the picture `from` into numbers.
fn numbers(folder: &Folder, from: &str, options: &str) -> (Vec<f32>, String) {
    let output = bash(folder, &format!("$lab convert {from} out.npy {options}"));
    assert!(output.status.success(), "{from}: {output:?}");
    let Ok(Any::Floats(floats)) = Any::parse(&folder.read("out.npy")) else { panic!("{from}") };
    (floats.values, said(&output)[1].clone())
}

#[test]
fn arrays_and_maps_of_every_kind_have_their_numbers() {
    let folder = folder();
    let expected: Vec<f32> = (0..72).map(|k| k as f32 / 72.0).collect();
    for (name, error) in [("f2.npy", 5e-4), ("rgba.npy", 0.0), ("py2.npy", 0.0), ("trail.pfm", 0.0)] {
        let (found, notes) = numbers(&folder, name, "");
        let count = found.len();
        // A map in the file is of other numbers: 1 / 72 is its step too.
        let worst = found.iter().zip(&expected).map(|(found, wanted)| (found - wanted).abs()).fold(0.0, f32::max);
        assert!(count == 72 && worst <= error + 1e-7, "{name}: {count} numbers, {worst}");
        assert_eq!(notes, "", "{name}");
    }
    // The array of bytes of the Python module is a picture of bytes.
    for (name, first, pixels) in
        [("u8.npy", "0 3 7\n10 14 17\n", 24), ("rendered.npy", "190 214 255\n190 214 255\n", 880)]
    {
        assert!(bash(&folder, &format!("$lab convert {name} out.ppm")).status.success(), "{name}");
        let text = String::from_utf8(folder.read("out.ppm")).expect("it is text");
        assert!(text.contains(&format!("255\n{first}")), "{name}: {text}");
        let compared = bash(&folder, &format!("$lab compare {name} out.ppm"));
        assert_eq!(said(&compared)[0], format!("identical: {pixels} pixels\n"), "{name}");
    }
}

/// Returns an NPY with this header and so many bytes of numbers.
fn npy(header: &str, bytes: usize) -> Vec<u8> {
    let length = (header.len() as u16).to_le_bytes();
    [b"\x93NUMPY\x01\0", &length[..], header.as_bytes(), &vec![0; bytes]].concat()
}

#[test]
fn a_file_that_cannot_be_read_has_a_message_with_the_cause_and_a_remedy() {
    let folder = folder();
    let header = |kind: &str, order: &str, shape: &str| {
        format!("{{'descr': {kind}, 'fortran_order': {order}, 'shape': {shape}, }}")
    };
    for (kind, order, shape, bytes, words) in [
        ("'<i8'", "False", "(2, 3)", 48, "of the type i8, and u1, f2, f4 or f8 is needed; save array.astype('u1')"),
        ("'|O'", "False", "(2, 3)", 9, "of the type O"),
        ("'<c16'", "False", "(2, 3)", 96, "of the type c16"),
        ("[('a', '<f4')]", "False", "(2, 3)", 24, "of records, [('a', '<f4')]"),
        ("'<f4'", "True", "(2, 3)", 24, "in Fortran's order; save numpy.ascontiguousarray(...)"),
        ("'<f4'", "False", "(6,)", 24, "of the shape (6,); (height, width), and a third side of 1, 3 or 4, are needed"),
        ("'<f4'", "False", "(3, 9, 7)", 756, "put the channels last by numpy.moveaxis(array, 0, -1)"),
        ("'<f4'", "False", "(2, 3, 5)", 120, "of the shape (2, 3, 5)"),
        ("'<f4'", "False", "(0, 3)", 0, "without pixels"),
        ("'<f4'", "False", "(2, 3)", 23, "23 bytes of numbers where the array's shape needs 24: it is cut off"),
        ("'<f4'", "False", "(2, 3)", 25, "25 bytes of numbers where the array's shape needs 24: more than one array"),
    ] {
        folder.write("a.npy", npy(&header(kind, order, shape), bytes));
        let message = bash_complaint(&folder, "$lab convert a.npy out.exr");
        assert!(message.starts_with("Error: a.npy: ") && message.contains(words), "{kind} {shape}: {message}");
    }
    folder.write("a.npy", b"\x93NUMPY\x09\0\x10\0{'descr': '<f4'}");
    folder.write("long.pfm", b"Pf\n2 1\n-1\n0123456789ab");
    for (line, words) in [
        ("convert a.npy o.exr", "an NPY of version 9; versions 1 to 3 are read"),
        ("convert crlf.pfm o.npy", "the header of this PFM ends in CR LF, as the text mode of Windows writes it"),
        ("convert long.pfm o.npy", "12 bytes of numbers where 2 x 1 pixels need 8"),
        ("convert <(printf 'PK\\3\\4') o.npy", "an archive, such as .npz of NumPy; save one array by numpy.save"),
        ("convert multi.exr o.npy --layer light", "without the layer light; it has depth (Z), rgb (B, G, R)"),
        ("convert u8.npy o.exr --layer light", "--layer is for EXR files"),
        ("convert u8.npy o.png --range 0,1", "--range is for numbers"),
        ("convert f2.npy o.png --range 1,0", "two numbers are needed, LOW,HIGH, the second larger"),
        (
            "compare u8.npy u8.npy --heatmap o.exr",
            "a drawing with colours and a scale; its name must end in .png or .ppm",
        ),
        ("compare u8.npy f2.npy --as numbers", "--as numbers needs two files of numbers"),
        ("compare f2.npy f2.npy --crop 0,0,7,1", "f2.npy: --crop goes beyond the picture of 6 x 4 pixels"),
    ] {
        let message = bash_complaint(&folder, &format!("$lab {line}"));
        assert!(message.contains(words), "{line}: {message}");
    }
}

#[test]
fn the_layer_with_colours_is_taken_with_a_note_and_the_others_by_name() {
    let folder = folder();
    let colors: Vec<f32> = (0..72).map(|k| k as f32 / 72.0).collect();
    let depths: Vec<f32> = colors.iter().step_by(3).copied().collect();
    let near = |found: &[f32], wanted: &[f32]| {
        found.len() == wanted.len() && found.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 1e-7)
    };
    let parts = "multi.exr: rgb is taken; --layer takes another one: it has depth (Z), rgb (B, G, R)\n";
    let layers = "blender.exr: ViewLayer.Combined is taken; --layer takes another one: it has ViewLayer.Combined (B, G, R), \
                  ViewLayer.Depth (Z)\n";
    for (name, options, wanted, note) in [
        ("multi.exr", "", &colors, parts),
        ("multi.exr", "--layer rgb", &colors, ""),
        ("multi.exr", "--layer depth", &depths, ""),
        ("multi.exr", "--layer depth.Z", &depths, ""),
        ("blender.exr", "", &colors, layers),
        ("blender.exr", "--layer ViewLayer.Depth", &depths, ""),
    ] {
        let (found, said) = numbers(&folder, name, options);
        assert!(near(&found, wanted) && said == note, "{name} {options}: {said} {found:?}");
    }
    // The same pixels in other places of a larger picture.
    let (found, note) = numbers(&folder, "w2c.exr", "");
    assert_eq!(
        note,
        "w2c.exr: its data are 6 x 4 pixels from column 3, row 2 of a picture of 10 x 8; the rest is black\n"
    );
    let pixel = |column: usize, row: usize| &found[3 * (10 * row + column)..][..3];
    assert!(found.len() == 240 && pixel(2, 2) == [0.0; 3] && near(pixel(4, 2), &colors[3..6]), "{found:?}");
    assert!(near(pixel(8, 5), &colors[69..]));
    let compared = said(&bash(&folder, "$lab compare w1c.exr w2c.exr"));
    assert!(compared[0].contains("within     9 x 6 pixels from column 0, row 0"), "{compared:?}");
}

#[test]
fn alpha_that_is_left_out_and_numbers_that_are_clipped_are_told() {
    let folder = folder();
    let [figures, note] = said(&bash(&folder, "$lab compare rgb.png rgba0.png"));
    assert_eq!(figures, "identical: 24 pixels\n");
    assert_eq!(note, "rgba0.png: 24 of its 24 pixels are not opaque; alpha is left out, their colours count\n");
    folder.write("depth.npy", {
        let numbers = [2.0_f32, f32::NAN, 5.0, -1.0].map(f32::to_le_bytes);
        let header = "{'descr': '<f4', 'fortran_order': False, 'shape': (2, 2), }";
        [&npy(header, 0)[..], numbers.as_flattened()].concat()
    });
    let [_, note] = said(&bash(&folder, "$lab convert depth.npy o.ppm"));
    assert_eq!(
        note,
        "depth.npy: of its 4 numbers, 1 below 0 become black, 2 above 1 become white, 1 that are NaN become black; \
         --range LOW,HIGH scales them (-1 to 5)\n"
    );
    let [_, note] = said(&bash(&folder, "$lab convert depth.npy o.ppm --range -1,5 && $lab convert depth.npy d.pfm"));
    assert_eq!(note, "");
    // 255 * 3 / 6 is 127.5, and bytes are truncated.
    assert_eq!(folder.read("o.ppm"), b"P3\n2 2\n255\n127 127 127\n0 0 0\n255 255 255\n0 0 0\n");
    let [figures, _] = said(&bash(&folder, "$lab compare depth.npy d.pfm --heatmap h.png --html h.html"));
    assert_eq!(figures, "identical: 3 numbers\n", "a number that is not there in both is no difference");
}

#[test]
fn two_depths_are_compared_as_numbers_with_bounds_of_the_user() {
    let folder = Folder::new();
    let header = "{'descr': '<f4', 'fortran_order': False, 'shape': (2, 3), }";
    let write = |name: &str, numbers: [f32; 6]| {
        folder.write(name, [&npy(header, 0)[..], numbers.map(f32::to_le_bytes).as_flattened()].concat());
    };
    let nan = f32::NAN;
    write("a.npy", [1.0, nan, 2.0, nan, 5.0, 4.0]);
    write("b.npy", [1.0, nan, 5.0, 7.0, nan, 4.0]);
    write("c.npy", [1.5, nan, 2.0, nan, 5.0, 4.0]);
    let run = |line: &str| {
        let output = bash(&folder, &format!("$lab compare {line}"));
        (output.status.code(), said(&output)[0].clone())
    };
    let (status, text) = run("a.npy b.npy --html page.html --heatmap map.png");
    // Of the three numbers in both, the differences are 0, 3 and 0, whose RMSE is the root of 3.
    assert_eq!(
        (status, &text[..]),
        (
            Some(1),
            "numbers    3 in both, 1 only in the first, 1 only in the second\nmaximum    3\nRMSE       1.7320508\n\
             MAE        1\ndiffering  1 of the 3 numbers\nwithin     3 x 2 pixels from column 0, row 0\n\
             verdict    different; numbers are not judged as pictures\n"
        )
    );
    let page = String::from_utf8(folder.read("page.html")).expect("it is text");
    assert!(page.contains("id=\"values-scale\">1 <span") && !page.contains("FLIP"), "{page}");
    let (status, text) = run("a.npy c.npy --accept-maximum 0.6 --accept-rmse 0.05 --html page.html");
    let failed = "RMSE       0.25  (not accepted: it must be below 0.05)";
    assert!(
        status == Some(1) && text.contains("maximum    0.5  (accepted below 0.6)\n") && text.contains(failed),
        "{text}"
    );
    let page = String::from_utf8(folder.read("page.html")).expect("it is text");
    assert!(page.contains(&format!("<mark>{failed}</mark>")), "{page}");
    assert_eq!(run("a.npy c.npy --accept-maximum 0.6").0, Some(0));
    assert_eq!(run("a.npy b.npy --accept-maximum 9").0, Some(1), "numbers in only one picture are not accepted");
    assert_eq!(run("a.npy b.npy --crop 0,0,2,1"), (Some(0), "identical: 1 numbers\n".to_owned()));
    let figures: serde_json::Value = run("a.npy b.npy --json").1.parse().expect("it is JSON");
    assert_eq!((&figures["only_first"], &figures["maximum"]), (&1.into(), &3.0.into()));
    // As light all numbers but NaN are white.
    assert_eq!(run("a.npy c.npy --as light"), (Some(0), "identical: 6 pixels\n".to_owned()));
}
