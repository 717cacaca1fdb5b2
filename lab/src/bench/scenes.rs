//! The scenes of the folder `scenes` that are measured. The program contains their texts, so it needs no checkout.

use cpu::{Config, Scene};

/// Names of the scenes whose error is measured, with the texts of their two files.
const SCENES: [(&str, [&str; 2]); 3] = [
    (
        "materials",
        [include_str!("../../../scenes/materials/config.txt"), include_str!("../../../scenes/materials/scene.txt")],
    ),
    ("grid", [include_str!("../../../scenes/grid/config.txt"), include_str!("../../../scenes/grid/scene.txt")]),
    (
        "spheres",
        [include_str!("../../../scenes/spheres/config.txt"), include_str!("../../../scenes/spheres/scene.txt")],
    ),
];

/// Names of the scenes.
pub const NAMES: [&str; 3] = [SCENES[0].0, SCENES[1].0, SCENES[2].0];

/// Returns the scene with this name, or `None` if no scene has it.
pub fn named(name: &str) -> Option<(Config, Scene)> {
    let (_, [config, scene]) = SCENES.iter().find(|(scene, _)| *scene == name)?;
    let valid = "the tests read all scenes";
    Some((Config::parse(config.as_bytes()).expect(valid), Scene::parse(scene.as_bytes()).expect(valid)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_scene_is_valid_and_others_have_no_name() {
        for name in NAMES {
            let (config, scene) = named(name).expect("it is listed");
            assert!(config.image_size().is_ok() && scene.objects.len() > 2, "{name}");
        }
        assert!(named("case-1").is_none() && named("../materials").is_none());
    }
}
