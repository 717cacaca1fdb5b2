//! Tests with scenes of extreme magnitudes: the renderer must give the reference's bytes, and the bits of its means.
//!
//! Radii, heights, indices of refraction, diffusions and distances are random over many decades, so that their products
//! come near the limits of f32 and f64. The camera is often inside a large glass cylinder, because refraction at its
//! side gives a direction whose length is about the square of the radius.

use std::cell::Cell;

use cpu::internals::input::config::Config;
use cpu::internals::input::scene::{Cylinder, MaterialId, Object, Shape, Sphere};
use cpu::internals::sampling::uniform::Uniform;
use cpu::{Material, Scatter, Scene, Vec3};
use proptest::prelude::*;
use proptest::test_runner::TestCaseError;
use test_support::agreement::{SCATTERS, equals_reference, reference};

use crate::runner::check;

/// The generator of random numbers for one scene.
struct Draws(Uniform);

impl Draws {
    fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0.draw(low, high)
    }
    /// Returns `10^k`, in which `k` is uniform from `low` to `high`.
    fn decades(&mut self, low: f64, high: f64) -> f64 {
        10.0_f64.powf(self.between(low, high))
    }
    fn below(&mut self, count: usize) -> usize {
        (self.between(0.0, count as f64) as usize).min(count - 1)
    }
    fn cube(&mut self) -> Vec3 {
        Vec3::from([(); 3].map(|()| self.between(-1.0, 1.0)))
    }
}

fn material(draws: &mut Draws) -> Material {
    let reflectance = Vec3::new(draws.between(0.2, 1.0), draws.between(0.2, 1.0), draws.between(0.2, 1.0));
    match draws.below(3) {
        0 => Material::Matte { reflectance },
        1 => Material::Metal { reflectance, diffusion: [0.0, draws.decades(-3.0, 9.0)][draws.below(2)] },
        _ => Material::Refractive { index: [1.5, draws.decades(-12.0, 12.0)][draws.below(2)] },
    }
}

/// Returns a random length for a cylinder's axis. In seven of eight cases it is between `size` / 10,000 and 10 `size`.
/// Otherwise its square underflows or nearly underflows.
fn height(draws: &mut Draws, size: f64) -> f64 {
    match draws.below(8) {
        0 => draws.decades(-161.0, -140.0),
        _ => size * draws.decades(-4.0, 1.0),
    }
}

fn scene_and_config(seed: u64, objects: usize) -> (Scene, Config) {
    let mut draws = Draws(Uniform::new(seed));
    // Some scenes are so large or so small that the renderer intersects every object, without an acceleration
    // structure.
    let size = draws.decades(-8.0, 10.0);
    let materials: Vec<_> = (0..12).map(|_| material(&mut draws)).collect();
    let mut shapes = Vec::new();
    if draws.below(2) == 0 {
        // A cylinder around the camera. In half of the cases the square of its radius is about the distance to the
        // other objects, or larger.
        let radius = [size * draws.decades(-4.0, 0.0), (size * draws.decades(0.0, 4.0)).sqrt()][draws.below(2)];
        let axis = draws.cube() * size;
        shapes.push(Shape::Cylinder(Cylinder { center: Vec3::ZERO, radius, axis }));
    }
    while shapes.len() < objects {
        let (center, radius) = (draws.cube() * (2.0 * size), size * draws.decades(-4.0, -0.2));
        shapes.push(if draws.below(2) == 0 {
            Shape::Sphere(Sphere { center, radius })
        } else {
            let axis = draws.cube().unit() * height(&mut draws, size);
            Shape::Cylinder(Cylinder { center, radius, axis })
        });
    }
    let shapes = shapes.into_iter().take(objects);
    let mut objects: Vec<_> =
        shapes.map(|shape| Object { shape, material: draws.below(materials.len()) as MaterialId }).collect();
    let glass = materials.iter().position(|material| matches!(material, Material::Refractive { .. }));
    if let (Some(first), Some(glass)) = (objects.first_mut(), glass) {
        first.material = glass as MaterialId;
    }
    let config = Config {
        image_width: 1 + draws.below(7) as u64,
        aspect_ratio: [1, 1],
        camera_position: draws.cube() * (size * draws.decades(-6.0, 0.3)),
        camera_target: draws.cube() * (size * draws.decades(-3.0, 0.3)),
        camera_north: draws.cube(),
        field_of_view: draws.between(1.0, 170.0),
        samples_per_pixel: 1 + draws.below(3) as u64,
        max_depth: 1 + draws.below(12) as u64,
        material_rng_seed: seed | 1,
        ..Config::default()
    };
    (Scene { materials, objects }, config)
}

/// Renders a scene that was once rendered wrongly with fused multiply-add. Nine objects are far away around the camera.
/// The camera is inside a glass cylinder, so rays leave the glass with directions of length 10^11.
#[test]
fn long_directions_out_of_glass_meet_what_is_far_away() {
    let around = |shape: &dyn Fn(Vec3) -> Shape| -> Vec<Object> {
        let place = |index: u32| {
            let angle = (f64::from(index) * 40.0).to_radians();
            Object { shape: shape(Vec3::new(5e8 * angle.cos(), 0.0, 5e8 * angle.sin())), material: 0 }
        };
        (0..9).map(place).collect()
    };
    let sphere = |center| Shape::Sphere(Sphere { center, radius: 1.5e8 });
    let cylinder = |center| Shape::Cylinder(Cylinder { center, radius: 1.5e8, axis: Vec3::new(0.0, 3e8, 0.0) });
    let matte = Material::Matte { reflectance: Vec3::new(0.8, 0.2, 0.1) };
    for (radius, index) in [(4e5, 1.5), (300.0, 1e6)] {
        for others in [around(&sphere), around(&cylinder)] {
            let glass = Cylinder { center: Vec3::ZERO, radius, axis: Vec3::new(0.0, 10.0 * radius, 0.0) };
            let mut objects = vec![Object { shape: Shape::Cylinder(glass), material: 1 }];
            objects.extend(others);
            let scene = Scene { materials: vec![matte, Material::Refractive { index }], objects };
            let config = Config {
                image_width: 8,
                aspect_ratio: [1, 1],
                samples_per_pixel: 1,
                camera_position: Vec3::ZERO,
                camera_target: Vec3::new(0.0, 0.0, 1.0),
                field_of_view: 60.0,
                ..Config::default()
            };
            let picture = equals_reference(&config, &scene, Scatter::Statement);
            assert!(picture.unwrap_or_else(|difference| panic!("{difference}")).is_some(), "the camera has a window");
        }
    }
}

#[test]
fn scenes_of_odd_magnitudes_give_the_references_bytes_and_means() {
    let (rendered, with_objects) = (Cell::new(0), Cell::new(0));
    let objects = prop_oneof![1 => 1..=8_usize, 2 => 9..=64_usize, 1 => 65..=140_usize];
    check(300, (any::<u64>(), objects), |(seed, objects)| {
        let (scene, config) = scene_and_config(seed, objects);
        let scatter = SCATTERS[(seed % 3) as usize];
        let picture = equals_reference(&config, &scene, scatter).map_err(TestCaseError::fail)?;
        // Both renderers refuse a camera without a window, so there is no picture.
        let Some(picture) = picture else { return Ok(()) };
        rendered.set(rendered.get() + 1);
        let background = reference(&config, &Scene::default(), scatter).expect("the camera has a window");
        with_objects.set(with_objects.get() + u32::from(picture.means != background.means));
        Ok(())
    });
    let (rendered, with_objects) = (rendered.get(), with_objects.get());
    println!("{with_objects} of {rendered} pictures show an object");
    assert!(2 * with_objects > rendered, "only {with_objects} of {rendered} pictures show an object");
}
