//! Tests with scenes in which many surfaces are nearly or exactly at the same lambda: the renderer must give the
//! reference's bytes, and the bits of its means.

use cpu::internals::input::config::Config;
use cpu::internals::input::scene::{Cylinder, Object, Shape, Sphere};
use cpu::{Material, Scene, Vec3};
use generator::Draws;
use proptest::prelude::*;

use crate::odd_scenes::cube;
use crate::runner::check_scenes;

/// Returns a shape of which some surface nearly coincides with one of `shape`.
fn near(draws: &mut Draws, shape: &Shape) -> Shape {
    let gap = 1.0 - draws.decades(-16.0, -4.0);
    match *shape {
        shape if draws.index(4) == 0 => shape,
        Shape::Sphere(Sphere { center, radius }) => {
            // A shell that is concentric, or touches the sphere, or a sphere beside it that touches it.
            let aside = cube(draws).unit();
            let (away, radius) =
                [(0.0, radius * gap), (radius * (1.0 - gap), radius * gap), (radius * 1.5, radius / 2.0)]
                    [draws.index(3)];
            Shape::Sphere(Sphere { center: center + aside * away, radius })
        }
        Shape::Cylinder(Cylinder { center, radius, axis }) => {
            // A cylinder around the same axis. Its side or one of its caps is that of the cylinder.
            let share = draws.between(0.2, 1.5);
            let (moved, radius) =
                [((1.0 - share) / 2.0, radius * gap), ((share - 1.0) / 2.0, radius * 0.8), (0.3, radius)]
                    [draws.index(3)];
            let turned = if draws.index(2) == 0 { 1.0 } else { -1.0 };
            Shape::Cylinder(Cylinder { center: center + axis * moved, radius, axis: axis * (share * turned) })
        }
    }
}

fn scene_and_config(seed: u64, count: usize) -> (Scene, Config) {
    let mut draws = Draws::new(seed);
    let mut shapes: Vec<Shape> = Vec::new();
    while shapes.len() < count {
        let shape = match draws.index(4) {
            0 if shapes.len() < 1 + count / 4 => {
                Shape::Sphere(Sphere { center: cube(&mut draws) * 3.0, radius: draws.between(0.3, 1.5) })
            }
            1 if shapes.len() < 1 + count / 4 => {
                let up = if draws.index(2) == 0 { Vec3::new(0.0, 1.0, 0.0) } else { cube(&mut draws).unit() };
                let (radius, axis) = (draws.between(0.3, 1.5), up * draws.between(0.2, 3.0));
                Shape::Cylinder(Cylinder { center: cube(&mut draws) * 3.0, radius, axis })
            }
            _ => match shapes.len() {
                0 => continue,
                earlier => {
                    let shape = shapes[draws.index(earlier)];
                    near(&mut draws, &shape)
                }
            },
        };
        shapes.push(shape);
    }
    let materials = (0..6).map(|at| {
        let reflectance = Vec3::from([0, 1, 2].map(|channel| if at % 3 == channel { 0.9 } else { 0.2 }));
        match draws.index(4) {
            0 => Material::Refractive { index: 1.5 },
            1 => Material::Metal { reflectance, diffusion: 0.3 },
            _ => Material::Matte { reflectance },
        }
    });
    let materials: Vec<_> = materials.collect();
    let objects = shapes.into_iter().map(|shape| Object { shape, material: draws.index(6) as u32 }).collect();
    let distance = draws.decades(0.5, 6.0);
    let config = Config {
        image_width: 2 + draws.index(7) as u64,
        aspect_ratio: [1, 1],
        camera_position: cube(&mut draws).unit() * distance,
        camera_target: Vec3::ZERO,
        field_of_view: (400.0 / distance).min(60.0),
        samples_per_pixel: 1 + draws.index(3) as u64,
        max_depth: 1 + draws.index(6) as u64,
        material_rng_seed: seed | 1,
        ..Config::default()
    };
    (Scene { materials, objects }, config)
}

#[test]
fn scenes_of_many_near_surfaces_give_the_references_bytes_and_means() {
    let objects = prop_oneof![2 => 2..=8_usize, 2 => 9..=64_usize, 1 => 65..=300_usize];
    check_scenes(200, objects, scene_and_config);
}
