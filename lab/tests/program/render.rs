//! Tests of `render-lab render`.

use std::fs;

use cpu::{Config, Scatter, Scene};
use lab::picture::Picture;
use test_support::folder::Folder;

use crate::{complaint, printed, run};

const CONFIG: &str = "scenes/grid/config.txt";
const SCENE: &str = "scenes/grid/scene.txt";
const SMALL: [&str; 4] = ["--set", "image_width=64", "--set", "samples_per_pixel=2"];

/// Returns the bytes that the evaluated programs write for the scene `grid`, with the settings [`SMALL`].
fn expected(scatter: Scatter) -> Vec<u8> {
    let root = test_support::project_root();
    let config = Config::read(&root.join(CONFIG)).expect("it is committed");
    let config = Config { image_width: 64, samples_per_pixel: 2, ..config };
    let scene = Scene::read(&root.join(SCENE)).expect("it is committed");
    test_support::ppm(
        &cpu::reference::render::<cpu::internals::layout::aos::AosImage>(&config, &scene, scatter)
            .expect("it is small"),
    )
}

fn render(folder: &Folder, out: &str, options: &[&str]) -> Vec<u8> {
    let out = folder.name(out);
    let printed = printed(&[&["render", CONFIG, SCENE, &out], &SMALL[..], options].concat());
    assert_eq!(printed, "", "standard output is for pictures and JSON");
    fs::read(out).expect("it was written")
}

#[test]
fn layouts_and_formats_change_no_pixel_and_conventions_do() {
    let folder = Folder::new();
    let statement = expected(Scatter::Statement);
    assert!(render(&folder, "a.ppm", &[]) == statement);
    assert!(render(&folder, "b.ppm", &["--layout", "soa"]) == statement);
    let published = render(&folder, "c.ppm", &["--scatter", "published"]);
    assert!(published == expected(Scatter::Published) && published != statement);
    let png = render(&folder, "out.PNG", &[]);
    assert!(png.starts_with(b"\x89PNG") && Picture::parse(&png) == Picture::parse(&statement));
    assert_eq!(folder.names(), ["a.ppm", "b.ppm", "c.ppm", "out.PNG"]);
}

#[test]
fn a_part_has_the_pixels_of_the_whole() {
    let folder = Folder::new();
    let part = render(&folder, "part.ppm", &["--crop", "20,11,30,7"]);
    let whole = Picture::parse(&expected(Scatter::Statement)).expect("it is a picture");
    assert!(Picture::parse(&part) == Ok(whole.crop([20, 11, 30, 7]).expect("it is small")));
}

#[test]
fn counts_are_those_of_a_scene_known_by_hand() {
    let folder = Folder::new();
    // The camera is inside a mirror, so every ray hits it until the maximum depth. 4 x 4 pixels with 3 samples and
    // depth 5 give 240 rays.
    folder.write("scene", "metal: m 1 1 1 0\nsphere: 0 0 0 50 m\n");
    let config = "image_width: 4\naspect_ratio: 1 1\nsamples_per_pixel: 3\nmax_depth: 5\n";
    folder.write("config", config);
    let [config, scene, out] = ["config", "scene", "out.ppm"].map(|name| folder.name(name));
    let json = printed(&["render", &config, &scene, &out, "--count", "--json"]);
    let taken: serde_json::Value = serde_json::from_str(&json).expect("it is JSON");
    assert_eq!((&taken["primary_rays"], &taken["rays"], &taken["hits"]), (&48.into(), &240.into(), &240.into()));
    assert!(taken["peak_memory_bytes"].as_u64().is_some_and(|bytes| bytes > 100_000), "{taken}");
}

#[test]
fn the_end_is_told_with_file_size_and_time_unless_it_is_to_be_quiet() {
    let folder = Folder::new();
    let out = folder.name("out.png");
    let arguments = [&["render", CONFIG, SCENE, &out][..], &SMALL].concat();
    let said = String::from_utf8(run(&arguments).stderr).expect("it is text");
    assert!(said.starts_with(&format!("{out}: 64 x 36 pixels, 2 samples each: ")) && said.contains(" s, "), "{said}");
    assert!(run(&[&arguments[..], &["--quiet"]].concat()).stderr.is_empty());
}

#[test]
fn the_first_examples_of_the_help_work_one_after_the_other() {
    let folder = Folder::new();
    let help = printed(&["--help"]);
    let examples = help.lines().map(str::trim).filter(|line| line.starts_with("render-lab "));
    let lines: Vec<_> = examples.take(3).map(|line| line.replacen("render-lab", "$lab", 1)).collect();
    let output = crate::bash(&folder, &format!("ln -s $root/scenes .; {}", lines.join(" && ")));
    assert!(output.status.success() && lines.len() == 3, "{lines:?}: {output:?}");
    assert!(folder.file("difference.png").exists(), "the third example draws a heat map");
}

#[test]
fn a_dash_is_standard_input_or_output() {
    use std::process::Stdio;

    let folder = Folder::new();
    let expected = expected(Scatter::Statement);
    let root = test_support::project_root();
    for (config, scene, input, out) in [("-", SCENE, CONFIG, "-"), (CONFIG, "-", SCENE, "/dev/stdout")] {
        let arguments = [&["render", config, scene, out][..], &SMALL].concat();
        let input = fs::File::open(root.join(input)).expect("it is committed");
        let output = crate::lab(&arguments).stdin(Stdio::from(input)).output().expect("the program runs");
        assert!(output.status.success() && output.stdout == expected, "{config} {scene}: {:?}", output.status);
    }
    let picture = folder.file("a.ppm");
    fs::write(&picture, &expected).expect("the folder is writable");
    let name = folder.name("a.ppm");
    let compared = crate::lab(&["compare", "-", &name])
        .stdin(Stdio::from(fs::File::open(&picture).expect("it was written")))
        .output()
        .expect("the program runs");
    assert_eq!(String::from_utf8_lossy(&compared.stdout), "identical: 2304 pixels\n");
    let map = run(&["compare", &name, &name, "--heatmap", "-"]);
    assert!(map.stdout.starts_with(b"\x89PNG") && map.stderr.starts_with(b"identical"), "{:?}", map.status);
}

#[test]
fn a_quantity_is_shown_with_a_scale_or_as_numbers_and_light_is_linear() {
    let folder = Folder::new();
    let depth = render(&folder, "depth.png", &["--show", "depth"]);
    let depth = Picture::parse(&depth).expect("it is a picture");
    assert!(depth.height > 36, "the scale is below it");
    for (quantity, rays, samples) in [("depth", 1, None), ("samples", 0, None), ("cost", 2, Some(2))] {
        let out = folder.name("counted.npy");
        let options = ["render", CONFIG, SCENE, &out, "--json", "--show", quantity];
        let taken: serde_json::Value = printed(&[&options[..], &SMALL].concat()).parse().expect("it is JSON");
        let expected = (&(64 * 36 * rays).into(), &serde_json::json!(samples));
        assert_eq!((&taken["primary_rays"], &taken["samples_per_pixel"]), expected, "{quantity}");
    }
    let numbers = render(&folder, "depth.npy", &["--show", "depth"]);
    assert!(numbers.starts_with(b"\x93NUMPY") && numbers.len() > 4 * 64 * 36);
    // The linear light of each format gives the picture's bytes again.
    for name in ["light.exr", "light.npy", "light.pfm"] {
        render(&folder, name, &["--layout", "soa"]);
        let [from, to] = [name, "back.ppm"].map(|name| folder.name(name));
        printed(&["convert", &from, &to]);
        assert!(fs::read(&to).expect("it was written") == expected(Scatter::Statement), "{name}");
    }
    let [exr, npy, page] = ["light.exr", "light.npy", "page.html"].map(|name| folder.name(name));
    assert_eq!(printed(&["compare", &exr, &npy, "--html", &page]), "identical: 2304 pixels\n");
    let page = fs::read_to_string(page).expect("it was written");
    assert!(
        page.contains("data:image/png;base64,") && page.contains("identical: 2304") && !page.contains("src=\"http")
    );
    let output = run(&["compare", &exr, &folder.name("depth.npy")]);
    assert!(String::from_utf8_lossy(&output.stderr).contains("different sizes or channels"), "{output:?}");
}

#[test]
fn an_animation_turns_once_and_goes_on_where_frames_are_missing() {
    let folder = Folder::new();
    let [out, film] = ["frames", "film.png"].map(|name| folder.name(name));
    let animate = |out: &str, options: &[&str]| {
        let command = ["animate", CONFIG, SCENE, out, "--frames", "4", "--json"];
        let taken = printed(&[&command[..], &SMALL, options].concat());
        let taken: serde_json::Value = serde_json::from_str(&taken).expect("it is JSON");
        taken["rendered"].as_u64()
    };
    assert_eq!(animate(&out, &[]), Some(4));
    let first = folder.read("frames/0000.png");
    assert!(Picture::parse(&first) == Picture::parse(&expected(Scatter::Statement)), "the first frame is the picture");
    let third = folder.read("frames/0002.png");
    fs::remove_file(folder.file("frames/0001.png")).expect("it is ours");
    folder.write("frames/0002.png", &third[..100]);
    assert_eq!(animate(&out, &[]), Some(2));
    assert!(folder.read("frames/0002.png") == third);
    // A pipe or a link in the place of a frame is refused, and not waited for or written through.
    for make in ["mkfifo frames/0001.png", "ln -s ../victim frames/0001.png", "mkdir frames/0001.png"] {
        crate::bash(&folder, &format!("rm -r frames/0001.png; {make}"));
        let said = complaint(&["animate", CONFIG, SCENE, &out, "--frames", "4"]);
        assert!(said.contains("0001.png: it is not a regular file; delete it"), "{make}: {said}");
        assert!(!folder.file("victim").exists());
    }
    crate::bash(&folder, "rm -r frames/0001.png");
    for name in ["turn.gif", "turn.MP4", "turn.webp"] {
        let said = complaint(&["animate", CONFIG, SCENE, &folder.name(name)]);
        assert!(said.contains("is not written. Name an animated PNG (.png)") && !folder.file(name).exists(), "{said}");
    }
    let other = complaint(&["animate", CONFIG, SCENE, &out, "--frames", "5"]);
    assert!(other.contains("it has frames of another animation"), "{other}");
    fs::remove_file(folder.file("frames/animation.json")).expect("it was written");
    let other = complaint(&["animate", CONFIG, SCENE, &out, "--frames", "4"]);
    assert!(other.contains("0000.png: no animation.json tells its animation"), "{other}");
    // The third of five frames is halfway between two opposite cameras, at their target.
    folder.write("from", "camera_position: 0 0 -9\n");
    folder.write("to", "camera_position: 0 0 9\n");
    let [from, to, new] = ["from", "to", "new"].map(|name| folder.name(name));
    let through = complaint(&["animate", &from, SCENE, &new, "--to", &to, "--frames", "5"]);
    assert!(through.contains("frame 2: ") && !fs::exists(&new).expect("the folder is ours"), "{through}");
    assert_eq!(animate(&film, &["--to", "scenes/materials/config.txt"]), Some(4));
    let said = run(&["compare", &film, &film]).stderr;
    let note = "film.png: of an animation of 4 frames only the still picture is taken";
    assert!(String::from_utf8_lossy(&said).contains(note), "{}", String::from_utf8_lossy(&said));
    assert!(fs::read(film).expect("it was written").windows(4).any(|bytes| bytes == b"acTL"), "it is animated");
}
