//! Tests of the facts about a scene.

use super::*;
use generator::{Arrangement, Options, scene};

fn inspect(scene: &Scene) -> Inspection {
    Inspection::of(&Config::default(), scene).expect("the default picture is fine")
}

#[test]
fn a_small_scene_is_told_in_full() {
    let text = "matte: a 1 1 1\nmetal: b 1 1 1 0\nsphere: 0 0 0 1 a\nsphere: 3 0 0 1 a\n";
    let inspection = inspect(&Scene::parse(text.as_bytes()).expect("it is valid"));
    assert_eq!((inspection.spheres, inspection.cylinders), (2, 0));
    assert_eq!((inspection.materials, inspection.unused_materials), (2, 1));
    assert_eq!(inspection.objects_by_material, BTreeMap::from([("matte", 2)]));
    assert_eq!(inspection.reach, 10.0, "the camera's distance");
    let high = inspection.highest_corner.expect("there are objects");
    assert!((high[0] - 4.0).abs() < 1e-4, "{high:?}");
}

#[test]
fn an_empty_scene_has_no_surfaces() {
    let inspection = inspect(&Scene::default());
    assert_eq!((inspection.lowest_corner, inspection.spheres), (None, 0));
    assert!(inspection.to_string().contains("surfaces    none"));
}

#[test]
fn a_tree_holds_every_object_once() {
    let options = Options { objects: 3000, arrangement: Arrangement::Grid, ..Options::default() };
    let Structure::Bvh(tree) = inspect(&scene(&options)).structure else { panic!("many objects need a BVH") };
    // With at most 16 children a node, 3000 objects need at least 200 nodes.
    assert!((200..3000).contains(&tree.nodes), "{tree:?}");
    assert!(tree.children_per_node > 1.0 && tree.children_per_node <= 16.0, "{tree:?}");
    // The boxes of the root's children cover all objects, so the sum of their surface areas is about that of the root's
    // box, or larger. Rounding in f32 may make the quotient slightly less than 1.
    assert!(tree.boxes_hit_by_a_line > 0.99, "{tree:?}");
}

#[test]
fn the_dominant_sphere_is_not_counted_in_the_tree() {
    let mut text = "matte: m 1 1 1\n".to_owned();
    for at in 0..300 {
        text += &format!("sphere: {} 0 {} .3 m\n", at % 20, at / 20);
    }
    let nodes = |text: &str| match inspect(&Scene::parse(text.as_bytes()).expect("the scene is valid")).structure {
        Structure::Bvh(tree) => tree.nodes,
        structure => panic!("{structure:?}"),
    };
    let alone = nodes(&text);
    text += "sphere: 0 -1001 0 1000 m\n";
    assert_eq!(nodes(&text), alone);
}
