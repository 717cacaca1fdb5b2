//! Generates scenes from a seed. Equal options give equal scenes, on every machine and in every version.
//!
//! The numbers come from `std::mt19937_64` (through [`cpu::internals::sampling::uniform::Uniform`]). All operations on
//! them are defined exactly by IEEE 754, so the scenes do not depend on a library of elementary functions. All lengths
//! are proportional to [`Options::extent`]. With a larger number of objects, the first shapes do not change, except on
//! a [grid](Arrangement::Grid). [`write`](mod@write) converts scenes and configurations to text.

mod arrange;
pub mod cameras;
mod draws;
pub mod write;

use cpu::internals::input::scene::{MaterialId, Object};
use cpu::{Config, Material, Scene, Vec3};

pub use draws::Draws;

/// Number of random materials in every scene. The options set the probability of each kind of material.
const PALETTE: usize = 24;

/// The material of the ground of a grid: a warm grey.
const GROUND: Material = Material::Matte { reflectance: Vec3::new(0.5, 0.47, 0.42) };

/// The way in which the objects are placed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
pub enum Arrangement {
    /// Anywhere in the cube
    ///
    /// The sizes are from 3 % to 20 % of the extent.
    #[default]
    Scattered,
    /// On a ground, one on each square of a board
    ///
    /// The ground is the first object.
    Grid,
    /// Where arithmetic is hard: copies, touching and nested objects, the huge beside the tiny
    Degenerate,
}

/// Options of the generator. They determine the scene completely.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// Seed of all random numbers.
    pub seed: u64,
    /// Number of objects.
    pub objects: usize,
    /// Share of cylinders among the objects, from 0 to 1. All other objects are spheres.
    pub cylinders: f64,
    /// Weights of the three kinds of materials: matte, metal, refractive.
    pub materials: [f64; 3],
    /// Half the side of the cube that contains the objects' centres, in scene units.
    pub extent: f64,
    /// The way in which the objects are placed.
    pub arrangement: Arrangement,
}

impl Default for Options {
    fn default() -> Self {
        let arrangement = Arrangement::default();
        Self { seed: 1, objects: 100, cylinders: 0.5, materials: [2.0, 1.0, 1.0], extent: 10.0, arrangement }
    }
}

/// Returns the scene that `options` describe. A scene without objects has materials too.
///
/// ```
/// use generator::{Options, scene};
///
/// let options = Options { objects: 7, ..Options::default() };
/// assert_eq!(scene(&options).objects.len(), 7);
/// assert_eq!(scene(&options), scene(&options));
/// ```
#[must_use]
pub fn scene(options: &Options) -> Scene {
    let mut draws = Draws::new(options.seed);
    let mut materials: Vec<_> = (0..PALETTE).map(|_| material(&mut draws, options.materials)).collect();
    let shapes = arrange::shapes(&mut draws, options);
    let mut objects: Vec<_> =
        shapes.into_iter().map(|shape| Object { shape, material: draws.index(PALETTE) as MaterialId }).collect();
    if let (Arrangement::Grid, Some(ground)) = (options.arrangement, objects.first_mut()) {
        ground.material = materials.len() as MaterialId;
        materials.push(GROUND);
    }
    Scene { materials, objects }
}

/// Returns a configuration that shows the scene described by `options` in a small picture.
#[must_use]
pub fn view(options: &Options) -> Config {
    let [position, target] = match options.arrangement {
        Arrangement::Grid => {
            // The camera is 2.6 squares before the near edge, and 3.2 squares above the ground. So the nearest objects
            // appear equally large for every size of the board.
            let square = 2.0 / arrange::squares_a_side(options.objects) as f64;
            [[0.7 * square, 3.2 * square, -1.0 - 2.6 * square], [0.0, 0.0, -1.0 + 2.8 * square]]
        }
        _ => [[1.2, 0.9, -2.2], [0.0; 3]],
    };
    let place = |point: [f64; 3]| Vec3::from(point.map(|component| draws::round(component * options.extent)));
    Config {
        image_width: 400,
        camera_position: place(position),
        camera_target: place(target),
        field_of_view: 50.0,
        samples_per_pixel: 8,
        max_depth: 8,
        background_dark_color: Vec3::new(0.25, 0.45, 0.85),
        background_light_color: Vec3::new(1.0, 0.92, 0.82),
        ..Config::default()
    }
}

fn material(draws: &mut Draws, weights: [f64; 3]) -> Material {
    let [matte, metal, refractive] = weights;
    let kind = draws.between(0.0, matte + metal + refractive);
    if kind < matte {
        Material::Matte { reflectance: draws.color(0.05) }
    } else if kind < matte + metal {
        let reflectance = draws.color(0.5);
        // Half of the metals are perfect mirrors.
        let diffusion = if draws.chance(0.5) { 0.0 } else { draws::round(draws.between(0.0, 0.6)) };
        Material::Metal { reflectance, diffusion }
    } else {
        Material::Refractive { index: draws::round(draws.between(0.6, 2.4)) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ARRANGEMENTS: [Arrangement; 3] = [Arrangement::Scattered, Arrangement::Grid, Arrangement::Degenerate];

    #[test]
    fn there_are_as_many_objects_as_asked_for() {
        for arrangement in ARRANGEMENTS {
            for objects in [0, 1, 2, 100, 1000] {
                let scene = scene(&Options { objects, arrangement, ..Options::default() });
                assert_eq!(scene.objects.len(), objects);
                assert!(scene.materials.len() >= PALETTE);
            }
        }
    }

    #[test]
    fn another_seed_gives_another_scene() {
        let first = scene(&Options::default());
        assert_eq!(first, scene(&Options::default()));
        assert_ne!(first, scene(&Options { seed: 2, ..Options::default() }));
    }

    #[test]
    fn a_smaller_scene_is_the_start_of_a_larger_one() {
        for arrangement in [Arrangement::Scattered, Arrangement::Degenerate] {
            let options = |objects| Options { objects, arrangement, ..Options::default() };
            let shapes = |objects| scene(&options(objects)).objects.into_iter().map(|object| object.shape);
            assert!(shapes(20).eq(shapes(50).take(20)));
        }
    }

    #[test]
    fn every_view_is_a_picture_and_every_scene_a_valid_file() {
        for arrangement in ARRANGEMENTS {
            for extent in [1e-4, 1.0, 1e5] {
                let options = Options { arrangement, extent, ..Options::default() };
                let config = view(&options);
                let size = config.image_size().expect("the picture is small");
                assert!(cpu::internals::geometry::camera::Camera::new(&config, size).is_ok());
                let text = write::scene(&scene(&options));
                assert_eq!(Scene::parse(text.as_bytes()).ok(), Some(scene(&options)), "{options:?}");
            }
        }
    }
}
