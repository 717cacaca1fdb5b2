//! Tests with giants: floors, rooms and distant objects that are far larger than all others. The renderer must give the
//! reference's bytes, and the bits of its means.

use std::cell::Cell;

use cpu::internals::accel::choice::Accel;
use cpu::internals::input::scene::{Cylinder, Object, Shape, Sphere};
use cpu::internals::{Prepared, input::config::Config};
use cpu::{Aos, Scatter, Scene, Vec3};
use generator::{Arrangement, Draws, Options};
use proptest::prelude::*;

use crate::odd_scenes::cube;
use crate::runner::check_scenes;

/// Returns a giant that is a floor, a room around everything, or an object at a distance.
fn giant(draws: &mut Draws) -> Shape {
    let radius = draws.decades(2.0, 14.0);
    let (up, aside) = (Vec3::new(0.0, 1.0, 0.0), cube(draws).unit() * (radius * draws.between(0.5, 3.0)));
    match draws.index(5) {
        0 => Shape::Sphere(Sphere { center: up * (-2.0 - radius), radius }),
        1 => Shape::Cylinder(Cylinder { center: up * -2.5, radius, axis: up }),
        2 => Shape::Sphere(Sphere { center: cube(draws) * (radius * 0.4), radius }),
        3 => Shape::Sphere(Sphere { center: aside, radius: radius * draws.decades(-1.0, 0.0) }),
        _ => Shape::Cylinder(Cylinder { center: aside, radius, axis: cube(draws) * radius }),
    }
}

fn scene_and_config(seed: u64, count: usize) -> (Scene, Config) {
    let (mut draws, arrangement) = (Draws::new(seed), Arrangement::Scattered);
    let materials = [1.0, 1.0, 1.0];
    let options = Options { seed, objects: count, cylinders: 0.3, materials, extent: 2.0, arrangement };
    let mut scene = generator::scene(&options);
    for _ in 0..=draws.index(3) {
        let material = draws.index(scene.materials.len()) as u32;
        scene.objects.push(Object { shape: giant(&mut draws), material });
    }
    // Every fourth camera is far away, where it may be inside a giant or near its surface.
    let distance = if draws.index(4) == 0 { draws.decades(1.0, 9.0) } else { 5.0 };
    let camera_position = cube(&mut draws) * distance;
    let config = Config { image_width: 16, camera_position, field_of_view: 70.0, max_depth: 6, ..Config::default() };
    (scene, config)
}

#[test]
fn scenes_with_giants_give_the_references_bytes_and_means() {
    let in_trees = Cell::new(0);
    let objects = prop_oneof![1 => 1..=8_usize, 2 => 9..=64_usize, 2 => 65..=200_usize];
    let moderate = check_scenes(120, objects, |seed, count| {
        let (scene, config) = scene_and_config(seed, count);
        let prepared = Prepared::<Aos>::new(&config, &scene, Scatter::Statement).expect("the camera has a window");
        let is_tree = matches!(prepared.accel, Accel::Bvh(_)) && prepared.moderate;
        in_trees.set(in_trees.get() + u32::from(is_tree));
        (scene, config)
    });
    assert!(moderate > 0.5 && in_trees.get() > 40, "{} scenes have a tree", in_trees.get());
}
