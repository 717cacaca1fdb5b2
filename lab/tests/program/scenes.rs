//! Tests of `render-lab convert` with scenes of pbrt and Mitsuba.

use std::fs;

use cpu::{Config, Scene};
use test_support::folder::Folder;

use crate::{complaint, printed, run};

#[test]
fn every_scene_comes_back_from_both_formats_with_the_same_numbers() {
    let folder = Folder::new();
    let root = test_support::project_root();
    let mut inputs: Vec<_> = fs::read_dir(root.join("scenes"))
        .expect("it is committed")
        .map(|entry| ["config.txt", "scene.txt"].map(|name| entry.as_ref().expect("it is there").path().join(name)))
        .collect();
    assert!(inputs.len() >= 6);
    // An upright picture, a sky of one colour, and the largest counts.
    let [upright, scene] = [folder.file("upright.txt"), inputs[0][1].clone()];
    let most = "samples_per_pixel: 18446744073709551615\nmax_depth: 18446744073709551615\n";
    let text = format!("image_width: 90\naspect_ratio: 9 16\nfield_of_view: 33\nbackground_dark_color: 1 1 1\n{most}");
    fs::write(&upright, text).expect("the folder is writable");
    inputs.push([upright, scene]);
    for [config, scene] in inputs {
        for other in ["other.pbrt", "other.xml"] {
            let name = |path: &std::path::Path| path.display().to_string();
            assert_eq!(printed(&["convert", &name(&config), &name(&scene), &folder.name(other)]), "");
            printed(&["convert", &folder.name(other), &folder.name("c.txt"), &folder.name("s.txt")]);
            let defaults = Config::default();
            // Gamma and seeds have no match.
            let expected = Config {
                gamma: defaults.gamma,
                material_rng_seed: defaults.material_rng_seed,
                ray_rng_seed: defaults.ray_rng_seed,
                ..Config::read(&config).expect("it is valid")
            };
            assert_eq!(Config::read(&folder.file("c.txt")).ok(), Some(expected), "{other}");
            let found = Scene::read(&folder.file("s.txt")).expect("it is valid");
            assert!(Scene::read(&scene).is_ok_and(|scene| scene == found), "{} {other}", scene.display());
        }
    }
}

#[test]
fn what_has_no_match_is_listed_and_a_wrong_file_changes_nothing() {
    let folder = Folder::new();
    let [config, scene, other] = ["c.txt", "s.txt", "o.xml"].map(|name| folder.name(name));
    folder.write("c.txt", "gamma: 1\n\nray_rng_seed: 3");
    folder.write("s.txt", "metal: a 1 1 1 .5\nmatte: b 1 1 1\ncylinder: 0 0 0 2 0 1 0 a\n");
    let output = run(&["convert", &config, &scene, &other]);
    let said = String::from_utf8_lossy(&output.stderr).replace(&folder.name(""), "");
    assert!(
        output.status.success() && said.starts_with("c.txt:1: gamma has no match; left out\nc.txt:3: seeds"),
        "{said}"
    );
    assert!(said.contains("\ns.txt:1: diffusion and") && said.contains("\ns.txt:3: the normal of our"), "{said}");
    assert!(folder.names().contains(&"o.xml.exr".to_owned()), "the sky");
    assert!(said.ends_with("o.xml.exr: holds the picture of the sky\n"), "{said}");
    folder.write("wrong.pbrt", "\nTranslate 1");
    let message = complaint(&["convert", &folder.name("wrong.pbrt"), &config, &scene]);
    assert!(message.ends_with("/wrong.pbrt:2: the file ends here, and a value is missing\n"), "{message}");
    assert!(fs::read_to_string(&config).is_ok_and(|text| text.starts_with("gamma: 1\n")));
    let [dot, new, link, sky] = ["./c.txt", "new.txt", "link.txt", "o.xml.exr"].map(|name| folder.name(name));
    std::os::unix::fs::symlink("new.txt", &link).expect("the folder is writable");
    for [one, two] in [[&config, &config], [&config, &dot], [&link, &new]] {
        assert!(complaint(&["convert", &other, one, two]).contains("the outputs need a file each"));
    }
    // Included files and the picture of the sky are inputs too.
    folder.write("include.pbrt", "Include \"inner.inc\"");
    folder.write("inner.inc", "Shape \"sphere\"");
    for (from, input) in [(&other, &sky), (&folder.name("include.pbrt"), &folder.name("inner.inc"))] {
        let before = fs::read(input).expect("it is there");
        assert!(complaint(&["convert", from, input, &new]).contains("it is the same file as the input"), "{input}");
        assert!(complaint(&["convert", from, &new, input]).contains("it is the same file as the input"), "{input}");
        assert!(fs::read(input).is_ok_and(|after| after == before) && !folder.file("new.txt").exists());
    }
    for text in [
        "Material \"conductor\" \"float roughness\" 1e308 \"bool remaproughness\" false",
        "Film \"rgb\" \"integer xresolution\" 99999999999 Shape \"sphere\"",
    ] {
        folder.write("far.pbrt", text);
        let message = complaint(&["convert", &folder.name("far.pbrt"), &new, &scene]);
        assert!(message.contains("far.pbrt:1: ") && !folder.file("new.txt").exists(), "{message}");
    }
    // A sky of one pixel has its colour.
    folder.write("one.ppm", "P3 1 1 255 255 255 255");
    folder.write("one.pbrt", "LightSource \"infinite\" \"string filename\" \"one.ppm\"");
    let sky = "<scene><emitter type='envmap'><string name='filename' value='one.ppm'/></emitter></scene>";
    folder.write("one.xml", sky);
    for from in ["one.pbrt", "one.xml"] {
        printed(&["convert", &folder.name(from), &folder.name("one.c"), &folder.name("one.s")]);
        let config = Config::read(&folder.file("one.c")).expect("it is valid");
        let sky = [config.background_dark_color, config.background_light_color];
        assert_eq!(sky.map(|color| color.to_array()), [[1.0; 3]; 2], "{from}");
    }
    // The first output is not changed if the second one cannot be written.
    assert!(complaint(&["convert", &other, &new, "/dev/full"]).contains("/dev/full"));
    assert!(!folder.file("new.txt").exists());
}
