//! Tests of the quantities and of the paths behind them.

use super::*;
use crate::engine;
use cpu::{Aos, Config, Scene};

fn prepared(config: &Config, scene: &Scene) -> Prepared<Aos> {
    Prepared::new(config, scene, Scatter::Statement).expect("it is small")
}

#[test]
fn paths_have_the_colours_of_the_renderer() {
    for (objects, max_depth) in [(3, 5), (20, 1), (20, 9), (200, 5)] {
        let config = Config { image_width: 24, samples_per_pixel: 3, max_depth, ..Config::default() };
        let scene = generator::scene(&generator::Options { objects, ..Default::default() });
        let prepared = prepared(&config, &scene);
        let mut tracer = Tracer::new(&prepared);
        for (index, mean) in engine::means(&config, &scene).expect("it is small").into_iter().enumerate() {
            let (row, column) = (index / 24, index % 24);
            let mut sum = Vec3::ZERO;
            for _ in 0..3 {
                let offset = [0.0; 2].map(|_: f64| tracer.jitter.draw(-0.5, 0.5));
                let ray = prepared.camera.ray(row as f64, column as f64, offset);
                sum = sum + tracer.color(ray).expect("it is small");
            }
            assert_eq!(sum / 3.0, mean, "{objects} objects, depth {max_depth}, pixel {index}");
        }
    }
}

#[test]
fn quantities_are_those_of_a_scene_known_by_hand() {
    let text = "matte: a 1 1 1\nmetal: b 1 1 1 0\nsphere: 0 0 9 1 a\ncylinder: 0 0 0 1 0 0 4 b\n";
    let scene = Scene::parse(text.as_bytes()).expect("it is valid");
    let text = "image_width: 3\naspect_ratio: 3 1\ncamera_position: 0 0 -10\nsamples_per_pixel: 4\n";
    let config = Config::parse(text.as_bytes()).expect("it is valid");
    // The middle ray hits the lower cap of the cylinder at z = -2. The camera looks from z = -10 to the origin.
    let expected: [(_, &[f32]); 8] = [
        (Quantity::Depth, &[8.0]),
        (Quantity::Lambda, &[0.8]),
        (Quantity::Normal, &[0.0, 0.0, -1.0]),
        (Quantity::Object, &[1.0]),
        (Quantity::Material, &[1.0]),
        (Quantity::Part, &[3.0]),
        (Quantity::Samples, &[4.0]),
        (Quantity::Cost, &[4.0, 0.0]),
    ];
    for (quantity, values) in expected {
        let floats = show(quantity, &prepared(&config, &scene), |_| ControlFlow::Continue(()));
        let floats = floats.expect("it is small").expect("it goes on");
        let middle = &floats.values[quantity.channels()..];
        // Only a few samples of the wide pixel hit, so the cost of the left pixel is compared: one ray a sample.
        let start = if quantity == Quantity::Cost { &floats.values } else { middle };
        assert_eq!(&start[..values.len()], values, "{quantity:?}");
        let is_of_a_hit = !matches!(quantity, Quantity::Samples | Quantity::Cost);
        assert!(floats.values[0].is_nan() == is_of_a_hit, "{quantity:?}: the left pixel hits nothing");
    }
    let floats = show(Quantity::Variance, &prepared(&config, &scene), |_| ControlFlow::Continue(()));
    let floats = floats.expect("it is small").expect("it goes on");
    assert!(floats.values.iter().all(|&variance| (0.0..0.25).contains(&variance)), "{floats:?}");
}
