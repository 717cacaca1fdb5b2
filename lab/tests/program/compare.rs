//! Tests of `render-lab compare`.

use lab::picture::Picture;
use test_support::folder::Folder;

use crate::{printed, run};

const BLACK: &str = "P3\n2 2\n255\n0 0 0\n0 0 0\n0 0 0\n0 0 0\n";

/// Writes a black picture, and a picture that differs from it only in the third pixel. Returns their paths.
fn pair(folder: &Folder, third: &str) -> [String; 2] {
    folder.write("a.ppm", BLACK);
    let other = format!("P3\n2 2\n255\n0 0 0\n0 0 0\n{third}\n0 0 0\n");
    folder.write("b.ppm", other);
    ["a.ppm", "b.ppm"].map(|name| folder.name(name))
}

#[test]
fn the_verdict_is_the_exit_status() {
    let folder = Folder::new();
    let [a, b] = pair(&folder, "6 0 12");
    let text = printed(&["compare", &a, &b]);
    assert!(text.starts_with("maximum    6.000") && text.ends_with("verdict    accepted\n"), "{text}");
    assert!(text.contains("RMSE       3.000"), "{text}");
    assert!(text.contains("within     1 x 1 pixels from column 0, row 1"), "{text}");
    let value: serde_json::Value = printed(&["compare", &a, &b, "--json"]).parse().expect("it is JSON");
    assert_eq!((&value["rmse"], &value["differing"], &value["accepted"]), (&3.0.into(), &1.into(), &true.into()));
    assert_eq!(value["bounding_box"], serde_json::json!([0, 1, 1, 1]));
    let [a, b] = pair(&folder, "255 255 255");
    let output = run(&["compare", &a, &b]);
    assert_eq!(output.status.code(), Some(1));
    assert!(output.stderr.is_empty(), "the verdict is no error");
    assert!(String::from_utf8_lossy(&output.stdout).ends_with("verdict    not accepted\n"));
    assert_eq!(printed(&["compare", &a, &a]), "identical: 4 pixels\n");
}

#[test]
fn the_heatmap_is_bright_where_pictures_differ() {
    let folder = Folder::new();
    let [a, b] = pair(&folder, "6 0 12");
    let drawn = |name: &str, options: &[&str]| {
        printed(&[&["compare", &a, &b, "--heatmap", &folder.name(name)], options].concat());
        Picture::read(&folder.file(name)).expect("it is a picture")
    };
    let map = drawn("map.png", &[]);
    let brightness = |[x, y]: [usize; 2]| map.pixels[y * map.width + x].iter().map(|&c| u32::from(c)).sum::<u32>();
    assert!(brightness([0, 1]) > 500 && [[0, 0], [1, 0], [1, 1]].into_iter().all(|place| brightness(place) < 10));
    // On a scale with a larger maximum the difference has a darker colour. With `--signed` it is red.
    assert!(drawn("wide.png", &["--max", "255"]).pixels[map.width] < map.pixels[map.width]);
    let [red, _, blue] = drawn("signed.png", &["--signed"]).pixels[map.width];
    assert!(red > 90 && blue < 60, "the second picture is brighter: {red} {blue}");
    // The ending of its name decides the format of a heat map too.
    assert_eq!(drawn("map.ppm", &[]), map);
    assert!(folder.read("map.ppm").starts_with(b"P3"));
}
