//! The real renderer: pixels row by row, samples in order, each followed by a loop.

mod nearest;
mod path;

use crate::config::Config;
use crate::error::Error;
use crate::image::{Image, Rgb};
use crate::layout::Layout;
use crate::prepare::Prepared;
use crate::rng::Uniform;
use crate::scatter::Scatter;
use crate::scene::Scene;
use crate::vec3::Vec3;

/// Renders `scene` as `config` asks, in the layout `L`.
///
/// # Errors
/// [`Error::Picture`] when the configuration makes no picture, [`Error::OutOfMemory`] when it does not fit.
pub fn render<L: Layout>(config: &Config, scene: &Scene, scatter: Scatter) -> Result<L::Image, Error> {
    let prepared = Prepared::<L>::new(config, scene, scatter)?;
    let mut image = L::Image::black(prepared.size)?;
    render_linear(&prepared, |index, mean| {
        let [red, green, blue] = mean.to_array().map(|channel| prepared.quantizer.quantize(channel));
        image.set_pixel(index, Rgb { red, green, blue });
    });
    Ok(image)
}

/// Hands every pixel's mean to `pixel` with its index.
fn render_linear<L: Layout>(prepared: &Prepared<L>, mut pixel: impl FnMut(usize, Vec3)) {
    let mut offsets = Uniform::new(prepared.ray_seed);
    let mut path = path::Path::new(prepared);
    let deterministic = prepared.scatter == Scatter::Deterministic;
    for row in 0..prepared.size.height() {
        for column in 0..prepared.size.width() {
            let mut sum = Vec3::ZERO;
            for _ in 0..prepared.samples {
                let offset = if deterministic { [0.0; 2] } else { [(); 2].map(|()| offsets.draw(-0.5, 0.5)) };
                sum = sum + path.color(prepared.camera.ray(row as f64, column as f64, offset));
            }
            pixel(row * prepared.size.width() + column, sum / prepared.samples as f64);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::layout::{Aos, Soa};
    use crate::reference;

    const SCENE: &str = "matte: grey .5 .6 .7\nmetal: mirror .9 .8 .7 .1\nrefractive: glass 1.5\n\
        sphere: 0 -101 0 100 grey\nsphere: 0 0 0 1 glass\nsphere: 2 0 1 1 mirror\ncylinder: -2 0 1 .5 0 1 1 grey\n\
        cylinder: 0 1 -2 .3 1 0 0 glass\n";

    fn agrees_with_the_reference<L: Layout>(config: &str, scene: &str) {
        let config = Config::parse(config.as_bytes()).expect("the configuration is valid");
        let scene = Scene::parse(scene.as_bytes()).expect("the scene is valid");
        for scatter in [Scatter::Statement, Scatter::Published, Scatter::Deterministic] {
            let actual = render::<L>(&config, &scene, scatter).expect("it renders");
            let expected: L::Image = reference::render(&config, &scene, scatter).expect("it renders");
            for index in 0..expected.size().pixels() {
                assert_eq!(actual.pixel(index), expected.pixel(index), "pixel {index}, {scatter:?}");
            }
        }
    }

    #[test]
    fn every_material_gives_the_references_bytes() {
        let config = "image_width: 40\ncamera_position: 0 1 -6\nsamples_per_pixel: 4\nmax_depth: 12\n";
        agrees_with_the_reference::<Aos>(config, SCENE);
        agrees_with_the_reference::<Soa>(config, SCENE);
    }

    #[test]
    fn the_smallest_cases_render() {
        for config in ["image_width: 1\naspect_ratio: 1 1\nsamples_per_pixel: 1\nmax_depth: 1\n", "image_width: 3\n"] {
            agrees_with_the_reference::<Aos>(config, "");
            agrees_with_the_reference::<Soa>(config, SCENE);
        }
    }
}
