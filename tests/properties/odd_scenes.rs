//! Tests with scenes of extreme magnitudes: the renderer must give the reference's bytes, and the bits of its means.
//!
//! Radii, heights, indices of refraction, diffusions and distances are random over many decades, so that their products
//! come near the limits of f32 and f64. The camera is often inside a large glass cylinder, because refraction at its
//! side gives a direction whose length is about the square of the radius.

use cpu::internals::input::config::Config;
use cpu::internals::input::scene::{Cylinder, MaterialId, Object, Shape, Sphere};
use cpu::{Material, Scatter, Scene, Vec3};
use generator::Draws;
use proptest::prelude::*;

use crate::runner::{agreed, check_scenes};

fn material(draws: &mut Draws) -> Material {
    let reflectance = Vec3::new(draws.between(0.2, 1.0), draws.between(0.2, 1.0), draws.between(0.2, 1.0));
    match draws.index(3) {
        0 => Material::Matte { reflectance },
        1 => Material::Metal { reflectance, diffusion: [0.0, draws.decades(-3.0, 9.0)][draws.index(2)] },
        _ => Material::Refractive { index: [1.5, draws.decades(-12.0, 12.0)][draws.index(2)] },
    }
}

pub fn cube(draws: &mut Draws) -> Vec3 {
    Vec3::from([(); 3].map(|()| draws.between(-1.0, 1.0)))
}

/// Returns a random length for a cylinder's axis. In seven of eight cases it is between `size` / 10,000 and 10 `size`.
/// Otherwise its square underflows or nearly underflows.
fn height(draws: &mut Draws, size: f64) -> f64 {
    match draws.index(8) {
        0 => draws.decades(-161.0, -140.0),
        _ => size * draws.decades(-4.0, 1.0),
    }
}

fn scene_and_config(seed: u64, objects: usize) -> (Scene, Config) {
    let mut draws = Draws::new(seed);
    // Some scenes are so large or so small that the renderer intersects every object, without an acceleration
    // structure.
    let size = draws.decades(-8.0, 10.0);
    let materials: Vec<_> = (0..12).map(|_| material(&mut draws)).collect();
    let mut shapes = Vec::new();
    if draws.index(2) == 0 {
        // A cylinder around the camera. In half of the cases the square of its radius is about the distance to the
        // other objects, or larger.
        let radius = [size * draws.decades(-4.0, 0.0), (size * draws.decades(0.0, 4.0)).sqrt()][draws.index(2)];
        let axis = cube(&mut draws) * size;
        shapes.push(Shape::Cylinder(Cylinder { center: Vec3::ZERO, radius, axis }));
    }
    while shapes.len() < objects {
        let (center, radius) = (cube(&mut draws) * (2.0 * size), size * draws.decades(-4.0, -0.2));
        shapes.push(if draws.index(2) == 0 {
            Shape::Sphere(Sphere { center, radius })
        } else {
            let axis = cube(&mut draws).unit() * height(&mut draws, size);
            Shape::Cylinder(Cylinder { center, radius, axis })
        });
    }
    let shapes = shapes.into_iter().take(objects);
    let mut objects: Vec<_> =
        shapes.map(|shape| Object { shape, material: draws.index(materials.len()) as MaterialId }).collect();
    let glass = materials.iter().position(|material| matches!(material, Material::Refractive { .. }));
    if let (Some(first), Some(glass)) = (objects.first_mut(), glass) {
        first.material = glass as MaterialId;
    }
    let config = Config {
        image_width: 1 + draws.index(7) as u64,
        aspect_ratio: [1, 1],
        camera_position: cube(&mut draws) * (size * draws.decades(-6.0, 0.3)),
        camera_target: cube(&mut draws) * (size * draws.decades(-3.0, 0.3)),
        camera_north: cube(&mut draws),
        field_of_view: draws.between(1.0, 170.0),
        samples_per_pixel: 1 + draws.index(3) as u64,
        max_depth: 1 + draws.index(12) as u64,
        material_rng_seed: seed | 1,
        ..Config::default()
    };
    (Scene { materials, objects }, config)
}

/// Renders a scene that was once rendered wrongly with fused multiply-add. Nine objects are far away around the camera.
/// The camera is inside a glass cylinder, so rays leave the glass with directions of length 10^11.
#[test]
fn long_directions_out_of_glass_meet_what_is_far_away() {
    let config = "image_width: 8\naspect_ratio: 1 1\nsamples_per_pixel: 1\nfield_of_view: 60\n\
                  camera_position: 0 0 0\ncamera_target: 0 0 1\n";
    for (radius, index) in [(4e5, 1.5), (300.0, 1e6)] {
        for (kind, size) in [("sphere", "1.5e8"), ("cylinder", "1.5e8 0 3e8 0")] {
            let glass = format!("refractive: g {index}\ncylinder: 0 0 0 {radius} 0 {} 0 g\n", 10.0 * radius);
            let others = (0..9).map(|number| {
                let (sine, cosine) = (f64::from(number) * 40.0).to_radians().sin_cos();
                format!("{kind}: {} 0 {} {size} m\n", 5e8 * cosine, 5e8 * sine)
            });
            let scene = format!("matte: m .8 .2 .1\n{glass}{}", others.collect::<String>());
            agreed(config, &scene, Scatter::Statement);
        }
    }
}

#[test]
fn scenes_of_odd_magnitudes_give_the_references_bytes_and_means() {
    let objects = prop_oneof![1 => 1..=8_usize, 2 => 9..=64_usize, 1 => 65..=140_usize];
    check_scenes(300, objects, scene_and_config);
}
