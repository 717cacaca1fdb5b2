//! Tests that the committed scenes contain what their names say, and that the generated ones are equal to the output of
//! the generator.

use std::collections::BTreeSet;
use std::fs;

use cpu::internals::input::scene::{Object, Shape};
use cpu::{Config, Material, Scene};
use generator::{self, Arrangement, Options};

/// Names of the folders in `scenes`.
const NAMES: [&str; 6] = ["cylinders", "grid", "listings", "materials", "spheres", "ten-thousand"];

fn text(scene: &str, file: &str) -> String {
    let path = test_support::project_root().join("scenes").join(scene).join(file);
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

fn scene(name: &str) -> Scene {
    Scene::parse(text(name, "scene.txt").as_bytes()).expect("committed scenes are valid")
}

#[test]
fn every_committed_scene_is_listed_and_makes_a_picture() {
    let folder = test_support::project_root().join("scenes");
    let entries = fs::read_dir(folder).expect("the folder is there").map(|entry| entry.expect("it is readable"));
    let folders = entries.filter(|entry| entry.path().is_dir());
    let found: BTreeSet<_> = folders.map(|entry| entry.file_name().to_string_lossy().into_owned()).collect();
    assert_eq!(found, NAMES.map(str::to_owned).into());
    for name in NAMES {
        let config = Config::parse(text(name, "config.txt").as_bytes()).expect("committed configurations are valid");
        assert!(config.check_picture().is_ok() && !scene(name).objects.is_empty(), "{name}");
    }
}

#[test]
fn scenes_have_the_kinds_and_materials_of_their_names() {
    let is_sphere = |object: &Object| matches!(object.shape, Shape::Sphere(_));
    assert!(scene("spheres").objects.iter().all(is_sphere) && !scene("cylinders").objects.iter().any(is_sphere));
    let scene = scene("materials");
    let used: Vec<Material> = scene.objects.iter().map(|object| scene.materials[object.material as usize]).collect();
    assert!(scene.materials.iter().all(|material| used.contains(material)));
    let has = |is: fn(&Material) -> bool| used.iter().any(is);
    assert!(has(|it| matches!(it, Material::Matte { .. })) && has(|it| matches!(it, Material::Metal { .. })));
    let refractive = used.iter().filter(|material| matches!(material, Material::Refractive { .. })).count();
    assert!(refractive >= 4, "glass in glass, and air in glass");
}

/// `CONTRIBUTING.md` has the commands that write these two scenes.
#[test]
fn generated_scenes_are_what_the_generator_makes() {
    let grid = Options { arrangement: Arrangement::Grid, materials: [3.0, 2.0, 1.0], ..Options::default() };
    let ten_thousand = Options { seed: 2, objects: 10_000, extent: 100.0, ..grid.clone() };
    for (name, options) in [("grid", Options { seed: 4, objects: 101, ..grid }), ("ten-thousand", ten_thousand)] {
        let (made, view) = (generator::scene(&options), generator::view(&options));
        assert_eq!(made.objects.len(), options.objects);
        assert!(text(name, "scene.txt") == generator::write::scene(&made), "scenes/{name}/scene.txt");
        assert!(text(name, "config.txt") == generator::write::config(&view), "scenes/{name}/config.txt");
    }
}
